// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace slalom {

/// Assigns indexes to names in order of first occurrence.
class Names {
 public:
  std::size_t index(const std::string& name) {
    const auto [found, is_new] = indexes_.emplace(name, names_.size());
    if (is_new) names_.push_back(name);
    return found->second;
  }
  const std::vector<std::string>& all() const { return names_; }

 private:
  std::map<std::string, std::size_t> indexes_;
  std::vector<std::string> names_;
};

}  // namespace slalom
