# SPDX-License-Identifier: BSD-3-Clause
# Writes OUTPUT, a header with a hash of the public headers of ROOT's modules, unless it is the same:
#   cmake -DROOT=... -DOUTPUT=... -P build_id.cmake
file(GLOB_RECURSE headers ${ROOT}/modules/*.h)
list(FILTER headers INCLUDE REGEX /include/)
set(hashes)
foreach(header ${headers})
  file(SHA256 ${header} hash)
  string(APPEND hashes ${hash})
endforeach()
string(SHA256 hash "${hashes}")
set(text "#pragma once\n#define SLALOM_BUILD_ID \"${hash}\"\n")
set(old "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} old)
endif()
if(NOT text STREQUAL old)
  file(WRITE ${OUTPUT} "${text}")
endif()
