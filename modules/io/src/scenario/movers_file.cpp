// SPDX-License-Identifier: BSD-3-Clause
#include "../text_lines.h"
#include "hunav_agents.h"

#include <slalom/core/math.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/io/movers_file.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

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

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Derives the frame rate and the unit of length from the positions and velocities of people.
class ImpliedUnits {
 public:
  /// `speed` is NaN if the file does not have it.
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

/// Frames of a recording as times, with a check of the rate and the unit of length.
class FrameCollector {
 public:
  FrameCollector(const TextLines& lines, const MoversFileOptions& options, MoverCollector& movers)
      : options_(options), movers_(movers) {
    if (!(options.frame_rate > 0))
      throw lines.error("frames instead of times", "the frame rate of the recording");
  }

  void add(const std::string& id, double frame, double x, double y, double radius,
           double speed = std::numeric_limits<double>::quiet_NaN()) {
    implied_.add(frame, id, {x, y}, speed);
    movers_.add(id, frame / options_.frame_rate, x, y, radius);
  }

  void check(const std::string& where) { implied_.check(options_.frame_rate, where); }

 private:
  const MoversFileOptions& options_;
  MoverCollector& movers_;
  ImpliedUnits implied_;
};

/// The columns of a CSV.
class Columns {
 public:
  Columns(std::vector<std::string> names, const TextLines& lines) : names_(std::move(names)) {
    static const std::vector<std::string> kKnown = {"id",    "t",  "x",  "y",    "r",
                                                    "frame", "vx", "vy", "type", "label"};
    for (const std::string& written : std::vector<std::string>(names_)) {
      std::string& name = names_[seen_++];
      if (ends_with(name, "_est")) name.resize(name.size() - 4);
      if (!contains(kKnown, name))
        throw lines.error("unknown column '" + written + "'",
                          "a header line with id, t or frame, x, y, and optionally r, type");
      if (index(name) + 1 != seen_)
        throw lines.error("duplicate column '" + written + "'", "each column once");
    }
    for (const std::string name : {"id", has("frame") ? "frame" : "t", "x", "y"})
      if (!has(name))
        throw lines.error("missing column '" + name + "'",
                          "a header line with id, t or frame, x, y");
    if (has("frame") && has("t")) throw lines.error("columns 't' and 'frame'", "times or frames");
  }

  bool has(const std::string& name) const { return index(name) < names_.size(); }

  /// Takes a line apart; texts are left out of the numbers.
  void read(const std::string& line, const TextLines& lines) {
    std::vector<std::string> fields = split(line, ',');
    for (std::size_t i = 0; i < std::min(fields.size(), names_.size()); ++i) {
      if (names_[i] == "id") id_ = fields[i];
      if (names_[i] == "id" || names_[i] == "type" || names_[i] == "label") fields[i] = "0";
    }
    numbers_ = numbers_of(fields, names_.size(), lines);
  }
  const std::string& id() const { return id_; }
  double operator[](const std::string& name) const { return numbers_[index(name)]; }
  double get(const std::string& name, double missing) const {
    return has(name) ? (*this)[name] : missing;
  }

 private:
  std::size_t index(const std::string& name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    return static_cast<std::size_t>(found - names_.begin());
  }

  std::vector<std::string> names_;
  std::size_t seen_ = 0;
  std::string id_;
  std::vector<double> numbers_;
};

void read_csv(const std::string& header, TextLines& lines, const std::string& where,
              const MoversFileOptions& options, MoverCollector& movers) {
  Columns columns(split(header, ','), lines);
  std::optional<FrameCollector> frames;
  if (columns.has("frame")) frames.emplace(lines, options, movers);
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (std::string line; lines.next(line);) {
    columns.read(line, lines);
    const double radius = columns.get("r", options.radius);
    if (frames)
      frames->add(columns.id(), columns["frame"], columns["x"], columns["y"], radius,
                  math::hypot(columns.get("vx", kNone), columns.get("vy", kNone)));
    else
      movers.add(columns.id(), columns["t"], columns["x"], columns["y"], radius);
  }
  if (frames) frames->check(where);
}

/// Lines of four numbers, frame id x y, or the eight of an obsmat.txt.
void read_frames(std::string line, TextLines& lines, const std::string& where,
                 const MoversFileOptions& options, MoverCollector& movers) {
  constexpr std::size_t kPositions = 4, kObsmat = 8;
  const std::size_t count = split_at_blanks(line).size();
  if (count != kPositions && count != kObsmat)
    throw lines.error(std::to_string(count) + " fields",
                      "4 numbers (frame id x y), or the 8 of an obsmat.txt");
  FrameCollector frames(lines, options, movers);
  do {
    const auto n = numbers_of(split_at_blanks(line), count, lines);
    if (n[1] != std::round(n[1]) || std::abs(n[1]) > 1e9)
      throw lines.error("invalid id in field 2", "an integer");
    const std::string id = std::to_string(std::lround(n[1]));
    if (count == kPositions)
      frames.add(id, n[0], n[2], n[3], options.radius);
    else
      frames.add(id, n[0], n[2], n[4], options.radius, math::hypot(n[5], n[7]));
  } while (lines.next(line));
  frames.check(where);
}

}  // namespace

Movers movers_from_text(const std::string& text, const std::string& where,
                        const MoversFileOptions& options) {
  if (is_hunav(text)) {
    if (options.begin != 0)
      throw file_error(where, "agents of HuNavSim have no times", "no time at which runs begin");
    return hunav_agents(text, where);
  }
  TextLines lines(text, where);
  std::string line;
  const std::string expected = "CSV with the columns id, t, x, y, or lines of frame id x y";
  if (!lines.next(line)) throw file_error(where, "empty file", expected);
  MoverCollector movers(lines, options);
  if (line.find(',') != std::string::npos)
    read_csv(line, lines, where, options, movers);
  else
    read_frames(line, lines, where, options, movers);
  return movers.take(where);
}

Movers load_movers_file(const std::string& path, const MoversFileOptions& options) {
  return movers_from_text(read_text(path, "positions of moving obstacles"), path, options);
}

}  // namespace slalom
