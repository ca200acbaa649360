// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slalom {

/// Why no run in a scenario can end in time, at the end of the details of these runs: "nobody can
/// arrive within 60 s: the shortest path takes at least 103.1 s at 0.26 m/s". Times in s, m/s.
std::string lack_of_time_sentence(double limit, double earliest, double speed);

/// The sentence at the end of the details of a run, or "". What methods and scenarios say in them
/// stands before the end.
std::string lack_of_time_in(std::string_view outcome_detail);

/// The names of such scenarios, with their sentences.
using LacksOfTime = std::vector<std::pair<std::string, std::string>>;

/// "in 6 of 20 scenarios nobody can arrive within 60 s: a, b, c and 3 more; in a the shortest path
/// takes at least 103.1 s at 0.26 m/s". Empty if there is none.
std::string lack_of_time_note(const LacksOfTime& scenarios, std::size_t of);

}  // namespace slalom
