# The shared library `oxturn` of all folders: the program and plug-ins use the same one, so they share types and
# exceptions. `cmake --install` gives the library, its headers, the program, and a CMake package `oxturn`.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(folders GLOBAL PROPERTY OXTURN_FOLDERS)
get_property(headers GLOBAL PROPERTY OXTURN_HEADERS)
get_property(libraries GLOBAL PROPERTY OXTURN_LIBRARIES)

add_library(oxturn_shared SHARED)
foreach(folder ${folders})
  target_sources(oxturn_shared PRIVATE $<TARGET_OBJECTS:${folder}>)
endforeach()
add_library(oxturn::oxturn ALIAS oxturn_shared)
set_target_properties(oxturn_shared PROPERTIES OUTPUT_NAME oxturn EXPORT_NAME oxturn LINKER_LANGUAGE CXX
                      VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
target_compile_features(oxturn_shared PUBLIC cxx_std_20)
target_include_directories(oxturn_shared INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
  $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated> $<INSTALL_INTERFACE:include> $<INSTALL_INTERFACE:include/oxturn>)
target_link_libraries(oxturn_shared PUBLIC Eigen3::Eigen PRIVATE oxturn_options ${libraries})
# Calls inside the library need no table of addresses, and nobody replaces its functions.
target_link_options(oxturn_shared PRIVATE -Wl,-Bsymbolic-functions)

install(TARGETS oxturn_shared EXPORT oxturn DESTINATION lib)
foreach(header ${headers})
  cmake_path(RELATIVE_PATH header BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE relative)
  cmake_path(GET relative PARENT_PATH folder)
  install(FILES ${header} DESTINATION include/oxturn/${folder})
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/generated/bench/plugin_headers.hpp DESTINATION include/oxturn/bench)
install(EXPORT oxturn NAMESPACE oxturn:: FILE oxturnTargets.cmake DESTINATION lib/cmake/oxturn)
configure_package_config_file(cmake/oxturnConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/oxturnConfig.cmake
                              INSTALL_DESTINATION lib/cmake/oxturn)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/oxturnConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/oxturnConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/oxturnConfigVersion.cmake
        DESTINATION lib/cmake/oxturn)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/plugin-template DESTINATION share/oxturn)
