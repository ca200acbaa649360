// SPDX-License-Identifier: BSD-3-Clause
#include "map_readers.h"

#include <slalom/core/error.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/map_formats/moving_ai.h>
#include <slalom/scenario/grid_map.h>

#include <cmath>
#include <sstream>

namespace slalom {
namespace {

using mrpt::maps::COccupancyGridMap2D;

constexpr int kMaxSide = 1 << 16;

/// Iterates over the lines of a text, without line ends (LF or CRLF).
class Lines {
 public:
  Lines(const std::string& bytes, const std::string& path) : bytes_(bytes), path_(path) {}

  bool next(std::string& line) {
    if (at_ >= bytes_.size()) return false;
    const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    line = bytes_.substr(at_, end - at_);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    at_ = end + 1;
    ++number_;
    return true;
  }

  int number() const { return number_; }
  std::size_t remaining() const { return at_ < bytes_.size() ? bytes_.size() - at_ : 0; }

  Error malformed(const std::string& what, const std::string& expected) const {
    return file_error(path_ + ":" + std::to_string(number_), what, expected);
  }

 private:
  const std::string& bytes_;
  const std::string& path_;
  std::size_t at_ = 0;
  int number_ = 0;
};

std::vector<std::string> split_words(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

int read_side(const std::vector<std::string>& words, const Lines& lines) {
  long long side = 0;
  if (words.size() != 2 || !parse_integer(words[1], side) || side < 1 || side > kMaxSide)
    throw lines.malformed("invalid " + words[0],
                          "'" + words[0] + "' and 1 to " + std::to_string(kMaxSide));
  return static_cast<int>(side);
}

struct MapHeader {
  int width = 0, height = 0;
};

MapHeader read_header(Lines& lines) {
  MapHeader header;
  bool is_octile = false;
  for (std::string line; lines.next(line);) {
    const std::vector<std::string> words = split_words(line);
    const std::string key = words.empty() ? "" : words[0];
    if (key == "type") {
      is_octile = words.size() == 2 && words[1] == "octile";
      if (!is_octile) throw lines.malformed("unsupported type", "'type octile'");
    } else if (key == "height") {
      header.height = read_side(words, lines);
    } else if (key == "width") {
      header.width = read_side(words, lines);
    } else if (key == "map" && words.size() == 1) {
      if (is_octile && header.width > 0 && header.height > 0) return header;
      throw lines.malformed("incomplete header", "type, height and width before the map");
    } else {
      throw lines.malformed("unknown entry '" + line.substr(0, 40) + "'",
                            "type, height, width or map");
    }
  }
  throw lines.malformed("has no map", "a line 'map'");
}

/// The probability of being free: 1 or 0.
float free_probability(char cell, const Lines& lines, std::size_t column) {
  switch (cell) {
    case '.':
    case 'G':
      return 1;
    case '@':
    case 'O':
    case 'T':
      return 0;
    case 'S':
    case 'W':
      throw lines.malformed("has " + std::string(cell == 'S' ? "swamp" : "water") + " in column " +
                                std::to_string(column + 1),
                            "a map of free and occupied cells only");
    default:
      throw lines.malformed("has an unknown cell in column " + std::to_string(column + 1),
                            ". G @ O or T");
  }
}

int cell_index(const std::string& word, int size, const char* what, const Lines& lines) {
  long long cell = 0;
  if (!parse_integer(word, cell) || cell < 0 || cell >= size)
    throw lines.malformed(std::string(what) + " '" + word.substr(0, 20) + "' is outside the map",
                          "0 to " + std::to_string(size - 1));
  return static_cast<int>(cell);
}

int bounded_integer(const std::string& word, int min, int max, const char* what,
                    const Lines& lines) {
  long long number = 0;
  if (!parse_integer(word, number) || number < min || number > max)
    throw lines.malformed(std::string(what) + " is '" + word.substr(0, 20) + "'",
                          std::to_string(min) + " to " + std::to_string(max));
  return static_cast<int>(number);
}

MovingAiProblem read_problem(const std::vector<std::string>& words, const Lines& lines) {
  constexpr std::size_t kColumns = 9;
  constexpr int kMaxBuckets = 1'000'000'000;
  if (words.size() != kColumns)
    throw lines.malformed("has " + std::to_string(words.size()) + " columns",
                          "9: bucket, map, width, height, start x y, goal x y, length");
  MovingAiProblem problem;
  problem.line = lines.number();
  problem.bucket = bounded_integer(words[0], 0, kMaxBuckets, "the bucket", lines);
  problem.map_width = bounded_integer(words[2], 1, kMaxSide, "the map's width", lines);
  problem.map_height = bounded_integer(words[3], 1, kMaxSide, "the map's height", lines);
  problem.start_x = cell_index(words[4], problem.map_width, "start x", lines);
  problem.start_y = cell_index(words[5], problem.map_height, "start y", lines);
  problem.goal_x = cell_index(words[6], problem.map_width, "goal x", lines);
  problem.goal_y = cell_index(words[7], problem.map_height, "goal y", lines);
  if (!parse_number(words[8], problem.published_length) || problem.published_length < 0)
    throw lines.malformed("the length is '" + words[8].substr(0, 20) + "'", "a number, at least 0");
  return problem;
}

}  // namespace

COccupancyGridMap2D read_moving_ai_map(const std::string& path, double cell_size) {
  if (!(cell_size > 0) || !std::isfinite(cell_size))
    throw usage_error(path, "the cell size of a MovingAI map is unknown", "--cell-size in m");
  const std::string bytes = read_text(path, "a MovingAI map (.map)", kMaxMapSize);
  Lines lines(bytes, path);
  const MapHeader header = read_header(lines);
  const auto width = static_cast<std::size_t>(header.width);
  if (lines.remaining() / width < static_cast<std::size_t>(header.height))
    throw lines.malformed("declares " + std::to_string(header.width) + " x " +
                              std::to_string(header.height) + " cells, more than the file contains",
                          "a complete file");
  auto map = make_grid_map(header.width, header.height, cell_size, {0, 0});
  std::string row;
  for (int y = header.height - 1; y >= 0; --y) {
    if (!lines.next(row)) throw lines.malformed("is truncated", "more rows of cells");
    if (row.size() != width)
      throw lines.malformed("has " + std::to_string(row.size()) + " cells",
                            std::to_string(width) + " as given by the width");
    for (std::size_t x = 0; x < width; ++x)
      map.setCell(static_cast<int>(x), y, free_probability(row[x], lines, x));
  }
  while (lines.next(row))
    if (!trim(row).empty())
      throw lines.malformed("unexpected text after the last row", "the end of the file");
  return map;
}

std::vector<MovingAiProblem> read_moving_ai_problems(const std::string& path) {
  const std::string bytes = read_text(path, "MovingAI scenarios (.scen)");
  Lines lines(bytes, path);
  std::string line;
  lines.next(line);
  const std::vector<std::string> first = split_words(line);
  if (first.size() != 2 || first[0] != "version" || (first[1] != "1" && first[1] != "1.0"))
    throw lines.malformed("missing version", "'version 1'");
  std::vector<MovingAiProblem> problems;
  while (lines.next(line)) {
    const std::vector<std::string> words = split_words(line);
    if (!words.empty()) problems.push_back(read_problem(words, lines));
  }
  return problems;
}

std::vector<MovingAiProblem> select_problems(const std::vector<MovingAiProblem>& problems,
                                             const ProblemSelection& choice) {
  std::vector<MovingAiProblem> candidates;
  for (const MovingAiProblem& p : problems)
    if (p.bucket >= choice.first_bucket && p.bucket <= choice.last_bucket &&
        (p.start_x != p.goal_x || p.start_y != p.goal_y))
      candidates.push_back(p);
  const auto wanted = static_cast<std::size_t>(choice.count);
  if (choice.count <= 0 || wanted >= candidates.size()) return candidates;
  std::vector<MovingAiProblem> selected;
  for (std::size_t i = 0; i < wanted; ++i)
    selected.push_back(candidates[i * candidates.size() / wanted]);
  return selected;
}

}  // namespace slalom
