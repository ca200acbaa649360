// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/people/run_alone.h>
#include <slalom/simulation/simulate.h>

#include <mrpt/math/TPose2D.h>

#include <memory>
#include <optional>
#include <vector>

namespace slalom {

/// The state of the robot as people see it: velocity in its frame (m/s).
struct SeenRobot {
  mrpt::math::TPose2D pose;
  double v = 0, vy = 0;
};

/// All that moves in a run but the robot: the movers of the scenario, then its people.
class RunMovers {
 public:
  /// `world` must outlive this, and `alone`: the scenario's people with these settings, or null.
  /// Throws as Crowd.
  RunMovers(const World& world, const Footprint& footprint, const PeopleSettings& settings,
            double max_time, PeopleAlone* alone = nullptr);

  /// Always at the same place; people have waypoints up to the next update.
  const Movers& movers() const { return record_.movers(); }
  Movers take() { return record_.take(); }
  Hindrances hindrances() const;  ///< of the people, up to the last update
  /// m/s, of people.
  double max_speed() const;

  double time() const { return crowd_->time(); }  ///< s, of the next update; requires people
  /// Whether the people decide again at this time (s) or have to have decided before.
  bool is_due(double time) const;
  /// Lets the people decide, and walk to the next update.
  void update(const SeenRobot& robot);

  std::size_t scripted() const { return scripted_; }  ///< number of movers of the scenario
  bool is_person(const Mover& mover) const { return index_of(mover) >= scripted_; }
  /// Whether this person notices the robot.
  bool notices(const Mover& person) const {
    return robot_.noticed.at(index_of(person) - scripted_);
  }

 private:
  void add_delays(Hindrances& hindrances) const;
  std::size_t index_of(const Mover& mover) const {
    return static_cast<std::size_t>(&mover - movers().data());
  }

  const Scenario& scenario_;
  PeopleSettings settings_;
  std::size_t scripted_;
  RobotDisc robot_;
  bool is_noticed_ = false;  ///< by anyone
  std::unique_ptr<PeopleAlone> own_alone_;
  PeopleAlone* alone_;
  std::optional<Crowd> crowd_;
  CrowdRecord record_;
};

}  // namespace slalom
