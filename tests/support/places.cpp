// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"

namespace slalom {

const char* const kSourceFolder = SLALOM_SOURCE_FOLDER;
const char* const kBuildFolder = SLALOM_BUILD_FOLDER;

}  // namespace slalom
