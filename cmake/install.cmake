# `cmake --install` gives the library, its headers, the program, and a CMake package `oxturn`.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

add_library(oxturn_all INTERFACE)
add_library(oxturn::oxturn ALIAS oxturn_all)
set_target_properties(oxturn_all PROPERTIES EXPORT_NAME oxturn)
target_link_libraries(oxturn_all INTERFACE oxturn::reports oxturn::bench oxturn::metrics oxturn::algorithms oxturn::maps
                      oxturn::geometry oxturn::base)
install(TARGETS oxturn_all EXPORT oxturn)
install(EXPORT oxturn NAMESPACE oxturn:: FILE oxturnTargets.cmake DESTINATION lib/cmake/oxturn)
configure_package_config_file(cmake/oxturnConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/oxturnConfig.cmake
                              INSTALL_DESTINATION lib/cmake/oxturn)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/oxturnConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/oxturnConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/oxturnConfigVersion.cmake
        DESTINATION lib/cmake/oxturn)
