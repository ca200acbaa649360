// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/enum_names.h>
#include <slalom/core/scratch_folder.h>
#include <slalom/io/result_fields.h>
#include <slalom/results/run_record.h>
#include <slalom/robot/footprint.h>
#include <slalom/robot/robot_model.h>
#include <slalom/scenario/world.h>
#include <slalom/simulation/simulate.h>
#include <slalom/studio/jobs.h>
#include <slalom/studio/palette.h>
#include <slalom/studio/studio_events.h>
#include <slalom/trajectory/trajectory.h>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// Time, state and speed of a replay. Times in s from the first sample.
class ReplayClock {
 public:
  double time() const { return time_; }
  double duration() const { return duration_; }
  bool playing() const { return playing_; }
  double speed() const { return speeds()[speed_]; }  ///< simulated s per s of real time
  static const std::vector<double>& speeds();
  std::string speed_text() const;  ///< "0.5x"

  /// Negative and non-finite durations count as 0. The time is clamped; at the old end it moves to
  /// the new end.
  void set_duration(double duration);
  void seek(double time);  ///< clamped to [0, duration]; NaN is the start
  void play();             ///< from the start if at the end; ignored if the duration is 0
  void pause() { playing_ = false; }
  void toggle() { playing_ ? pause() : play(); }
  void faster();
  void slower();
  /// Advances by seconds of real time; pauses at the end. Returns whether `time` changed.
  bool advance(double seconds);
  /// Advances to `now` (s, of any steady clock); called for every frame.
  void tick(double now);

 private:
  double time_ = 0, duration_ = 0;
  bool playing_ = false;
  std::size_t speed_ = 2;  ///< 1x
  double last_tick_ = -1;  ///< `now` of the last tick(); negative if the replay was paused
};

/// A result file whose runs can be overlaid on scenarios. A value type: workers copy it.
struct OverlaySource {
  std::string path;
  std::string campaign;              ///< name of the campaign
  std::vector<std::string> methods;  ///< sorted
  std::optional<RobotModel> robot;   ///< of the campaign, if the file contains it
  SimulationOptions simulation;      ///< of the campaign, as far as the file contains it
  PeopleSettings people;             ///< likewise
  bool here = false;                 ///< the methods were run in the window: a temporary file
};

/// Reads the properties of a result file, not its runs. Throws Error (File). Thread-safe.
OverlaySource open_overlay_source(const std::string& path);

/// One run with its trajectory and the plotted series.
struct OverlayRun {
  RunRecord record;
  std::shared_ptr<const Trajectory> trajectory;  ///< may be null
  std::string problem;                           ///< why trajectory is null
  std::vector<double> times;                     ///< s after the first sample, one per sample
  /// m, one per sample: distance of the footprint from obstacles, negative inside them; of the
  /// robot's center if the footprint is unknown.
  std::vector<double> clearances;
  std::vector<double> speeds;  ///< m/s, one per sample: v or, if vy != 0, the norm of (v, vy)
  /// End points of the scan (world frame, m), one per sample; empty if no scans are recorded.
  std::vector<std::shared_ptr<const Path>> scans;
  /// The people of the scenario as they walked in this run, at the times of the samples; empty if
  /// the robot or the trajectory is unknown.
  Movers people;
};

/// Fills times, clearances and speeds from the trajectory.
void fill_series(OverlayRun& run, const World& world, const std::optional<RobotModel>& robot);

/// Recomputes how the people of the scenario walked in the run.
void fill_people(OverlayRun& run, const World& world, const OverlaySource& source);

/// The runs of one scenario by method and repetition, with their trajectories; may be empty.
/// Reads the file and computes a distance field: call it in a worker. Throws Error (File).
std::vector<OverlayRun> read_overlay_runs(const OverlaySource& source,
                                          const std::string& scenario_hash);

/// Method and repetition: "nd 0".
std::string overlay_label(const RunRecord& run);

/// The index of the last sample not later than `time` (s after the first); 0 before it. Requires
/// samples.
std::size_t sample_at(const Trajectory& trajectory, double time);
/// The pose at `time`, linearly interpolated between samples, the heading along the shorter arc.
/// Requires samples.
mrpt::math::TPose2D pose_at(const Trajectory& trajectory, double time);

/// Kinds of values that the color along the line of a run shows.
enum class RunColoring { Method, Speed, Clearance };
constexpr auto enum_names(RunColoring) {
  return std::array{"method", "speed", "clearance"};
}

/// A part of a line in one color, between the samples `begin` and `end`, both included.
struct ColoredPart {
  std::size_t begin, end;
  Color color;
};

/// The line through these values, each part in the color of the value at its begin on a scale from
/// 0 to `maximum`. Adjacent parts differ by at least 1/32 of the scale. Other values, and NaN, have
/// the color of the nearer end or of 0.
std::vector<ColoredPart> colored_parts(const std::vector<double>& values, double maximum);

/// One run to be drawn over its scenario, at one time of its replay.
struct OverlayTrajectory {
  std::string label;    ///< e.g. "nd 0": method and repetition
  std::string outcome;  ///< e.g. "success"; the end is marked in outcome_color()
  Color color;
  std::size_t run = 0;                           ///< index in ResultsOverlay::runs()
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
  /// The same, but hidden runs stay hidden.
  void change_source(OverlaySource source);
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

  /// The run that actions apply to; none for a method with several runs, and after set_runs().
  void select(std::optional<std::size_t> run) { selected_ = run; }
  const RunRecord* selected() const { return selected_ ? &runs_[*selected_].record : nullptr; }

  /// The time (s of a run) up to which the clock goes while no run is shown: that of the movers of
  /// the scenario. The clock keeps its time as far as it can, so that an edit is seen where it was.
  void set_movers_duration(double duration);
  bool replays_runs() const;  ///< whether a run with a trajectory is shown
  /// The time of the scenario (s of a run) at the clock.
  double scene_time() const;

  /// The people of the scenario as they walk in the selected run or, if that is not shown, in the
  /// first one that is; without runs each stands where it starts.
  Movers people_in(const Scenario& scenario) const;

  RunColoring coloring() const { return coloring_; }
  void set_coloring(RunColoring coloring) { coloring_ = coloring; }
  /// The values of the coloring, one per sample (m/s or m); null for that by method.
  const std::vector<double>* colored_values(std::size_t run) const;
  /// The maximum of these values over all runs of the scenario, also hidden ones; at least 0.
  double max_colored_value() const;

  /// A sample of a run that is shown.
  struct RunSample {
    std::size_t run, sample;
  };
  /// The one closest to a position, at most `radius` (m) away.
  std::optional<RunSample> sample_near(const mrpt::math::TPoint2D& at, double radius) const;
  /// "nd 0 at 3.40 s: 0.51 m/s, clearance 0.420 m".
  std::string sample_text(const RunSample& at) const;

  /// The times (s after the first sample) that plots show; none is all of them, as after
  /// set_runs().
  const std::optional<std::pair<double, double>>& shown_times() const { return shown_times_; }
  /// From `first` to `last` in either order, clamped to the time of the replay; ignored if nothing
  /// is between them.
  void show_times(double first, double last);
  void show_all_times() { shown_times_.reset(); }

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
  std::optional<std::size_t> selected_;
  std::set<std::pair<std::string, int>> hidden_;  ///< method and repetition
  ReplayClock clock_;
  RunColoring coloring_ = RunColoring::Method;
  std::optional<std::pair<double, double>> shown_times_;
  double movers_duration_ = 0;
};

/// The overlay of recorded runs: loads those of the current scenario from the open result file in
/// background jobs. Publishes Change::Runs.
class ResultsLoader {
 public:
  using Opened = std::function<void(const std::string& path)>;
  /// Calls `opened` when a file was opened.
  ResultsLoader(
      Jobs& jobs, StudioEvents& events, Opened opened = [](const std::string&) {})
      : jobs_(jobs), events_(events), opened_(std::move(opened)) {}

  ResultsOverlay& overlay() { return overlay_; }
  const ResultsOverlay& overlay() const { return overlay_; }
  const std::string& message() const { return message_; }  ///< why there are no runs
  /// The results as fields of filters and sorting; null if no file is open.
  const std::shared_ptr<const ResultFields>& fields() const { return fields_; }

  /// Opens a file. This and close() discard the runs that were made here.
  void open(const std::string& path);
  void close();
  const std::string& path() const { return file_.path; }  ///< of the open file; empty for none

  /// From now on shows these runs of a scenario in place of those in the open file. `folder`
  /// contains the source and lives as long as the runs are kept.
  void show_here(const std::string& scenario_hash, OverlaySource source,
                 std::shared_ptr<const ScratchFolder> folder);
  /// Whether such runs of the current scenario are shown.
  bool shows_here() const { return here_.count(hash_) > 0; }
  void discard_here();  ///< those of the current scenario
  /// Sets the current scenario by its hash; empty for none. Ignored if it is unchanged.
  void show(const std::string& scenario_hash);
  /// Shows these runs, whatever the current scenario is.
  void show_runs(const OverlaySource& source, std::vector<OverlayRun> runs,
                 const std::string& message = "");
  void toggle(const OverlayRow& row);  ///< see ResultsOverlay
  void show_all(bool shown);
  /// Plays the runs of the current scenario from their start, as soon as they are read.
  void replay();
  /// Why replay() has no effect; empty if it has.
  std::string replay_disabled_reason() const;

 private:
  void read_runs();
  void set_runs(std::vector<OverlayRun> runs, const std::string& message);

  Jobs& jobs_;
  StudioEvents& events_;
  Opened opened_;
  ResultsOverlay overlay_;
  std::shared_ptr<const ResultFields> fields_;
  struct RunsHere {
    OverlaySource source;
    std::shared_ptr<const ScratchFolder> folder;
  };
  OverlaySource file_;                    ///< no path if none is open
  std::map<std::string, RunsHere> here_;  ///< by the hash of the scenario
  bool replay_when_read_ = false;
  std::string hash_, message_ = "No result file is open.";
};

}  // namespace slalom
