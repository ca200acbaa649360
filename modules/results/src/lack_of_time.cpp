// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/text.h>
#include <slalom/results/lack_of_time.h>

#include <algorithm>
#include <cstring>

namespace slalom {

std::string lack_of_time_in(const char* outcome_detail) {
  const char* found = std::strstr(outcome_detail, kLackOfTime);
  return found == nullptr ? "" : found;
}

std::string lack_of_time_note(const LacksOfTime& scenarios, std::size_t of) {
  constexpr std::size_t kNamed = 3;
  if (scenarios.empty()) return "";
  const auto& [name, sentence] = scenarios.front();
  const std::size_t colon = std::min(sentence.find(':'), sentence.size());
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(kNamed, scenarios.size()); ++i)
    names.push_back(scenarios[i].first);
  const std::string more = scenarios.size() > kNamed
                               ? " and " + std::to_string(scenarios.size() - kNamed) + " more"
                               : "";
  return "in " + std::to_string(scenarios.size()) + " of " + count_text(of, "scenario") + " " +
         sentence.substr(0, colon) + ": " + join(names, ", ") + more + "; in " + name +
         sentence.substr(std::min(colon + 1, sentence.size()));
}

}  // namespace slalom
