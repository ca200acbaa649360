// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The outcome that a word of a foreign table means: Slalom's own words, and those of ROS actions
/// and other benchmarks ("SUCCEEDED", "Goal reached"), in any case and with blanks, "_" or "-"
/// between words. "failure" is one without a known kind. None for other words.
std::optional<std::string> outcome_of_word(const std::string& word);

/// Outcomes that outcome_of_word() can return.
std::vector<std::string> known_outcomes();

}  // namespace slalom
