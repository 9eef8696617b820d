# Writes OUTPUT, a header with a hash of the public headers named in the file LIST: plug-ins are refused if theirs
# differ. The file is touched only if it changes.
file(STRINGS ${LIST} headers)
set(all "")
foreach(header ${headers})
  file(SHA256 ${header} hash)
  string(APPEND all ${hash})
endforeach()
string(SHA256 hash "${all}")
string(SUBSTRING ${hash} 0 8 hash)
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
#pragma once
#define OXTURN_HEADERS "@hash@"
#define OXTURN_VERSION_TEXT "@VERSION@"
]])
