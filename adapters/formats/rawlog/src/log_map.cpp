// SPDX-License-Identifier: BSD-3-Clause
#include "rawlog_format.h"

#include <slalom/bags/bag_trajectory.h>
#include <slalom/bags/frame_tree.h>
#include <slalom/bags/ros_messages.h>
#include <slalom/core/distance.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>
#include <slalom/rawlog/laser_log.h>
#include <slalom/rawlog/log_map.h>
#include <slalom/robot/range_scan.h>
#include <slalom/scenario/grid_map.h>

#include <mrpt/math/wrap2pi.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/poses/CPose2DInterpolator.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace slalom {
namespace {

using mrpt::maps::COccupancyGridMap2D;
using mrpt::math::TPoint2D;
using mrpt::math::TPose2D;
using mrpt::obs::CObservationOdometry;

/// A rectangle that grows with its points.
class Extent {
 public:
  void add(const TPoint2D& p) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
  }

  /// A grid of unknown cells with `margin` (m) around the points.
  COccupancyGridMap2D grid(double resolution, double margin, const std::string& path) const {
    const double x_min = std::floor((low_.x - margin) / resolution) * resolution;
    const double y_min = std::floor((low_.y - margin) / resolution) * resolution;
    const double size_x = std::ceil((high_.x + margin - x_min) / resolution);
    const double size_y = std::ceil((high_.y + margin - y_min) / resolution);
    if (!(size_x * size_y <= kMaxGridCells))
      throw file_error(path,
                       "covers " + format_fixed(size_x * resolution, 0) + " x " +
                           format_fixed(size_y * resolution, 0) + " m",
                       "at most 400 million cells of " + format_number(resolution) + " m");
    auto grid = make_grid_map(static_cast<int>(size_x), static_cast<int>(size_y), resolution,
                              {x_min, y_min});
    grid.fill(0.5F);
    return grid;
  }

 private:
  TPoint2D low_{HUGE_VAL, HUGE_VAL}, high_{-HUGE_VAL, -HUGE_VAL};
};

/// Calls `use(x, y)` for the cells whose centers a disc of `radius` and half a cell's diagonal
/// covers.
template <typename Use>
void for_cells_of_disc(const COccupancyGridMap2D& grid, const TPoint2D& center, double radius,
                       Use use) {
  const double reach = radius + grid.getResolution() * M_SQRT1_2;
  const int last_x = static_cast<int>(grid.getSizeX()) - 1;
  const int last_y = static_cast<int>(grid.getSizeY()) - 1;
  const auto x = [&](double at) {
    return std::clamp(grid.x2idx(static_cast<float>(at)), 0, last_x);
  };
  const auto y = [&](double at) {
    return std::clamp(grid.y2idx(static_cast<float>(at)), 0, last_y);
  };
  for (int cy = y(center.y - reach); cy <= y(center.y + reach); ++cy)
    for (int cx = x(center.x - reach); cx <= x(center.x + reach); ++cx) {
      const TPoint2D cell(static_cast<double>(grid.idx2x(static_cast<std::size_t>(cx))),
                          static_cast<double>(grid.idx2y(static_cast<std::size_t>(cy))));
      if (distance_between(cell, center) <= reach) use(cx, cy);
    }
}

/// The positions along the poses, at most a cell apart.
std::vector<TPoint2D> points_along(const std::vector<TPose2D>& poses, double resolution) {
  std::vector<TPoint2D> points;
  std::optional<TPoint2D> last;
  for (const TPose2D& pose : poses) {
    const TPoint2D to(pose);
    const TPoint2D from = last.value_or(to);
    const double length = distance_between(from, to);
    if (last && length < 0.5 * resolution) continue;
    const int steps = std::max(1, static_cast<int>(std::ceil(length / resolution)));
    // Poses that are further apart than this are not those of one motion.
    constexpr double kJump = 1;  // m
    for (int i = length > kJump ? steps : 1; i <= steps; ++i)
      points.push_back(from + (to - from) * (static_cast<double>(i) / steps));
    last = to;
  }
  return points;
}

/// Makes unseen cells free within `reach` (m) of the points, unless obstacles are in between.
void clear_unseen(COccupancyGridMap2D& grid, const std::vector<TPoint2D>& points, double reach) {
  constexpr std::uint8_t kOutside = 0, kInReach = 1, kDone = 2;
  const int size_x = static_cast<int>(grid.getSizeX()), size_y = static_cast<int>(grid.getSizeY());
  const auto unseen = COccupancyGridMap2D::p2l(0.5F);
  std::vector<std::uint8_t> cells(static_cast<std::size_t>(size_x) * size_y, kOutside);
  const auto cell = [&](int x, int y) -> std::uint8_t& {
    return cells[static_cast<std::size_t>(y) * size_x + x];
  };
  for (const TPoint2D& point : points)
    for_cells_of_disc(grid, point, reach, [&](int x, int y) { cell(x, y) = kInReach; });
  std::vector<std::pair<int, int>> open;
  const auto visit = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= size_x || y >= size_y || cell(x, y) != kInReach) return;
    cell(x, y) = kDone;
    auto& value = grid.getRow(y)[x];
    if (value < unseen) return;
    if (value == unseen) grid.setCell(x, y, 1.0F);
    open.emplace_back(x, y);
  };
  for (const TPoint2D& point : points) for_cells_of_disc(grid, point, 0, visit);
  while (!open.empty()) {
    const auto [x, y] = open.back();
    open.pop_back();
    visit(x - 1, y);
    visit(x + 1, y);
    visit(x, y - 1);
    visit(x, y + 1);
  }
}

/// m: unseen cells within it count as free, enough for the margins at which methods plan and turn.
double free_reach(const LogMapOptions& options) {
  return 4 * options.robot_radius;
}

/// Makes free what a robot covered along its poses, and what it did not see near them.
void clear_path(LogMap& map, const std::vector<TPose2D>& poses, const LogMapOptions& options) {
  COccupancyGridMap2D& grid = map.grid;
  const std::vector<TPoint2D> points = points_along(poses, grid.getResolution());
  for (const TPoint2D& point : points)
    for_cells_of_disc(grid, point, options.robot_radius,
                      [&](int x, int y) { grid.setCell(x, y, 1.0F); });
  clear_unseen(grid, points, free_reach(options));
  map.start = poses.front();
  map.goal = TPoint2D(poses.back());
}

/// The grid without the rows and columns at the borders in which no cell is free, but `margin`
/// cells.
COccupancyGridMap2D cropped(const COccupancyGridMap2D& grid, int margin) {
  const int size_x = static_cast<int>(grid.getSizeX()), size_y = static_cast<int>(grid.getSizeY());
  int left = size_x, right = -1, low = size_y, high = -1;
  for (int y = 0; y < size_y; ++y)
    for (int x = 0; x < size_x; ++x) {
      if (grid.getCell(x, y) <= 0.5F) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      low = std::min(low, y);
      high = std::max(high, y);
    }
  left = std::max(0, left - margin);
  low = std::max(0, low - margin);
  right = std::min(size_x - 1, right + margin);
  high = std::min(size_y - 1, high + margin);
  const double resolution = grid.getResolution();
  auto part =
      make_grid_map(right - left + 1, high - low + 1, resolution,
                    {grid.getXMin() + left * resolution, grid.getYMin() + low * resolution});
  for (int y = low; y <= high; ++y)
    std::copy_n(grid.getRow(y) + left, right - left + 1, part.getRow(y - low));
  return part;
}

bool has_moved(const TPose2D& from, const TPose2D& to) {
  constexpr double kDistance = 0.1, kAngle = 0.1;  // m, rad
  return distance_between(from, to) >= kDistance ||
         std::abs(mrpt::math::wrapToPi(to.phi - from.phi)) >= kAngle;
}

/// The poses of a log's odometry at their times.
mrpt::poses::CPose2DInterpolator timed_odometry(const LogObjects& log) {
  mrpt::poses::CPose2DInterpolator poses;
  poses.setInterpolationMethod(mrpt::poses::imLinear2Neig);
  constexpr std::chrono::seconds kMaxGap{1};
  poses.setMaxTimeInterpolation(kMaxGap);
  for (const auto& object : log.objects) {
    const auto odometry = std::dynamic_pointer_cast<const CObservationOdometry>(object);
    if (!odometry || odometry->sensorLabel == kCommandLabel ||
        odometry->timestamp == INVALID_TIMESTAMP)
      continue;
    const TPose2D pose = odometry->odometry.asTPose();
    if (std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.phi))
      poses.insert(odometry->timestamp, pose);
  }
  return poses;
}

/// The scans of a log with the odometry at their times; where there is none, the latest before it.
std::vector<LoggedScan> scans_with_poses(const LogObjects& log) {
  std::vector<LoggedScan> scans = read_laser_log(log);
  auto odometry = timed_odometry(log);
  for (LoggedScan& scan : scans) {
    TPose2D pose;
    bool is_known = false;
    if (scan.scan->timestamp != INVALID_TIMESTAMP)
      odometry.interpolate(scan.scan->timestamp, pose, is_known);
    if (is_known) scan.odometry = pose;
  }
  return scans;
}

/// The scans of places that are not the same, with their odometry.
std::vector<LoggedScan> scans_along(std::vector<LoggedScan> scans) {
  std::vector<LoggedScan> chosen;
  for (LoggedScan& scan : scans)
    if (scan.odometry && (chosen.empty() || has_moved(*chosen.back().odometry, *scan.odometry)))
      chosen.push_back(std::move(scan));
  return chosen;
}

LogMap load_map_of_scans(const std::string& path, const LogMapOptions& options) {
  return map_of_scans(load_log(path, options.topics), path, options);
}

/// The map of a bag and its frames.
struct BagMap {
  std::string topic;  ///< "" if there is none
  RosGrid grid;       ///< the last one
  FrameTree frames;
};

BagMap map_in_bag(const std::string& path) {
  BagMap map;
  read_bag(path, [&](const BagMessage& message) {
    if (is_one_of(kTransformTypes, message.topic.type))
      for (const RosTransform& transform : decode_transforms(message)) map.frames.add(transform);
    // The map among several, such as costmaps, is that of map_server and SLAM.
    const bool is_grid = is_one_of(kGridTypes, message.topic.type);
    if (!is_grid ||
        (!map.topic.empty() && map.topic != message.topic.name && message.topic.name != "/map"))
      return;
    map.topic = message.topic.name;
    map.grid = decode_grid(message);
  });
  return map;
}

/// With the thresholds of nav2's map_saver.
COccupancyGridMap2D to_grid(const RosGrid& from, const std::string& where) {
  constexpr int kOccupied = 65, kFree = 25;  // per cent
  constexpr double kNoTurn = 1e-6;
  if (!from.origin.is_valid() || !(from.resolution > 0) || !std::isfinite(from.resolution) ||
      from.width == 0 || from.height == 0 || std::abs(from.origin.yaw()) > kNoTurn)
    throw file_error(where, "is empty or rotated", "cells whose origin is not rotated");
  if (static_cast<double>(from.width) * from.height > kMaxGridCells)
    throw file_error(where, "has more than 400 million cells", "a smaller map");
  auto grid = make_grid_map(static_cast<int>(from.width), static_cast<int>(from.height),
                            from.resolution, {from.origin.x, from.origin.y});
  for (std::size_t i = 0; i < from.cells.size(); ++i) {
    const std::int8_t value = from.cells[i];
    const float free = value >= kOccupied ? 0.0F : value >= 0 && value <= kFree ? 1.0F : 0.5F;
    grid.setCell(static_cast<int>(i % from.width), static_cast<int>(i / from.width), free);
  }
  return grid;
}

LogMap map_of_bag(const std::string& path, const LogMapOptions& options) {
  const BagMap from = map_in_bag(path);
  if (from.topic.empty()) return load_map_of_scans(path, options);
  const std::string topic = printable_line(from.topic);
  const std::string frame = from.grid.header.frame.empty() ? "map" : from.grid.header.frame;
  const std::string usual = from.frames.has("base_link") ? "base_link" : "base_footprint";
  const std::string base = options.topics.base.empty() ? usual : options.topics.base;
  std::vector<std::string> moving;
  if (!from.frames.pose_in(frame, base, moving)) {
    LogMap map = load_map_of_scans(path, options);
    map.notes.push_back("'" + topic + "' is not used: no transforms from '" +
                        printable_line(frame) + "' to '" + base + "'");
    return map;
  }
  const TrajectoryFile drive = load_bag_trajectory(path, "/tf:" + frame + "." + base, true);
  LogMap map;
  map.grid = to_grid(from.grid, path + ": " + topic);
  std::vector<TPose2D> poses;
  for (const Sample& sample : drive.trajectory.samples) poses.push_back(sample.pose);
  clear_path(map, poses, options);
  map.notes = {"map of '" + topic + "'", drive.notes.front()};
  return map;
}

}  // namespace

LogMap map_of_scans(const LogObjects& log, const std::string& path, const LogMapOptions& options) {
  const std::vector<LoggedScan> all = scans_with_poses(log);
  const std::vector<LoggedScan> scans = scans_along(all);
  if (scans.size() < 2)
    throw file_error(path, scans.empty() ? "has no odometry" : "the robot does not move",
                     "scans and odometry of a drive");
  std::vector<TPose2D> poses;
  for (const LoggedScan& scan : all)
    if (scan.odometry) poses.push_back(*scan.odometry);
  LogMap map;
  Extent extent;
  for (const TPose2D& pose : poses) extent.add(TPoint2D(pose));
  for (const LoggedScan& scan : scans)
    for (const TPoint2D& point : scan_points(*scan.scan))
      extent.add(scan.odometry->composePoint(point));
  map.grid = extent.grid(options.resolution, free_reach(options), path);
  auto& insertion = map.grid.insertionOptions;
  insertion.considerInvalidRangesAsFreeSpace = false;
  insertion.maxDistanceInsertion = HUGE_VALF;
  for (const LoggedScan& scan : scans) {
    const mrpt::poses::CPose3D at{mrpt::poses::CPose2D(*scan.odometry)};
    map.grid.insertObservation(*scan.scan, at);
  }
  clear_path(map, poses, options);
  constexpr int kMargin = 4;  // cells
  map.grid = cropped(map.grid, kMargin);
  map.notes = log.notes;
  map.notes.push_back("grid of " + count_text(scans.size(), "scan") +
                      " along the odometry, whose drift it has");
  return map;
}

bool is_log(const std::string& path) {
  return ends_with(path, ".rawlog") || ends_with(path, ".rawlog.gz") || is_bag(path);
}

LogMap load_log_map(const std::string& path, const LogMapOptions& options) {
  LogMap map = is_bag(path) ? map_of_bag(path, options) : load_map_of_scans(path, options);
  if (options.unknown_is_free)
    set_unknown_free(map.grid);
  else
    map.notes.push_back("unseen cells are free within " + format_number(free_reach(options)) +
                        " m of the drive, else occupied (--unknown-free: free)");
  return map;
}

}  // namespace slalom
