// SPDX-License-Identifier: BSD-3-Clause
#include "rawlog_format.h"

#include <slalom/core/text.h>

#include <cmath>
#include <sstream>

namespace slalom {

mrpt::Clock::time_point logged_start() {
  constexpr double kSeconds = 1e9 + 2;
  return mrpt::Clock::fromDouble(kSeconds);
}

mrpt::Clock::time_point logged_time(double seconds) {
  constexpr double kTicksPerSecond = 1e7;
  return logged_start() + mrpt::Clock::duration(static_cast<mrpt::Clock::rep>(
                              std::llround(seconds * kTicksPerSecond)));
}

std::string format_numbers(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) {
    const bool minus_zero = number == 0 && std::signbit(number);
    text += (text.empty() ? "" : " ") + (minus_zero ? "-0" : format_number(number));
  }
  return text;
}

bool parse_numbers(const std::string& text, std::size_t count, double* numbers) {
  std::istringstream words(text);
  std::string word;
  for (std::size_t i = 0; i < count; ++i)
    if (!(words >> word) || !parse_number(word, numbers[i])) return false;
  return !(words >> word);
}

}  // namespace slalom
