// SPDX-License-Identifier: BSD-3-Clause
#include "map_readers.h"

#include <slalom/core/error.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/map_formats/point_map.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace slalom {
namespace {

constexpr double kMaxCoordinate = 1e6;  ///< m: single precision resolves 0.06 m there
constexpr char kCoordinates[] = "x y or x y z, in m";

class PointLines {
 public:
  PointLines(const std::string& text, const std::string& where, const PointMapOptions& options)
      : text_(text), where_(where), options_(options) {}

  mrpt::maps::CSimplePointsMap read() {
    std::size_t begin = 0;
    while (begin < text_.size()) {
      const std::size_t end = std::min(text_.find('\n', begin), text_.size());
      ++line_;
      add_line(text_.substr(begin, end - begin));
      begin = end + 1;
    }
    if (map_.empty()) throw file_error(where_, "contains no points", kCoordinates);
    return map_;
  }

 private:
  void add_line(std::string line) {
    line.erase(std::min(line.find_first_of("#%"), line.size()));
    const std::vector<std::string> fields = separated_fields(line);
    if (!begun_ && columns_.empty() && is_header(fields)) return;
    const std::vector<double> values =
        numbers(columns_.empty() || fields.empty() ? fields : chosen(fields));
    if (values.empty() || (values.size() == 1 && !begun_)) {  // a count before all points
      begun_ = begun_ || !values.empty();
      return;
    }
    begun_ = true;
    if (values.size() < 2) throw malformed("only one number");
    if (std::abs(values[0]) > kMaxCoordinate || std::abs(values[1]) > kMaxCoordinate)
      throw malformed("coordinates out of range");
    const bool in_height_range =
        values.size() < 3 || (values[2] >= options_.z_min && values[2] <= options_.z_max);
    if (in_height_range)
      map_.insertPoint(static_cast<float>(values[0]), static_cast<float>(values[1]), 0);
  }

  /// Whether the line names columns x and y: their places, and that of z if there is one.
  bool is_header(const std::vector<std::string>& fields) {
    const auto place_of = [&](const char* name) {
      return static_cast<std::size_t>(
          std::find_if(fields.begin(), fields.end(),
                       [&](const std::string& field) { return lower_case(field) == name; }) -
          fields.begin());
    };
    const std::size_t x = place_of("x"), y = place_of("y"), z = place_of("z");
    if (x == fields.size() || y == fields.size()) return false;
    columns_ = {x, y};
    if (z < fields.size()) columns_.push_back(z);
    return true;
  }

  std::vector<std::string> chosen(const std::vector<std::string>& fields) const {
    std::vector<std::string> texts;
    for (const std::size_t column : columns_) {
      if (column >= fields.size()) throw malformed("fewer fields than the header has");
      texts.push_back(fields[column]);
    }
    return texts;
  }

  std::vector<double> numbers(const std::vector<std::string>& fields) const {
    std::vector<double> values;
    for (const std::string& field : fields)
      if (!parse_number(field, values.emplace_back())) throw malformed("invalid number");
    return values;
  }

  Error malformed(const std::string& what) const {
    return file_error(where_ + ":" + std::to_string(line_), what, kCoordinates);
  }

  const std::string& text_;
  const std::string& where_;
  const PointMapOptions& options_;
  mrpt::maps::CSimplePointsMap map_;
  std::size_t line_ = 0;
  bool begun_ = false;
  std::vector<std::size_t> columns_;  ///< of x, y and maybe z, as a header names them
};

}  // namespace

std::vector<std::string> separated_fields(const std::string& line) {
  constexpr char kSeparators[] = " \t\r,;";
  std::vector<std::string> fields;
  std::size_t at = line.find_first_not_of(kSeparators);
  while (at != std::string::npos) {
    const std::size_t end = std::min(line.find_first_of(kSeparators, at), line.size());
    fields.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kSeparators, end);
  }
  return fields;
}

bool is_point_map(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  return ending == ".txt" || ending == ".xyz" || ending == ".pts" || ending == ".csv";
}

mrpt::maps::CSimplePointsMap parse_point_map(const std::string& text, const std::string& where,
                                             const PointMapOptions& options) {
  return PointLines(text, where, options).read();
}

mrpt::maps::CSimplePointsMap read_point_map(const std::string& path,
                                            const PointMapOptions& options) {
  return parse_point_map(read_text(path, "a point map", kMaxTextSize), path, options);
}

Scenario point_map_scenario(const std::string& path, const PointMapOptions& options) {
  if (!(options.margin > 0) || !std::isfinite(options.margin))
    throw usage_error(path, "invalid margin " + format_number(options.margin) + " m",
                      "a length > 0");
  const auto map = read_point_map(path, options);
  const auto& x = map.getPointsBufferRef_x();
  const auto& y = map.getPointsBufferRef_y();
  const auto [left, right] = std::minmax_element(x.begin(), x.end());
  const auto [low, high] = std::minmax_element(y.begin(), y.end());
  const Bounds bounds{*left - options.margin, *low - options.margin, *right + options.margin,
                      *high + options.margin};
  const mrpt::math::TPoint2D corner(bounds.x_min, bounds.y_min);
  return Scenario::points(std::filesystem::path(path).stem().string(), bounds, map,
                          {corner.x, corner.y, 0}, corner);
}

}  // namespace slalom
