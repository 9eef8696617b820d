# oxturn_folder(NAME HEADERS ... USES ... PRIVATE ...): one folder, one static library oxturn::NAME of every source in
# it (except bench/micro, a program of its own), with our compile options. The headers named are installed;
# cmake/install.cmake makes one shared library of all folders.

# GCC 12 at -O2 warns of uninitialised, overlapping and overrun objects inside std::variant and std::string: its own
# bugs.
add_library(oxturn_options INTERFACE)
target_compile_options(oxturn_options INTERFACE
  -ffp-contract=off -Wall -Wextra -Wshadow -Wpedantic -Wno-maybe-uninitialized -Wno-restrict -Wno-array-bounds
  $<$<BOOL:${OXTURN_WERROR}>:-Werror>)

function(oxturn_folder name)
  cmake_parse_arguments(FOLDER "" "" "HEADERS;USES;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp)
  list(FILTER sources EXCLUDE REGEX "/bench/micro/")
  add_library(oxturn_${name} STATIC ${sources})
  add_library(oxturn::${name} ALIAS oxturn_${name})
  target_include_directories(oxturn_${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_compile_features(oxturn_${name} PUBLIC cxx_std_20)
  target_link_libraries(oxturn_${name} PUBLIC ${FOLDER_USES} PRIVATE oxturn_options ${FOLDER_PRIVATE})
  # No other library replaces our functions at run time (install.cmake), so they may be inlined: a hundredth of all
  # instructions. Clang takes it for granted.
  target_compile_options(oxturn_${name} PRIVATE
    $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-fno-semantic-interposition>)
  list(TRANSFORM FOLDER_HEADERS PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  set_property(GLOBAL APPEND PROPERTY OXTURN_HEADERS ${FOLDER_HEADERS})
  set_property(GLOBAL APPEND PROPERTY OXTURN_FOLDERS oxturn_${name})
  set_property(GLOBAL APPEND PROPERTY OXTURN_LIBRARIES ${FOLDER_PRIVATE})
endfunction()
