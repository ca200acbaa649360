// SPDX-License-Identifier: BSD-3-Clause
#include "../text_lines.h"

#include <slalom/core/math.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/io/movers_file.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace slalom {
namespace {

constexpr std::size_t kMaxLines = 1'000'000;

/// Collects the positions of movers in the order of the file.
class MoverCollector {
 public:
  MoverCollector(const TextLines& lines, const MoversFileOptions& options)
      : lines_(lines), options_(options) {}

  void add(const std::string& id, double t, double x, double y, double radius) {
    if (++count_ > kMaxLines) throw lines_.error("too many lines", "at most a million");
    const auto [found, is_new] = index_of_.try_emplace(id, movers_.size());
    if (is_new) movers_.push_back({id, radius, {}, MoverEnd::Vanish});
    Mover& mover = movers_[found->second];
    if (mover.radius != radius)
      throw lines_.error("another radius of '" + id + "'", "one radius for each id");
    t -= options_.begin;
    if (!is_new && !(t > mover.waypoints.back().t))
      throw lines_.error("a time of '" + id + "' that does not follow the one before it",
                         "times that increase");
    mover.waypoints.push_back({t, {x, y}});
  }

  Movers take(const std::string& where) {
    Movers movers;
    for (Mover& mover : movers_)
      if (mover.waypoints.back().t >= 0) movers.push_back(from_begin(std::move(mover)));
    if (movers.empty())
      throw file_error(where, "no position at or after " + format_number(options_.begin) + " s",
                       "an earlier begin");
    check_movers(where, movers);
    return movers;
  }

 private:
  static Mover from_begin(Mover mover) {
    auto& waypoints = mover.waypoints;
    const auto first = std::find_if(waypoints.begin(), waypoints.end(),
                                    [](const Waypoint& w) { return w.t >= 0; });
    if (first == waypoints.begin()) return mover;
    // Nearer than the shortest segment, the next position counts as that at the beginning.
    const auto at_begin = mover.position(0);
    if (first->t < kMinSegmentDuration) {
      first->t = 0;
      waypoints.erase(waypoints.begin(), first);
    } else {
      *std::prev(first) = {0, at_begin};
      waypoints.erase(waypoints.begin(), std::prev(first));
    }
    return mover;
  }

  const TextLines& lines_;
  MoversFileOptions options_;
  Movers movers_;
  std::map<std::string, std::size_t> index_of_;
  std::size_t count_ = 0;
};

/// The column of each of kNames; -1 for a missing radius.
std::array<int, 5> read_columns(const std::vector<std::string>& columns, const TextLines& lines) {
  static const std::vector<std::string> kNames = {"id", "t", "x", "y", "r"};
  std::array<int, 5> indexes = {-1, -1, -1, -1, -1};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto found = std::find(kNames.begin(), kNames.end(), columns[i]);
    if (found == kNames.end())
      throw lines.error("unknown column '" + columns[i] + "'", "a header line with id, t, x, y, r");
    int& index = indexes[static_cast<std::size_t>(found - kNames.begin())];
    if (index >= 0) throw lines.error("duplicate column '" + columns[i] + "'", "each column once");
    index = static_cast<int>(i);
  }
  for (std::size_t i = 0; i < 4; ++i)
    if (indexes[i] < 0)
      throw lines.error("missing column '" + kNames[i] + "'", "a header line with id, t, x, y");
  return indexes;
}

void read_csv(const std::string& header, TextLines& lines, double default_radius,
              MoverCollector& movers) {
  const std::vector<std::string> columns = split(header, ',');
  const std::array<int, 5> indexes = read_columns(columns, lines);
  for (std::string line; lines.next(line);) {
    std::vector<std::string> fields = split(line, ',');
    const auto id_column = static_cast<std::size_t>(indexes[0]);
    std::string id;
    if (id_column < fields.size()) id = std::exchange(fields[id_column], "0");
    const std::vector<double> numbers = numbers_of(fields, columns.size(), lines);
    const auto value = [&](std::size_t i) { return numbers[static_cast<std::size_t>(indexes[i])]; };
    movers.add(id, value(1), value(2), value(3), indexes[4] < 0 ? default_radius : value(4));
  }
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Derives the frame rate and the unit of length from the positions and velocities of people.
class ImpliedUnits {
 public:
  void add(double frame, const std::string& id, const mrpt::math::TPoint2D& position,
           double speed) {
    const auto [found, is_new] = last_.try_emplace(id, frame, position);
    const double frames = frame - found->second.first;
    const double distance =
        math::hypot(position.x - found->second.second.x, position.y - found->second.second.y);
    constexpr double kMin = 1e-2;  // m, and m/s: people who stand say nothing
    const double rate = speed * frames / distance;
    if (!is_new && frames > 0) steps_.push_back(distance / frames);
    if (!is_new && distance > kMin && speed > kMin && std::isfinite(rate)) rates_.push_back(rate);
    found->second = {frame, position};
  }

  /// Throws Error (File) if the medians are another rate or a speed at which no crowd moves.
  void check(double rate, const std::string& where) {
    constexpr double kTolerance = 1.25;  // velocities may be smoothed
    const double implied = rates_.empty() ? rate : median(rates_);
    if (implied > rate * kTolerance || rate > implied * kTolerance)
      throw file_error(where,
                       "a frame rate of " + format_number(rate) +
                           " contradicts the velocities, which imply " + format_fixed(implied, 2),
                       "frames per second of the column of frames");
    constexpr double kMaxSpeed = 5;  // m/s, of runners over hours
    if (const double speed = steps_.empty() ? 0 : median(steps_) * rate; speed > kMaxSpeed)
      throw file_error(where, "a median speed of " + format_fixed(speed, 1) + " m/s",
                       "positions of people in m, not in pixels");
  }

 private:
  std::map<std::string, std::pair<double, mrpt::math::TPoint2D>> last_;
  std::vector<double> rates_, steps_;  ///< 1/s; m per frame
};

void read_obsmat(std::string line, TextLines& lines, const std::string& where,
                 const MoversFileOptions& options, MoverCollector& movers) {
  if (!(options.frame_rate > 0))
    throw lines.error("frames instead of times", "the frame rate of the recording");
  ImpliedUnits implied;
  do {
    const auto n = numbers_of(split_at_blanks(line), 8, lines);
    if (n[1] != std::round(n[1]) || std::abs(n[1]) > 1e9)
      throw lines.error("invalid id in field 2", "an integer");
    const std::string id = std::to_string(std::lround(n[1]));
    implied.add(n[0], id, {n[2], n[4]}, math::hypot(n[5], n[7]));
    movers.add(id, n[0] / options.frame_rate, n[2], n[4], options.radius);
  } while (lines.next(line));
  implied.check(options.frame_rate, where);
}

}  // namespace

Movers movers_from_text(const std::string& text, const std::string& where,
                        const MoversFileOptions& options) {
  TextLines lines(text, where);
  std::string line;
  const std::string expected = "CSV with the columns id, t, x, y, or an obsmat.txt";
  if (!lines.next(line)) throw file_error(where, "empty file", expected);
  MoverCollector movers(lines, options);
  if (line.find(',') != std::string::npos)
    read_csv(line, lines, options.radius, movers);
  else
    read_obsmat(line, lines, where, options, movers);
  return movers.take(where);
}

Movers load_movers_file(const std::string& path, const MoversFileOptions& options) {
  return movers_from_text(read_text(path, "positions of moving obstacles"), path, options);
}

}  // namespace slalom
