// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/value.h>

#include <string>
#include <vector>

namespace slalom {

/// The metrics, then the descriptors. No two have the same id.
const std::vector<QuantityInfo>& registered_quantities();

/// Gives a quantity of a file that states neither the kind and range of the registered one with its
/// id; leaves any other as it is.
void add_registered_range(QuantityInfo& info);

}  // namespace slalom
