// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/text.h>
#include <slalom/results/lack_of_time.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr std::string_view kBegin = "nobody can arrive within ",
                           kMiddle = " s: the shortest path takes at least ", kAt = " s at ",
                           kEnd = " m/s";

/// Takes `word`, and what is before it, from the text; whether that is a number.
bool take_number_before(std::string_view& text, std::string_view word) {
  const std::size_t at = text.find(word);
  double number = 0;
  if (at == std::string_view::npos || !parse_number(std::string(text.substr(0, at)), number))
    return false;
  text.remove_prefix(at + word.size());
  return true;
}

}  // namespace

std::string lack_of_time_sentence(double limit, double earliest, double speed) {
  return std::string(kBegin) + format_number(limit) + std::string(kMiddle) +
         format_fixed(earliest, 1) + std::string(kAt) + format_number(speed) + std::string(kEnd);
}

std::string lack_of_time_in(std::string_view outcome_detail) {
  const std::size_t begin = outcome_detail.rfind(kBegin);
  if (begin == std::string_view::npos) return "";
  std::string_view rest = outcome_detail.substr(begin + kBegin.size());
  const bool is_sentence = take_number_before(rest, kMiddle) && take_number_before(rest, kAt) &&
                           take_number_before(rest, kEnd) && rest.empty();
  return is_sentence ? std::string(outcome_detail.substr(begin)) : "";
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
