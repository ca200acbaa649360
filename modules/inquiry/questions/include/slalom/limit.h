// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/evaluate.h>
#include <slalom/inquiry/limit_search.h>

#include <functional>
#include <memory>
#include <vector>

namespace slalom {

/// A family with a value of its parameter, such as passages of a width.
using FamilyAt = std::function<std::shared_ptr<const Generator>(double value)>;

/// The values up to which a method is reliable, with the confidence of the search: find_limit()
/// over the bins between `edges`, from the easy end to the hard one, where each run draws its value
/// uniformly in its bin and a scenario of that family. A value for which the family gives no
/// scenario that is solvable is a failure. `steps[i].bins` of the result are numbers of bins.
/// Throws Error: Usage for fewer than two edges, Job for failures of the machine.
LimitResult limit(const NamedMethod& method, const FamilyAt& family_at,
                  const std::vector<double>& edges, LimitOptions search = {},
                  const Options& options = {});

}  // namespace slalom
