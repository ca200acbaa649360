// SPDX-License-Identifier: BSD-3-Clause
#include "pose_smoothing.h"

#include <slalom/core/math.h>

#include <mrpt/math/wrap2pi.h>

#include <array>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPose2D;

constexpr double kMinGain = 1e-7;  // m

class Smoothing {
 public:
  Smoothing(const PoseMotions& motions, std::vector<TPose2D> poses)
      : motions_(motions), poses_(std::move(poses)) {}

  std::vector<TPose2D> run() {
    constexpr int kRounds = 4;
    for (int round = 0; round < kRounds; ++round) {
      const double before = length(motions_, poses_);
      leave_out();
      if (round > 0) insert();
      // Straight motions become taut by halving and leaving out alone.
      if (motions_.robot().min_turning_radius > 0) move();
      constexpr double kRelativeGain = 1e-5;
      if (round > 1 && length(motions_, poses_) > before * (1 - kRelativeGain)) break;
    }
    leave_out();
    return poses_;
  }

 private:
  /// From each pose directly to the last one that makes the path no longer.
  void leave_out() {
    std::vector<TPose2D> kept = {poses_.front()};
    for (std::size_t i = 0; i + 1 < poses_.size();) {
      std::size_t next = i + 1;
      double along = 0;
      std::vector<double> lengths(poses_.size(), 0);
      for (std::size_t j = i + 1; j < poses_.size(); ++j)
        lengths[j] = along += motions_.length(poses_[j - 1], poses_[j]);
      for (std::size_t j = poses_.size() - 1; j > i + 1; --j)
        if (motions_.length(poses_[i], poses_[j]) <= lengths[j] + 0.1 * kMinGain &&
            motions_.is_free(poses_[i], poses_[j])) {
          next = j;
          break;
        }
      kept.push_back(poses_[next]);
      i = next;
    }
    poses_ = std::move(kept);
  }

  /// Halves motions that are not short.
  void insert() {
    constexpr double kMinLength = 0.2;  // m
    std::vector<TPose2D> more = {poses_.front()};
    for (std::size_t i = 1; i < poses_.size(); ++i) {
      if (motions_.length(poses_[i - 1], poses_[i]) > kMinLength) {
        const TPose2D middle = motions_.between(poses_[i - 1], poses_[i], 0.5);
        if (motions_.is_free(poses_[i - 1], middle) && motions_.is_free(middle, poses_[i]))
          more.push_back(middle);
      }
      more.push_back(poses_[i]);
    }
    poses_ = std::move(more);
  }

  /// A pattern search over all poses, with steps that become smaller.
  void move() {
    constexpr double kFirstStep = 0.2, kLastStep = 5e-4;  // m, and half of it in rad
    constexpr int kSweeps = 4;
    for (double step = kFirstStep; step > kLastStep; step *= 0.5)
      for (int sweep = 0; sweep < kSweeps; ++sweep) {
        bool has_moved = false;
        for (std::size_t i = 1; i < poses_.size(); ++i) has_moved |= move_pose(i, step);
        if (!has_moved) break;
      }
  }

  bool move_pose(std::size_t i, double step) {
    const bool is_last = i + 1 == poses_.size();
    const double along_x = math::cos(poses_[i].phi) * step,
                 along_y = math::sin(poses_[i].phi) * step;
    const std::array<TPose2D, 6> moves = {
        TPose2D(0, 0, 2 * step),       TPose2D(0, 0, -2 * step),
        TPose2D(along_x, along_y, 0),  TPose2D(-along_x, -along_y, 0),
        TPose2D(-along_y, along_x, 0), TPose2D(along_y, -along_x, 0)};
    bool has_moved = false;
    for (std::size_t k = 0; k < (is_last ? 2 : moves.size()); ++k) {
      const TPose2D moved(poses_[i].x + moves[k].x, poses_[i].y + moves[k].y,
                          mrpt::math::wrapToPi(poses_[i].phi + moves[k].phi));
      has_moved |= try_pose(i, moved);
    }
    return has_moved;
  }

  bool try_pose(std::size_t i, const TPose2D& moved) {
    const TPose2D& before = poses_[i - 1];
    const TPose2D* after = i + 1 < poses_.size() ? &poses_[i + 1] : nullptr;
    const auto sum = [&](const TPose2D& pose) {
      return motions_.length(before, pose) + (after != nullptr ? motions_.length(pose, *after) : 0);
    };
    if (sum(moved) > sum(poses_[i]) - kMinGain || !motions_.is_free_at(moved) ||
        !motions_.is_free(before, moved) || (after != nullptr && !motions_.is_free(moved, *after)))
      return false;
    poses_[i] = moved;
    return true;
  }

  const PoseMotions& motions_;
  std::vector<TPose2D> poses_;
};

}  // namespace

std::vector<TPose2D> smooth(const PoseMotions& motions, std::vector<TPose2D> poses) {
  if (poses.size() < 2) return poses;
  return Smoothing(motions, std::move(poses)).run();
}

}  // namespace slalom
