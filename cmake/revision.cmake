# Writes OUTPUT, a header with the revision of the sources in SOURCE: commit, and a hash of what is not committed. The
# file is touched only if it changes.
execute_process(COMMAND git -C ${SOURCE} rev-parse --short=12 HEAD OUTPUT_VARIABLE commit ERROR_QUIET
                OUTPUT_STRIP_TRAILING_WHITESPACE)
execute_process(COMMAND git -C ${SOURCE} diff HEAD OUTPUT_VARIABLE changes ERROR_QUIET)
if(NOT commit)
  set(commit unknown)
endif()
if(changes)
  string(SHA256 hash "${changes}")
  string(SUBSTRING ${hash} 0 8 hash)
  set(commit "${commit}+${hash}")
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
#pragma once
inline constexpr const char* kRevision = "@commit@";
]])
