#pragma once

#include <slalom/results/run_record.h>
#include <slalom/robot/robot_model.h>
#include <slalom/scenario/world.h>
#include <slalom/trajectory/trajectory.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// A result file whose runs may be laid over scenarios. A value: workers take copies of it.
struct OverlaySource {
  std::string path;
  std::string campaign;              ///< its name
  std::vector<std::string> methods;  ///< sorted
  std::optional<RobotModel> robot;   ///< that of the campaign, where the file tells it
  double resolution = 0.05;          ///< m, cells in which the campaign judged
};

/// Reads what a result file is about, not its runs. Throws Error (File). May be called on any
/// thread.
OverlaySource open_overlay_source(const std::string& path);

/// One run with its trajectory and what is plotted of it.
struct OverlayRun {
  RunRecord record;
  std::shared_ptr<const Trajectory> trajectory;  ///< null when there is none
  std::string problem;                           ///< why there is none
  std::vector<double> times;                     ///< s after the first sample, one a sample
  /// m, one a sample: of the footprint from obstacles, below 0 inside them; where the robot is not
  /// known, of its centre.
  std::vector<double> clearances;
  std::vector<double> speeds;  ///< m/s, one a sample: v, with the part to the side where there is
  /// Where the rays of the scan end (world frame, m), one a sample; empty where no scan is kept.
  std::vector<std::shared_ptr<const Path>> scans;
};

/// Fills times, clearances and speeds from the trajectory.
void fill_series(OverlayRun& run, const World& world, const std::optional<RobotModel>& robot);

/// The runs of one scenario by method and repetition, with their trajectories; none when the file
/// has none. Reads the file and computes a distance field: for a worker. Throws Error (File).
std::vector<OverlayRun> read_overlay_runs(const OverlaySource& source,
                                          const std::string& scenario_hash);

/// Of a run in words: "nd 0".
std::string overlay_label(const RunRecord& run);

/// The last sample not later than `time` (s after the first); 0 before. Requires samples.
std::size_t sample_at(const Trajectory& trajectory, double time);
/// The pose at `time`, between samples along the straight line, turning the shorter way. Requires
/// samples.
mrpt::math::TPose2D pose_at(const Trajectory& trajectory, double time);

}  // namespace slalom
