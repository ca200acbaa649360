// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "database.h"

namespace slalom {

/// The file format of scenario lists (.scenarios). The row of a scenario contains the checksum of
/// its hash, name, representation, generator, seed and tags; that of a value the checksum of the
/// hash, the id, version and parameters of the descriptor, and the value.
extern const DatabaseKind kScenarioList;

}  // namespace slalom
