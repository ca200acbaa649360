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
#include <set>
#include <sstream>

namespace slalom {
namespace {

constexpr std::size_t kMaxLines = 1'000'000;

/// Other names of the columns of ids.
const std::set<std::string> kIdNames = {"persid", "pers_id", "personid", "person",  "person_id",
                                        "ped_id", "pedid",   "agent_id", "track_id"};

std::string id_or(const std::string& name) {
  return kIdNames.count(name) > 0 ? "id" : name;
}

/// Collects the positions of movers in the order of the file.
class MoverCollector {
 public:
  std::string hint;  ///< what else may be wrong where times do not increase

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
                         "times that increase" + hint);
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
      name = id_or(name == "time" ? "t" : name);
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

constexpr const char* kNamedOrder = "a line '# id frame x y' before lines in this order";

/// The fields of lines of numbers.
struct FrameFields {
  std::size_t count = 0, frame = 0, id = 1, x = 2, y = 3;
  double per_meter = 1;  ///< units of x and y
  bool is_named = false;
  std::optional<std::pair<std::size_t, std::size_t>> velocity = std::nullopt;
};

std::vector<std::string> frame_fields(const std::string& line) {
  std::string blanks = line;
  std::replace_if(
      blanks.begin(), blanks.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
  return split_at_blanks(blanks);
}

bool has_numbers(const std::string& line) {
  const std::vector<std::string> fields = frame_fields(line);
  double number = 0;
  return !fields.empty() && parse_number(fields[0], number);
}

/// The order that a line of names states ("# PersID Frame x/m y/m z/m"); none if it does not.
std::optional<FrameFields> named_order(const std::string& header, const TextLines& lines) {
  static const std::map<std::string, std::string> kNames = {{"id", "id"},    {"frame", "frame"},
                                                            {"fr", "frame"}, {"frame_id", "frame"},
                                                            {"x", "x"},      {"y", "y"}};
  static const std::map<std::string, double> kLengthUnits = {
      {"", 1}, {"m", 1}, {"cm", 100}, {"mm", 1000}};
  std::string names = header.substr(std::min(header.find_first_not_of("# \t"), header.size()));
  for (std::size_t i = names.size(); i-- > 1;)  // "x [m]" is one name
    if ((names[i] == '[' || names[i] == '(') && names[i - 1] == ' ') names.erase(i - 1, 1);
  const std::vector<std::string> fields = frame_fields(names);
  std::map<std::string, std::size_t> found;
  std::string duplicate;
  std::set<std::string> units;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string field = lower_case(fields[i]);
    const std::size_t unit = std::min(field.find_first_of("/[("), field.size());
    const auto name = kNames.find(id_or(field.substr(0, unit)));
    if (name == kNames.end()) continue;
    if (!found.emplace(name->second, i).second) duplicate = name->second;
    if (name->second != "x" && name->second != "y") continue;
    const std::size_t begin = std::min(field.find_first_not_of("/[(", unit), field.size());
    units.insert(field.substr(begin, field.find_last_not_of("])") + 1 - begin));
  }
  if (found.size() != 4) return std::nullopt;
  if (!duplicate.empty())
    throw lines.error("two columns of '" + duplicate + "'", "each column once");
  if (units.size() != 1 || kLengthUnits.count(*units.begin()) == 0)
    throw lines.error("unknown unit of x and y", "m, cm or mm, as in x/m y/m");
  return FrameFields{fields.size(), found["frame"], found["id"],
                     found["x"],    found["y"],     kLengthUnits.at(*units.begin()),
                     true};
}

/// The fields of lines without names: four, or the eight of an obsmat.txt.
FrameFields unnamed_order(std::size_t count, const TextLines& lines) {
  constexpr std::size_t kPositions = 4, kObsmat = 8;
  if (count == kPositions) return {kPositions};
  if (count == kObsmat) return {kObsmat, 0, 1, 2, 4, 1, false, std::pair{5, 7}};
  throw lines.error(
      std::to_string(count) + " fields",
      "4 numbers (frame id x y), or the 8 of an obsmat.txt, or " + std::string(kNamedOrder));
}

/// Compares the order of frame and id with the opposite one: people move less from line to line
/// than one person is away from another.
class FieldOrder {
 public:
  void add(double frame, double id, const mrpt::math::TPoint2D& position) {
    as_read_.add(id, position);
    opposite_.add(frame, position);
  }

  void check(const std::string& where) {
    constexpr double kClearly = 0.75;
    if (opposite_.steps.empty()) return;
    const double other = median(opposite_.steps);
    const double own =
        as_read_.steps.empty() ? std::numeric_limits<double>::infinity() : median(as_read_.steps);
    if (other < kClearly * own)
      throw file_error(where,
                       as_read_.steps.empty()
                           ? "each id has one position only"
                           : "the positions of an id are " + format_fixed(own, 2) +
                                 " m apart, in the order id frame x y " + format_fixed(other, 2) +
                                 " m",
                       "lines of frame id x y, or " + std::string(kNamedOrder));
  }

 private:
  /// Distances between successive positions of the same number.
  struct Steps {
    std::map<double, mrpt::math::TPoint2D> last;
    std::vector<double> steps;

    void add(double number, const mrpt::math::TPoint2D& position) {
      const auto [found, is_new] = last.try_emplace(number, position);
      if (!is_new)
        steps.push_back(math::hypot(position.x - found->second.x, position.y - found->second.y));
      found->second = position;
    }
  };

  Steps as_read_, opposite_;
};

/// Lines of numbers in the order that a line before them names, else frame id x y, or the eight of
/// an obsmat.txt.
void read_frames(std::string line, TextLines& lines, const std::string& where,
                 const MoversFileOptions& options, MoverCollector& movers) {
  const bool is_header = !has_numbers(line);
  auto named = named_order(is_header ? line : lines.remark(), lines);
  if (is_header && named && !lines.next(line))
    throw file_error(where, "no positions", "lines of numbers");
  const std::size_t count = frame_fields(line).size();
  const FrameFields order = named ? *named : unnamed_order(count, lines);
  if (count < order.count)
    throw lines.error(std::to_string(count) + " fields",
                      std::to_string(order.count) + " as the line of names has");
  if (!order.is_named) movers.hint = ", or " + std::string(kNamedOrder);
  FrameCollector frames(lines, options, movers);
  FieldOrder field_order;
  do {
    const auto n = numbers_of(frame_fields(line), count, lines);
    if (n[order.id] != std::round(n[order.id]) || std::abs(n[order.id]) > 1e9)
      throw lines.error("invalid id in field " + std::to_string(order.id + 1), "an integer");
    const std::string id = std::to_string(std::lround(n[order.id]));
    const double x = n[order.x] / order.per_meter, y = n[order.y] / order.per_meter;
    if (!order.is_named && !order.velocity) field_order.add(n[order.frame], n[order.id], {x, y});
    if (order.velocity)
      frames.add(id, n[order.frame], x, y, options.radius,
                 math::hypot(n[order.velocity->first], n[order.velocity->second]));
    else
      frames.add(id, n[order.frame], x, y, options.radius);
  } while (lines.next(line));
  field_order.check(where);
  frames.check(where);
}

/// The rate of a line such as "# framerate: 25.00 fps" before the positions; 0 if there is none.
double stated_frame_rate(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line) && (line.empty() || line[0] == '#');) {
    std::string words = lower_case(line);
    words.erase(
        std::remove_if(words.begin(), words.end(),
                       [](char c) { return std::string("# \t_-:=").find(c) != std::string::npos; }),
        words.end());
    constexpr char kName[] = "framerate";
    if (!starts_with(words, kName)) continue;
    words.erase(0, std::string(kName).size());
    double rate = 0;
    if (parse_number(words.substr(0, words.find_first_not_of("0123456789.")), rate)) return rate;
  }
  return 0;
}

/// The options with the frame rate that the file states.
MoversFileOptions with_stated_rate(MoversFileOptions options, const std::string& text,
                                   const std::string& where) {
  const double stated = stated_frame_rate(text);
  if (!(stated > 0)) return options;
  if (options.frame_rate > 0 && options.frame_rate != stated)
    throw file_error(where,
                     "a frame rate of " + format_number(options.frame_rate) +
                         " contradicts that of the file, " + format_number(stated),
                     "that of the file, or none");
  options.frame_rate = stated;
  return options;
}

}  // namespace

Movers movers_from_text(const std::string& text, const std::string& where,
                        const MoversFileOptions& given) {
  if (is_hunav(text)) {
    if (given.begin != 0)
      throw file_error(where, "files of HuNavSim have no times", "no time at which runs begin");
    return hunav_agents(text, where);
  }
  const MoversFileOptions options = with_stated_rate(given, text, where);
  TextLines lines(text, where);
  std::string line;
  const std::string expected = "CSV with the columns id, t, x, y, or lines of frame id x y";
  if (!lines.next(line)) throw file_error(where, "empty file", expected);
  MoverCollector movers(lines, options);
  const bool is_named = has_numbers(line) && named_order(lines.remark(), lines);
  if (line.find(',') != std::string::npos && !is_named)
    read_csv(line, lines, where, options, movers);
  else
    read_frames(line, lines, where, options, movers);
  return movers.take(where);
}

Movers load_movers_file(const std::string& path, const MoversFileOptions& options) {
  return movers_from_text(read_text(path, "positions of moving obstacles"), path, options);
}

}  // namespace slalom
