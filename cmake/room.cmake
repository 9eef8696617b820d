# oxturn_room(NAME HEADERS ... SOURCES ... USES ... PRIVATE ...): one folder, one static library
# oxturn::NAME, with our compile options, installed and exported.

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
  set_target_properties(oxturn_${name} PROPERTIES EXPORT_NAME ${name})
  target_sources(oxturn_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${ROOM_HEADERS})
  target_compile_features(oxturn_${name} PUBLIC cxx_std_20)
  target_link_libraries(oxturn_${name} PUBLIC ${ROOM_USES} PRIVATE $<BUILD_INTERFACE:oxturn_options> ${ROOM_PRIVATE})
  install(TARGETS oxturn_${name} EXPORT oxturn FILE_SET HEADERS DESTINATION include/oxturn)
endfunction()
