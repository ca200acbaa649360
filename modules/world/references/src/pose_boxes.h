// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/robot/footprint.h>
#include <slalom/scenario/world.h>

#include <mrpt/math/TPose2D.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace slalom {

/// The poses of a polygon among the occupied cells of a world, divided into boxes of a cell's side
/// / kDivisions and of 2 pi / (64 kDivisions), and those from which neighbors lead to a goal; see
/// footprint_path.h.
template <std::size_t kDivisions>
class PoseBoxes {
 public:
  /// The world must outlive the boxes. They lead to positions within `reach` (m) of the goal.
  PoseBoxes(const World& world, const Footprint& footprint, const mrpt::math::TPoint2D& goal,
            double reach);
  /// The same, divided only where some of the larger boxes are closed and others lead to the goal.
  template <std::size_t kFewer>
  PoseBoxes(const World& world, const Footprint& footprint, const mrpt::math::TPoint2D& goal,
            double reach, const PoseBoxes<kFewer>& larger);

  /// Whether a motion may lead from this pose to the goal: false is proved, but for poses within
  /// rounding errors of a box's border.
  bool leads_to_goal(const mrpt::math::TPose2D& pose) const;
  /// Whether that is proved false of a pose, whatever border it is on.
  bool separates(const mrpt::math::TPose2D& start) const;

  /// Whether the boxes of all headings are open at a position.
  bool is_wide(const mrpt::math::TPoint2D& point) const;

  /// The least number of neighbors to the goal from a box at a position, by position_of(); 65535 if
  /// none leads there or all are farther.
  std::vector<std::uint16_t> steps_to_goal() const;
  /// nullopt outside of the world.
  std::optional<std::size_t> position_of(const mrpt::math::TPoint2D& point) const;

 private:
  using Headings = std::array<std::uint64_t, kDivisions>;  ///< a bit for each
  using Corners = std::vector<mrpt::math::TPoint2D>;
  static constexpr int kSide = static_cast<int>(kDivisions);
  static constexpr unsigned kHeadings = 64 * kDivisions;
  static constexpr int kRing = 2;  ///< cells outside that are looked at

  template <std::size_t>
  friend class PoseBoxes;

  PoseBoxes(const World& world, double enclosing_radius, const mrpt::math::TPoint2D& goal,
            double reach);

  void divide(const World& world, const Footprint& footprint);
  std::size_t index(int x, int y) const;
  std::size_t near_index(int x, int y) const;
  std::size_t offset_index(int dx, int dy) const;
  std::vector<std::uint8_t> near_free_cells(const World& world) const;
  std::vector<Headings> closed_by(int block, int box_x, int box_y,
                                  const std::vector<Corners>& parts) const;
  void close(int block, const std::vector<Corners>& parts, const std::vector<std::uint8_t>& near);
  void flood();
  template <typename Visit>
  void for_each_goal(const Visit& visit) const;

  const Occupancy& cells_;
  int width_, height_;          ///< in boxes
  int reach_;                   ///< cells, farther than the robot
  std::vector<Headings> open_;  ///< by position, row by row
  mrpt::math::TPoint2D goal_;
  double goal_reach_;              ///< m
  std::vector<Headings> leading_;  ///< of these, what leads to the goal
  std::vector<char> is_divided_;   ///< by cell, whether blocks may close its boxes
};

extern template class PoseBoxes<1>;
extern template class PoseBoxes<2>;
extern template class PoseBoxes<4>;

/// Whether a world has few enough boxes: at most 16 million of 64 directions.
bool can_divide(const World& world, int divisions);

}  // namespace slalom
