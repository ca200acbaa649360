// SPDX-License-Identifier: BSD-3-Clause
// The build of a part, compiled into each of them.
#include "slalom_build_id.h"

extern "C" __attribute__((visibility("default"))) const char* slalom_build_id() {
  return SLALOM_BUILD_ID;
}
