// SPDX-License-Identifier: BSD-3-Clause
#include "map_readers.h"

#include <slalom/core/error.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/map_formats/map_pairs.h>

#include <cmath>
#include <sstream>

namespace slalom {
namespace {

constexpr char kExpected[] =
    "x,y,phi of the start and x,y or x,y,phi of the goal, or the goal alone with --start";
constexpr std::size_t kMaxPairs = 1'000'000;

/// The numbers of a line; none if it has something else.
std::vector<double> numbers_in(const std::string& line) {
  std::vector<double> numbers;
  for (const std::string& field : separated_fields(line)) {
    double number = 0;
    if (!parse_number(field, number) || !std::isfinite(number)) return {};
    numbers.push_back(number);
  }
  return numbers;
}

}  // namespace

std::vector<MapPair> parse_map_pairs(const std::string& text, const std::string& where,
                                     const std::optional<mrpt::math::TPose2D>& start) {
  std::vector<MapPair> pairs;
  std::istringstream lines(text);
  bool may_be_header = true;
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    line = trim(line);
    if (line.empty() || line[0] == '#') continue;
    const std::vector<double> n = numbers_in(line);
    const bool is_header = may_be_header && n.empty();
    may_be_header = false;
    if (is_header) continue;
    const std::string here = where + ":" + std::to_string(number);
    const bool has_start = n.size() == 5 || n.size() == 6;
    if (!has_start && n.size() != 2 && n.size() != 3)
      throw file_error(here, "no pair of start and goal", kExpected);
    if (!has_start && !start) throw file_error(here, "a goal without start", kExpected);
    if (pairs.size() == kMaxPairs) throw file_error(here, "too many pairs", "at most a million");
    const std::size_t at = has_start ? 3 : 0;
    MapPair pair;
    pair.line = number;
    pair.start = has_start ? mrpt::math::TPose2D(n[0], n[1], n[2]) : *start;
    pair.goal = {n[at], n[at + 1]};
    if (n.size() == at + 3) pair.goal_heading = n[at + 2];
    pairs.push_back(pair);
  }
  if (pairs.empty()) throw file_error(where, "has no pairs", kExpected);
  return pairs;
}

std::vector<MapPair> read_map_pairs(const std::string& path,
                                    const std::optional<mrpt::math::TPose2D>& start) {
  return parse_map_pairs(read_text(path, "pairs of start and goal", 100 * kMegabyte), path, start);
}

}  // namespace slalom
