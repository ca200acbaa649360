#pragma once

#include <slalom/robot/footprint.h>
#include <slalom/studio/overlay_run.h>
#include <slalom/studio/palette.h>
#include <slalom/studio/replay_clock.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// One run to be drawn over its scenario, at one time of its replay.
struct OverlayTrajectory {
  std::string label;    ///< e.g. "nd 0": method and repetition
  std::string outcome;  ///< e.g. "success"; the end is marked in outcome_color()
  Color color;
  std::shared_ptr<const Trajectory> trajectory;  ///< the complete run; not null, not empty
  double time = 0;                               ///< of the replay, s after the first sample
  std::size_t sample = 0;                        ///< index of the last sample not later than `time`
  mrpt::math::TPose2D pose;            ///< at `time`, interpolated; the last one afterwards
  std::optional<Footprint> footprint;  ///< of the robot, if known
  std::shared_ptr<const Path> scan;    ///< end points of the scan at `pose`, or null
};

/// One row of the table of runs: a run, or a method followed by its runs.
struct OverlayRow {
  std::string label;              ///< "nd", "nd 3"
  std::vector<std::size_t> runs;  ///< indices of the runs it shows or hides
  bool group = false;             ///< a method; the rows of its runs follow
  bool indented = false;          ///< a run below its method
  bool shown = false;             ///< whether any of its runs is
  Color color;                    ///< of the method
  std::string outcome;            ///< "success"; of a group the common outcome, or "mixed"
  std::string success;            ///< "yes" or "no"; of a group e.g. "2 of 3"
  Value length = Value::na("several runs");  ///< m
  Value time = Value::na("several runs");    ///< s, to the goal
  std::string detail;                        ///< description in one line
};

/// The runs in the current scenario, which of them are visible, and their replay. Independent of
/// the window; not thread-safe.
class ResultsOverlay {
 public:
  /// Sets the result file; its runs are set by set_runs(). Makes all methods visible.
  void set_source(OverlaySource source);
  const OverlaySource& source() const { return source_; }
  bool is_open() const { return !source_.path.empty(); }

  /// Sets the runs of the current scenario, as returned by read_overlay_runs(), and seeks the
  /// replay to their end. Hidden runs stay hidden.
  void set_runs(std::vector<OverlayRun> runs);
  const std::vector<OverlayRun>& runs() const { return runs_; }

  std::vector<OverlayRow> rows() const;
  bool is_shown(std::size_t run) const;
  /// Hides the runs of the row if any of them is shown, otherwise shows all of them.
  void toggle(const OverlayRow& row);
  void show_all(bool shown);

  ReplayClock& clock() { return clock_; }
  const ReplayClock& clock() const { return clock_; }

  /// The visible runs that have a trajectory, at the time of the clock.
  std::vector<OverlayTrajectory> trajectories() const;
  /// Depends on the index of the method in the file, so that it is the same in all scenarios.
  Color color_of(std::size_t run) const;
  /// Clearance (m) and speed (m/s) at the time of the clock, interpolated as in the plots; nullopt
  /// after the run's end.
  std::optional<double> clearance_now(std::size_t run) const;
  std::optional<double> speed_now(std::size_t run) const;

 private:
  OverlayRow make_row(std::size_t run, bool indented) const;
  OverlayRow make_group(std::size_t first, std::size_t end) const;
  std::optional<double> now(std::size_t run, const std::vector<double>& series) const;
  void update_duration();

  OverlaySource source_;
  std::vector<OverlayRun> runs_;
  std::set<std::pair<std::string, int>> hidden_;  ///< method and repetition
  ReplayClock clock_;
};

}  // namespace slalom
