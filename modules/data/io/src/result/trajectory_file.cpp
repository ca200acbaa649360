// SPDX-License-Identifier: BSD-3-Clause
#include "../text_lines.h"
#include "derived_speeds.h"
#include "echoed_messages.h"
#include "log_columns.h"

#include <slalom/core/distance.h>
#include <slalom/core/error.h>
#include <slalom/core/file_format.h>
#include <slalom/core/math.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/io/trajectory_file.h>

#include <mrpt/math/wrap2pi.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>

namespace slalom {
namespace {

constexpr std::size_t kMaxSamples = 5'000'000;
constexpr std::uintmax_t kMaxBytes = std::uintmax_t{512} << 20;
constexpr double kMaxDistance = 1e5;  // m
constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// Wraps an angle to [-pi, pi]; angles inside remain bitwise unchanged.
double wrapped(double angle) {
  return std::abs(angle) <= M_PI ? angle : mrpt::math::wrapToPi(angle);
}

/// Collects the selected samples and checks their plausibility.
class Collector {
 public:
  explicit Collector(const LogSelection& selection) : selection_(selection) {}

  void add(const LogRow& row, const TextLines& lines) {
    auto& samples = trajectory_.samples;
    Sample sample;
    sample.t = row[kTime];
    sample.pose = {row[kX], row[kY], wrapped(row[kPhi])};
    sample.v = row[kV], sample.w = row[kW], sample.vy = row[kVy];
    sample.command_v = row[kCommandV], sample.command_w = row[kCommandW];
    sample.command_vy = row[kCommandVy];
    if (is_left_out(sample, lines)) return;
    if (!samples.empty()) check(samples.back(), sample, lines);
    samples.push_back(sample);
    largest_angle_ = std::max(largest_angle_, std::abs(row[kPhi]));
  }

  /// A row without a pose, as a tracker that lost the robot writes it.
  void leave_out(const TextLines& lines) {
    if (without_pose_++ == 0) first_without_pose_ = lines.number();
  }

  Trajectory take(const TextLines& lines) {
    if (trajectory_.samples.size() < 2)
      throw lines.error("only " + count_text(trajectory_.samples.size(), "sample"),
                        "at least 2 samples");
    return std::move(trajectory_);
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    const auto add = [&](std::size_t rows, const std::string& why) {
      if (rows == 0) return;
      notes.push_back(count_text(rows, "row") + " left out: " + why);
    };
    add(repeated_,
        "the time of the row before (first in line " + std::to_string(first_repeated_) + ")");
    add(without_pose_, "nan (first in line " + std::to_string(first_without_pose_) + ")");
    add(outside_, "not from --from to --to");
    add(after_step_back_, "the time goes back");
    return notes;
  }

  double largest_angle() const { return largest_angle_; }
  std::size_t samples() const { return trajectory_.samples.size(); }

 private:
  /// The first sample of a time counts.
  bool is_left_out(const Sample& now, const TextLines& lines) {
    const auto& samples = trajectory_.samples;
    const bool goes_back = !samples.empty() && now.t < samples.back().t;
    if (has_ended_ || (goes_back && std::isfinite(selection_.to))) {
      has_ended_ = true;
      return ++after_step_back_ > 0;
    }
    if (now.t < selection_.from || now.t > selection_.to) return ++outside_ > 0;
    if (goes_back)
      throw lines.error(
          "t = " + format_number(now.t) + " goes back from " + format_number(samples.back().t),
          "times that increase; --from and --to read a part, --split several runs");
    if (samples.empty() || now.t != samples.back().t) return false;
    if (repeated_++ == 0) first_repeated_ = lines.number();
    return true;
  }

  void check(const Sample& before, const Sample& now, const TextLines& lines) {
    if (trajectory_.samples.size() >= kMaxSamples)
      throw lines.error("too many samples", "at most 5 million");
    distance_ += distance_between(now.pose, before.pose);
    if (!(distance_ <= kMaxDistance))
      throw lines.error("path longer than 100 km", "coordinates in meters");
  }

  LogSelection selection_;
  Trajectory trajectory_;
  double distance_ = 0, largest_angle_ = 0;
  std::size_t repeated_ = 0, first_repeated_ = 0, without_pose_ = 0, first_without_pose_ = 0,
              outside_ = 0, after_step_back_ = 0;
  bool has_ended_ = false;
};

/// A note if the steps between samples are too long for a robot's log in s.
void note_unit_of_time(const Trajectory& log, const LogColumns& columns,
                       std::vector<std::string>& notes) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < log.samples.size(); ++i)
    steps.push_back(log.samples[i].t - log.samples[i - 1].t);
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  if (*middle < 5) return;
  const auto [unit, factor] = *middle < 2e3   ? std::pair("milliseconds", 1e-3)
                              : *middle < 2e6 ? std::pair("microseconds", 1e-6)
                                              : std::pair("nanoseconds", 1e-9);
  notes.push_back("samples are " + format_number(*middle) + " s apart (median): is t in " + unit +
                  " instead of s? " + columns.scaled(kTime, factor));
}

/// A note if headings are too large for rad. True if so.
bool note_unit_of_heading(double largest, const LogColumns& columns,
                          std::vector<std::string>& notes) {
  constexpr double kTurns = 4;  // of a robot whose heading is not wrapped
  if (largest < 2 * M_PI * kTurns || !columns.has(kPhi)) return false;
  notes.push_back("phi is up to " + format_number(largest) +
                  " rad: is it in degrees instead of rad? " + columns.scaled(kPhi, M_PI / 180));
  return true;
}

/// A note if a robot that cannot move sideways does so.
void note_sideways_motion(const Trajectory& log, const LogColumns& columns,
                          std::vector<std::string>& notes) {
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
  const std::string option = columns.has(kPhi) ? " (" + columns.scaled(kPhi, M_PI / 180) + ")" : "";
  notes.push_back("the robot moves sideways to phi (" + format_fixed(100 * sideways / total, 0) +
                  " % of the path): is phi in degrees instead of rad" + option +
                  ", or the robot holonomic?");
}

/// "a", "a and b", "a, b and c"
std::string enumeration(const std::vector<std::string>& names) {
  if (names.size() < 2) return join(names, "");
  return join({names.begin(), names.end() - 1}, ", ") + " and " + names.back();
}

/// Computes missing headings and velocities; reports missing columns and what is implausible.
TrajectoryFile complete(Collector& collector, const TextLines& lines, const LogColumns& columns,
                        bool sideways) {
  TrajectoryFile file{collector.take(lines), collector.notes()};
  if (const std::string note = columns.note(); !note.empty()) file.notes.push_back(note);
  note_unit_of_time(file.trajectory, columns, file.notes);
  if (!columns.has_heading()) {
    derive_headings(file.trajectory);
    file.notes.push_back("phi computed from the direction of motion");
  } else if (!note_unit_of_heading(collector.largest_angle(), columns, file.notes) && !sideways) {
    note_sideways_motion(file.trajectory, columns, file.notes);
  }
  const bool derive_vy = sideways && !columns.has(kVy);
  std::vector<std::string> derived, commands;
  if (!columns.has(kV)) derived.push_back("v");
  if (!columns.has(kW)) derived.push_back("w");
  if (derive_vy) derived.push_back("vy");
  if (!derived.empty())
    file.notes.push_back(enumeration(derived) + " computed from pose differences");
  derive_speeds(file.trajectory, {!columns.has(kV), !columns.has(kW), derive_vy});
  if (!columns.has(kCommandV)) commands.push_back("command_v");
  if (!columns.has(kCommandW)) commands.push_back("command_w");
  if (!commands.empty()) file.notes.push_back("no " + enumeration(commands));
  return file;
}

/// The yaw of a unit quaternion: the heading of the rotated x axis in the plane.
double yaw_of(double qx, double qy, double qz, double qw, const TextLines& lines) {
  const double norm = std::sqrt(qx * qx + qy * qy + qz * qz + qw * qw);
  if (!(std::abs(norm - 1) < 0.01))
    throw lines.error("quaternion norm is " + format_number(norm), "a unit quaternion");
  return math::atan2(2 * (qw * qz + qx * qy), qw * qw + qx * qx - qy * qy - qz * qz);
}

/// The runs of a log: one, or with `split` one more where the time goes back.
std::vector<TrajectoryFile> read_log(std::string line, TextLines& lines, bool sideways,
                                     const LogSelection& selection, bool split) {
  const LogColumns columns = find_log_columns(line, selection.columns, lines);
  LogRow row{};
  row[kCommandV] = row[kCommandW] = kMissing;
  std::vector<TrajectoryFile> runs;
  Collector collector(selection);
  const auto finish = [&] {
    if (split && collector.samples() < 2) return;
    runs.push_back(complete(collector, lines, columns, sideways));
  };
  double last = -std::numeric_limits<double>::infinity();
  for (bool more = columns.first_line_has_numbers || lines.next(line); more;
       more = lines.next(line)) {
    if (!columns.read(line, row, lines)) {
      collector.leave_out(lines);
      continue;
    }
    if (columns.has(kQz)) row[kPhi] = yaw_of(row[kQx], row[kQy], row[kQz], row[kQw], lines);
    if (split && row[kTime] < last) {
      finish();
      collector = Collector(selection);
    }
    last = row[kTime];
    collector.add(row, lines);
  }
  finish();
  if (runs.empty()) throw lines.error("no run of 2 samples", "samples whose times increase");
  return runs;
}

constexpr std::size_t kKittiNumbers = 12, kMrptNumbers = 6;

/// How many numbers a line of poses without times has: 12 of KITTI, 6 of MRPT; 0 for other lines.
std::size_t numbers_without_time(const std::string& line) {
  const std::vector<std::string> fields = split_at_blanks(line);
  double number = 0;
  const bool has_numbers = std::all_of(fields.begin(), fields.end(), [&](const std::string& field) {
    return parse_number(field, number);
  });
  const std::size_t count = fields.size();
  return has_numbers && (count == kKittiNumbers || count == kMrptNumbers) ? count : 0;
}

/// x, y and phi of a line of KITTI.
std::array<double, 3> pose_of_camera(const std::vector<double>& m, const TextLines& lines) {
  const double right = m[2], forward = m[10];  // of the third column of R
  constexpr double kLevel = 0.1;
  if (!(math::hypot(right, forward) > kLevel))
    throw lines.error("the camera looks up or down", "a rotation matrix with a heading");
  return {m[11], -m[3], math::atan2(-right, forward)};
}

/// Poses without times as the rows of a log, at a constant rate.
std::vector<TrajectoryFile> read_without_times(std::string line, TextLines& lines,
                                               const std::string& where, bool sideways,
                                               const LogSelection& selection) {
  const std::size_t count = numbers_without_time(line);
  const std::string of = count == kKittiNumbers ? "KITTI" : "MRPT";
  if (!selection.columns.empty())
    throw usage_error("--columns", where + " has poses of " + of, "no --columns");
  if (!(selection.rate > 0))
    throw lines.error("poses without times (" + of + ")", "--rate HZ, poses per second");
  std::string log = "t,x,y,phi\n";
  std::size_t index = 0;
  do {
    const std::vector<double> n = numbers_of(split_at_blanks(line), count, lines);
    const auto [x, y, phi] =
        count == kKittiNumbers ? pose_of_camera(n, lines) : std::array{n[0], n[1], n[3]};
    std::vector<std::string> fields;
    for (const double number : {static_cast<double>(index++) / selection.rate, x, y, phi})
      fields.push_back(format_number(number));
    log += join(fields, ",") + "\n";
  } while (lines.next(line));
  TextLines rows(log, where);
  std::string header;
  rows.next(header);
  std::vector<TrajectoryFile> runs = read_log(header, rows, sideways, selection, false);
  const std::string meaning = count == kKittiNumbers
                                  ? "x is forward (z of the camera), y to the left (-x)"
                                  : "lines of x y z yaw pitch roll";
  runs[0].notes.insert(runs[0].notes.begin(), "poses of " + of + ": " + meaning + ", at " +
                                                  format_number(selection.rate) + " Hz");
  return runs;
}

/// Whether a line is a comment of MRPT or MATLAB: "% by ...", not "%time,field.x".
bool is_remark(const std::string& line) {
  const bool is_name = line.size() > 1 && std::isalpha(static_cast<unsigned char>(line[1])) != 0;
  return line[0] == '%' && !is_name;
}

std::vector<TrajectoryFile> read_text_log(const std::string& text, const std::string& where,
                                          bool sideways, const LogSelection& selection,
                                          bool split) {
  refuse_foreign_format(text, where, "a trajectory as CSV or TUM");
  if (is_echoed(text))
    return read_text_log(log_of_echoed(text, where), where + " (messages)", sideways, selection,
                         split);
  TextLines lines(text, where);
  std::string line;
  if (!lines.next(line))
    throw file_error(where, "empty file", "a trajectory as CSV with a header line, or as TUM");
  while (is_remark(line))
    if (!lines.next(line)) throw file_error(where, "has only comments", "a trajectory");
  if (numbers_without_time(line) > 0 && !is_header_before(line, selection.columns, lines))
    return read_without_times(line, lines, where, sideways, selection);
  if (selection.rate > 0) throw usage_error("--rate", where + " has times", "no --rate");
  return read_log(line, lines, sideways, selection, split);
}

std::string text_of_log(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error && size > kMaxBytes) throw file_error(path, "file too large", "at most 512 MiB");
  return read_text(path, "a trajectory");
}

}  // namespace

TrajectoryFile trajectory_from_text(const std::string& text, const std::string& where,
                                    bool sideways, const LogSelection& selection) {
  return std::move(read_text_log(text, where, sideways, selection, false).front());
}

std::vector<TrajectoryFile> trajectory_runs_from_text(const std::string& text,
                                                      const std::string& where, bool sideways,
                                                      const LogSelection& selection) {
  return read_text_log(text, where, sideways, selection, true);
}

TrajectoryFile load_trajectory_file(const std::string& path, bool sideways,
                                    const LogSelection& selection) {
  return trajectory_from_text(text_of_log(path), path, sideways, selection);
}

std::vector<TrajectoryFile> load_trajectory_runs(const std::string& path, bool sideways,
                                                 const LogSelection& selection) {
  return trajectory_runs_from_text(text_of_log(path), path, sideways, selection);
}

}  // namespace slalom
