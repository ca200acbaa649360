// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/scenario.h>

#include <algorithm>
#include <string>

namespace slalom {

/// "mover_1" of the prefix "mover_", or the next number that is free: movers and people have no ids
/// in common.
inline std::string free_id(const Scenario& scenario, const std::string& prefix) {
  for (std::size_t number = 1;; ++number) {
    const std::string id = prefix + std::to_string(number);
    const auto has_id = [&id](const auto& other) { return other.id == id; };
    if (std::none_of(scenario.people().begin(), scenario.people().end(), has_id) &&
        std::none_of(scenario.movers().begin(), scenario.movers().end(), has_id))
      return id;
  }
}

}  // namespace slalom
