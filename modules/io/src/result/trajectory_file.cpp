// SPDX-License-Identifier: BSD-3-Clause
#include "../text_lines.h"
#include "derived_speeds.h"

#include <slalom/core/distance.h>
#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/read_file.h>
#include <slalom/core/ros_bag.h>
#include <slalom/core/text.h>
#include <slalom/io/trajectory_file.h>

#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

namespace slalom {
namespace {

constexpr std::size_t kMaxSamples = 5'000'000;
constexpr std::uintmax_t kMaxBytes = std::uintmax_t{512} << 20;
constexpr double kMaxDistance = 1e5;  // m

/// In the order of the elements of Row.
const std::vector<std::string> kColumns = {"t", "x",  "y",         "phi",       "v",
                                           "w", "vy", "command_v", "command_w", "command_vy"};
constexpr std::size_t kRequired = 4;
using Row = std::array<double, 10>;

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// The index in Row of each column of the header.
std::vector<std::size_t> read_header(const std::vector<std::string>& names,
                                     const TextLines& lines) {
  std::vector<std::size_t> indexes;
  for (const std::string& name : names) {
    const auto found = std::find(kColumns.begin(), kColumns.end(), name);
    if (found == kColumns.end())
      throw lines.error("unknown column '" + name + "'",
                        expected_name(name, kColumns, "names from " + join(kColumns, ", ")));
    indexes.push_back(static_cast<std::size_t>(found - kColumns.begin()));
    if (std::count(indexes.begin(), indexes.end(), indexes.back()) > 1)
      throw lines.error("duplicate column '" + name + "'", "each column once");
  }
  for (std::size_t i = 0; i < kRequired; ++i)
    if (std::find(indexes.begin(), indexes.end(), i) == indexes.end())
      throw lines.error("missing column '" + kColumns[i] + "'", "a header line with t, x, y, phi");
  return indexes;
}

/// Wraps an angle to [-pi, pi]; angles inside remain bitwise unchanged.
double wrapped(double angle) {
  return std::abs(angle) <= M_PI ? angle : mrpt::math::wrapToPi(angle);
}

/// Collects the samples of a span and checks their plausibility.
class Collector {
 public:
  explicit Collector(const LogSpan& span) : span_(span) {}

  void add(const Row& row, const TextLines& lines) {
    auto& samples = trajectory_.samples;
    Sample sample;
    sample.t = row[0];
    sample.pose = {row[1], row[2], wrapped(row[3])};
    sample.v = row[4], sample.w = row[5], sample.vy = row[6];
    sample.command_v = row[7], sample.command_w = row[8], sample.command_vy = row[9];
    if (is_left_out(sample, lines)) return;
    if (!samples.empty()) check(samples.back(), sample, lines);
    samples.push_back(sample);
  }

  Trajectory take(const TextLines& lines) {
    if (trajectory_.samples.size() < 2)
      throw lines.error("only " + std::to_string(trajectory_.samples.size()) + " samples",
                        "at least 2 samples");
    return std::move(trajectory_);
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    const auto add = [&](std::size_t rows, const std::string& why) {
      if (rows == 0) return;
      notes.push_back(count_text(rows, "row") + " left out: " + why);
    };
    add(repeated_, "the time of the row before");
    add(outside_, "not from --from to --to");
    add(after_step_back_, "the time goes back");
    return notes;
  }

 private:
  /// The first sample of a time counts.
  bool is_left_out(const Sample& now, const TextLines& lines) {
    const auto& samples = trajectory_.samples;
    const bool goes_back = !samples.empty() && now.t < samples.back().t;
    if (has_ended_ || (goes_back && std::isfinite(span_.to))) {
      has_ended_ = true;
      return ++after_step_back_ > 0;
    }
    if (now.t < span_.from || now.t > span_.to) return ++outside_ > 0;
    if (goes_back)
      throw lines.error(
          "t = " + format_number(now.t) + " goes back from " + format_number(samples.back().t),
          "times that increase; --from and --to read a part");
    return !samples.empty() && now.t == samples.back().t && ++repeated_ > 0;
  }

  void check(const Sample& before, const Sample& now, const TextLines& lines) {
    if (trajectory_.samples.size() >= kMaxSamples)
      throw lines.error("too many samples", "at most 5 million");
    distance_ += distance_between(now.pose, before.pose);
    if (!(distance_ <= kMaxDistance))
      throw lines.error("path longer than 100 km", "coordinates in meters");
  }

  LogSpan span_;
  Trajectory trajectory_;
  double distance_ = 0;
  std::size_t repeated_ = 0, outside_ = 0, after_step_back_ = 0;
  bool has_ended_ = false;
};

/// A note if the steps between samples are too long for a robot's log in s.
void note_unit_of_time(const Trajectory& log, std::vector<std::string>& notes) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < log.samples.size(); ++i)
    steps.push_back(log.samples[i].t - log.samples[i - 1].t);
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  if (*middle < 5) return;
  const char* unit = *middle < 2e3   ? "milliseconds"
                     : *middle < 2e6 ? "microseconds"
                                     : "nanoseconds";
  notes.push_back("samples are " + format_number(*middle) + " s apart (median): is t in " + unit +
                  " instead of s?");
}

/// A note if a robot that cannot move sideways does so.
void note_sideways_motion(const Trajectory& log, std::vector<std::string>& notes) {
  constexpr double kNoise = 1e-3, kShare = 0.25;  // m; of the path
  double sideways = 0, total = 0;
  for (std::size_t i = 1; i < log.samples.size(); ++i) {
    const auto &from = log.samples[i - 1].pose, &to = log.samples[i].pose;
    const double distance = distance_between(to, from);
    if (distance < kNoise) continue;
    const double heading = from.phi + mrpt::math::wrapToPi(to.phi - from.phi) / 2;
    const double direction = math::atan2(to.y - from.y, to.x - from.x);
    sideways += distance * std::abs(math::sin(direction - heading));
    total += distance;
  }
  if (total < 1 || sideways < kShare * total) return;
  notes.push_back("the robot moves sideways to phi (" + format_fixed(100 * sideways / total, 0) +
                  " % of the path): is phi in degrees instead of rad, or the robot holonomic?");
}

/// "a", "a and b", "a, b and c"
std::string enumeration(const std::vector<std::string>& names) {
  if (names.size() < 2) return join(names, "");
  return join({names.begin(), names.end() - 1}, ", ") + " and " + names.back();
}

/// Computes missing velocities; reports missing columns and what is implausible.
TrajectoryFile complete(Collector& collector, const TextLines& lines, const std::vector<bool>& has,
                        bool sideways) {
  TrajectoryFile file{collector.take(lines), collector.notes()};
  note_unit_of_time(file.trajectory, file.notes);
  if (!sideways) note_sideways_motion(file.trajectory, file.notes);
  const bool derive_vy = sideways && !has[6];
  std::vector<std::string> derived, commands;
  if (!has[4]) derived.push_back("v");
  if (!has[5]) derived.push_back("w");
  if (derive_vy) derived.push_back("vy");
  if (!derived.empty())
    file.notes.push_back(enumeration(derived) + " computed from pose differences");
  derive_speeds(file.trajectory, {!has[4], !has[5], derive_vy});
  for (const std::size_t i : {7, 8})
    if (!has[i]) commands.push_back(kColumns[i]);
  if (!commands.empty()) file.notes.push_back("no " + enumeration(commands));
  return file;
}

/// Separators besides the comma count only in lines without it.
char log_separator(const std::string& line) {
  for (const char separator : {',', ';', '\t'})
    if (line.find(separator) != std::string::npos) return separator;
  return ',';
}

TrajectoryFile read_csv(const std::string& header, TextLines& lines, bool sideways,
                        const LogSpan& span) {
  const char separator = log_separator(header);
  const std::vector<std::size_t> indexes = read_header(split(header, separator), lines);
  std::vector<bool> has(kColumns.size(), false);
  for (const std::size_t index : indexes) has[index] = true;
  Row blank{};
  if (!has[7]) blank[7] = kMissing;
  if (!has[8]) blank[8] = kMissing;
  Collector collector(span);
  for (std::string line; lines.next(line);) {
    const std::vector<double> numbers = numbers_of(split(line, separator), indexes.size(), lines);
    Row row = blank;
    for (std::size_t i = 0; i < indexes.size(); ++i) row[indexes[i]] = numbers[i];
    collector.add(row, lines);
  }
  return complete(collector, lines, has, sideways);
}

/// The yaw of a unit quaternion: the heading of the rotated x axis in the plane.
double yaw_of(double qx, double qy, double qz, double qw, const TextLines& lines) {
  const double norm = std::sqrt(qx * qx + qy * qy + qz * qz + qw * qw);
  if (!(std::abs(norm - 1) < 0.01))
    throw lines.error("quaternion norm is " + format_number(norm), "a unit quaternion");
  return math::atan2(2 * (qw * qz + qx * qy), qw * qw + qx * qx - qy * qy - qz * qz);
}

TrajectoryFile read_tum(std::string line, TextLines& lines, bool sideways, const LogSpan& span) {
  Collector collector(span);
  do {
    const auto n = numbers_of(split_at_blanks(line), 8, lines);
    collector.add(
        {n[0], n[1], n[2], yaw_of(n[4], n[5], n[6], n[7], lines), 0, 0, 0, kMissing, kMissing, 0},
        lines);
  } while (lines.next(line));
  return complete(collector, lines, std::vector<bool>(kColumns.size(), false), sideways);
}

/// Lines of ns, x, y, z, qw, qx, qy, qz and, in ground truths, what follows: of other frames.
TrajectoryFile read_euroc(TextLines& lines, bool sideways, const LogSpan& span) {
  constexpr std::size_t kPose = 8;
  Collector collector(span);
  for (std::string line; lines.next(line);) {
    std::vector<std::string> fields = split(line, ',');
    fields.resize(std::min(fields.size(), kPose));
    const auto n = numbers_of(fields, kPose, lines);
    collector.add({1e-9 * n[0], n[1], n[2], yaw_of(n[5], n[6], n[7], n[4], lines), 0, 0, 0,
                   kMissing, kMissing, 0},
                  lines);
  }
  return complete(collector, lines, std::vector<bool>(kColumns.size(), false), sideways);
}

}  // namespace

TrajectoryFile trajectory_from_text(const std::string& text, const std::string& where,
                                    bool sideways, const LogSpan& span) {
  refuse_ros_bag(text, where,
                 "a trajectory as CSV or TUM; slalom-analyze metrics --trajectory reads bags");
  TextLines lines(text, where);
  if (starts_with(text, "#timestamp")) return read_euroc(lines, sideways, span);
  std::string line;
  if (!lines.next(line))
    throw file_error(where, "empty file", "a trajectory as CSV with a header line, or as TUM");
  double number = 0;
  const std::vector<std::string> parts = split_at_blanks(line);
  const bool is_tum = line.find(',') == std::string::npos && parse_number(parts[0], number);
  return is_tum ? read_tum(line, lines, sideways, span) : read_csv(line, lines, sideways, span);
}

TrajectoryFile load_trajectory_file(const std::string& path, bool sideways, const LogSpan& span) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error && size > kMaxBytes) throw file_error(path, "file too large", "at most 512 MiB");
  return trajectory_from_text(read_text(path, "a trajectory"), path, sideways, span);
}

}  // namespace slalom
