# oxturn_room(NAME HEADERS ... SOURCES ... USES ... PRIVATE ...): one folder, one static library oxturn::NAME, with our
# compile options. Its headers are installed; cmake/install.cmake makes one shared library of all rooms.

# GCC 12 at -O2 warns of uninitialised, overlapping and overrun objects inside std::variant and std::string: its own
# bugs.
add_library(oxturn_options INTERFACE)
target_compile_options(oxturn_options INTERFACE
  -ffp-contract=off -Wall -Wextra -Wshadow -Wpedantic -Wno-maybe-uninitialized -Wno-restrict -Wno-array-bounds
  $<$<BOOL:${OXTURN_WERROR}>:-Werror>)

function(oxturn_room name)
  cmake_parse_arguments(ROOM "" "" "HEADERS;SOURCES;USES;PRIVATE" ${ARGN})
  add_library(oxturn_${name} STATIC ${ROOM_SOURCES})
  add_library(oxturn::${name} ALIAS oxturn_${name})
  target_include_directories(oxturn_${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_compile_features(oxturn_${name} PUBLIC cxx_std_20)
  target_link_libraries(oxturn_${name} PUBLIC ${ROOM_USES} PRIVATE oxturn_options ${ROOM_PRIVATE})
  list(TRANSFORM ROOM_HEADERS PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  set_property(GLOBAL APPEND PROPERTY OXTURN_HEADERS ${ROOM_HEADERS})
  set_property(GLOBAL APPEND PROPERTY OXTURN_ROOMS oxturn_${name})
  set_property(GLOBAL APPEND PROPERTY OXTURN_LIBRARIES ${ROOM_PRIVATE})
endfunction()
