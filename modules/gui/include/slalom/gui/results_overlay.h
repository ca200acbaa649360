#pragma once

#include <slalom/gui/overlay_run.h>
#include <slalom/gui/overlay_trajectory.h>
#include <slalom/gui/replay_clock.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// One line of the table of runs: a run, or a method with several of them, which stand below it.
struct OverlayRow {
  std::string label;              ///< "nd", "nd 3"
  std::vector<std::size_t> runs;  ///< places of the runs it switches
  bool group = false;             ///< a method; its runs follow
  bool indented = false;          ///< a run below its method
  bool shown = false;             ///< any of its runs is
  nanogui::Color color;           ///< of the method
  std::string outcome;            ///< "success"; of a group that of all its runs, or "mixed"
  std::string success;            ///< "yes", "no"; of a group "2 of 3"
  Value length = Value::na("several runs");  ///< m
  Value time = Value::na("several runs");    ///< s, to the goal
  std::string detail;                        ///< all that is known of it in one line
};

/// Runs of methods in the scenario that is shown, which of them are drawn, and their replay. Has no
/// window; belongs to one thread.
class ResultsOverlay {
 public:
  /// Another result file; its runs come by set_runs(). All methods are shown again.
  void set_source(OverlaySource source);
  const OverlaySource& source() const { return source_; }
  bool is_open() const { return !source_.path.empty(); }

  /// The runs of the scenario that is shown now, as read_overlay_runs() gives them; the replay
  /// stands at their end. What was hidden stays hidden.
  void set_runs(std::vector<OverlayRun> runs);
  const std::vector<OverlayRun>& runs() const { return runs_; }

  std::vector<OverlayRow> rows() const;
  bool is_shown(std::size_t run) const;
  /// Hides what the row switches if any of it is shown, otherwise shows all of it.
  void toggle(const OverlayRow& row);
  void show_all(bool shown);

  ReplayClock& clock() { return clock_; }
  const ReplayClock& clock() const { return clock_; }

  /// Those that are shown and have a trajectory, at the time of the clock.
  std::vector<OverlayTrajectory> trajectories() const;
  /// By the place of the method among all of the file, so that it never changes.
  nanogui::Color color_of(std::size_t run) const;
  /// Clearance and speed at the time of the clock, between samples as the plots draw them; none
  /// after the run's end.
  std::optional<double> clearance_now(std::size_t run) const;
  std::optional<double> speed_now(std::size_t run) const;

 private:
  OverlayRow row_of(std::size_t run, bool indented) const;
  OverlayRow group_of(std::size_t first, std::size_t end) const;
  std::optional<double> now(std::size_t run, const std::vector<double>& series) const;
  void update_duration();

  OverlaySource source_;
  std::vector<OverlayRun> runs_;
  std::set<std::pair<std::string, int>> hidden_;  ///< method and repetition
  ReplayClock clock_;
};

}  // namespace slalom
