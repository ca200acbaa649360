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

/// A result file whose runs can be overlaid on scenarios. A value type: workers copy it.
struct OverlaySource {
  std::string path;
  std::string campaign;              ///< name of the campaign
  std::vector<std::string> methods;  ///< sorted
  std::optional<RobotModel> robot;   ///< of the campaign, if the file contains it
  double resolution = 0.05;          ///< m, cell size used by the campaign
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
};

/// Fills times, clearances and speeds from the trajectory.
void fill_series(OverlayRun& run, const World& world, const std::optional<RobotModel>& robot);

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

}  // namespace slalom
