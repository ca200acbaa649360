// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// Begins the sentence why no run in a scenario can end in time, which stands in the details of
/// these runs: "nobody can arrive within 60 s: the shortest path takes 103.1 s at 0.26 m/s".
constexpr char kLackOfTime[] = "nobody can arrive within ";

/// The sentence in the details of a run, or "".
std::string lack_of_time_in(const char* outcome_detail);

/// The names of such scenarios, with their sentences.
using LacksOfTime = std::vector<std::pair<std::string, std::string>>;

/// "in 6 of 20 scenarios nobody can arrive within 60 s: a, b, c and 3 more; in a the shortest path
/// takes 103.1 s at 0.26 m/s". Empty if there is none.
std::string lack_of_time_note(const LacksOfTime& scenarios, std::size_t of);

}  // namespace slalom
