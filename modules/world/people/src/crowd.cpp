// SPDX-License-Identifier: BSD-3-Clause
#include "line_of_sight.h"
#include "orca.h"
#include "speed_model.h"

#include <slalom/core/error.h>
#include <slalom/core/geometry.h>
#include <slalom/core/math.h>
#include <slalom/people/crowd.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr int kRobotRank = -1;

double gap_between(const CrowdDisc& a, const CrowdDisc& b) {
  return norm(b.position - a.position) - a.radius - b.radius;
}

/// m: walls that matter to somebody are nearer.
double wall_reach(const People& people, const PeopleSettings& settings) {
  double reach = 0;
  for (const Person& person : people)
    reach =
        std::max(reach, person.radius + std::max(kRepulsionReach, person.speed * settings.haste *
                                                                      settings.wall_horizon));
  return reach;
}

/// m, the distance between borders from which on nobody matters to the model.
double reach_of(const Person& person, const PeopleSettings& settings) {
  return settings.model == PeopleModel::Orca
             ? std::numeric_limits<double>::infinity()
             : std::max(kRepulsionReach, person.speed * settings.time_gap);
}

/// The robot, if the person notices it.
const CrowdDisc* noticed_by(std::size_t i, const std::optional<RobotDisc>& robot) {
  return robot && robot->noticed.at(i) ? &robot->disc : nullptr;
}

const People& checked(const World& world, const People& people) {
  check_people(world, people);
  return people;
}

}  // namespace

void check_people(const World& world, const People& people) {
  constexpr double kTolerance = 1e-9;  // m
  const std::string& name = world.scenario().name();
  check_people(name, people);
  for (const Person& person : people)
    if (world.distance_field().clearance(person.start) < person.radius - kTolerance)
      throw file_error(name + ": person '" + person.id + "'", "starts in a wall",
                       "a start at least its radius from walls");
}

Crowd::Crowd(const World& world, const People& people, const PeopleSettings& settings)
    : world_(world),
      people_(checked(world, people)),
      settings_(settings),
      walls_(world.occupancy(), wall_reach(people, settings)),
      states_(people.size()),
      plans_(people.size()),
      intents_(people.size()),
      by_id_(people.size()) {
  for (std::size_t i = 0; i < people.size(); ++i)
    states_[i].disc = {people[i].start, {0, 0}, people[i].radius};
  std::iota(by_id_.begin(), by_id_.end(), std::size_t{0});
  std::sort(by_id_.begin(), by_id_.end(),
            [&](std::size_t a, std::size_t b) { return people[a].id < people[b].id; });
  for (std::size_t rank = 0; rank < by_id_.size(); ++rank)
    plans_[by_id_[rank]].rank = static_cast<int>(rank);
  plan_routes();
}

/// One field for all people of a radius who go to a point.
void Crowd::plan_routes() {
  std::map<std::tuple<double, double, double>, std::shared_ptr<const CostToGoField>> fields;
  for (std::size_t i = 0; i < people_.size(); ++i) {
    const Person& person = people_[i];
    Plan& plan = plans_[i];
    plan.stations = stations_of(person);
    for (const TPoint2D& station : plan.stations) {
      const bool is_start = plan.fields.empty();
      if (is_start && person.after != PersonEnd::Return) {
        plan.fields.push_back(nullptr);
        continue;
      }
      auto& field = fields[{station.x, station.y, person.radius}];
      if (!field)
        field = std::make_shared<CostToGoField>(world_, station, person.radius, settings_.side);
      plan.fields.push_back(field);
    }
    plan.leg = rest(i);
  }
}

/// m, of the way to the next station.
double Crowd::rest(std::size_t i) const {
  const CostToGoField& field = *plans_[i].fields[plans_[i].next];
  const TPoint2D& here = states_[i].disc.position;
  return field.length(here, field.target(here, plans_[i].aim));
}

void Crowd::set_next(std::size_t i, std::size_t station) {
  Plan& plan = plans_[i];
  plan.covered = covered(i);
  plan.next = station;
  plan.aim.reset();
  plan.leg = rest(i);
}

double Crowd::covered(std::size_t i) const {
  const Plan& plan = plans_[i];
  return states_[i].departure ? plan.covered : plan.covered + plan.leg - rest(i);
}

bool Crowd::is_free(std::size_t i, const std::optional<RobotDisc>& robot) const {
  const CrowdDisc* const noticed = noticed_by(i, robot);
  if (noticed && gap_between(states_[i].disc, *noticed) < 0) return false;
  return std::none_of(states_.begin(), states_.end(), [&](const PersonState& other) {
    return other.is_present && gap_between(states_[i].disc, other.disc) < 0;
  });
}

/// Passes via points, and arrives: near the goal, or near a robot that covers it.
void Crowd::advance(std::size_t i, const std::optional<RobotDisc>& robot) {
  constexpr double kBeside = 0.3;  // m
  PersonState& state = states_[i];
  Plan& plan = plans_[i];
  const std::size_t last = plan.back ? 0 : plan.stations.size() - 1;
  const auto distance = [&] { return norm(plan.stations[plan.next] - state.disc.position); };
  while (plan.next != last && distance() < 2 * settings_.goal_tolerance)
    set_next(i, plan.back ? plan.next - 1 : plan.next + 1);
  plan.is_beside = false;
  if (plan.next != last) return;
  const CrowdDisc* const noticed = noticed_by(i, robot);
  const double both = noticed ? noticed->radius + state.disc.radius : 0;
  const bool is_covered = noticed && norm(plan.stations[last] - noticed->position) < both;
  plan.is_beside = is_covered && distance() < both + kBeside;
  if (!plan.is_beside && distance() > settings_.goal_tolerance) return;
  if (!state.arrival) state.arrival = time();
  if (people_[i].after == PersonEnd::Vanish) {
    plan.covered = covered(i);
    state.is_present = false;
    state.departure = time();
  } else if (people_[i].after == PersonEnd::Return) {
    plan.back = !plan.back;
    set_next(i, plan.back ? plan.stations.size() - 2 : 1);
  }
}

/// Towards the next station, slower near a goal at which the person stays.
Crowd::Intent Crowd::intent_of(std::size_t i) const {
  constexpr double kSlowing = 1;  // s
  const Plan& plan = plans_[i];
  const TPoint2D& here = states_[i].disc.position;
  if (plan.is_beside) return {here, {0, 0}};
  const double speed = people_[i].speed;
  const TPoint2D target = plan.fields[plan.next]->target(here, plan.aim);
  const TPoint2D offset = target - here;
  const double distance = norm(offset);
  const bool stays = people_[i].after == PersonEnd::Stay && plan.next + 1 == plan.stations.size() &&
                     norm(target - plan.stations.back()) == 0;
  if (stays && distance <= speed * kSlowing) return {target, offset * (1 / kSlowing)};
  return {target, distance > 0 ? offset * (speed / distance) : TPoint2D(0, 0)};
}

/// Slow among others, far from the goal. People of the speed model queue behind those ahead, unless
/// these stand by choice or want to get behind them.
bool Crowd::is_held_up(std::size_t i, const std::optional<RobotDisc>& robot) const {
  constexpr double kNearGoal = 1;  // m
  const CrowdDisc& self = states_[i].disc;
  const TPoint2D& way = intents_[i].velocity;
  const double slow = 0.5 * people_[i].speed;
  if (!(norm(self.velocity) < slow) ||
      norm(plans_[i].stations[plans_[i].next] - self.position) <= kNearGoal)
    return false;
  const auto holds_up = [&](const CrowdDisc& other, const Intent& intent) {
    const bool opposes =
        dot(other.position - self.position, way) > 0 &&
        (norm(intent.velocity) < slow || dot(intent.target - self.position, way) <= 0);
    return (opposes || settings_.model == PeopleModel::Orca) && sees(self, other, settings_.sight);
  };
  if (const CrowdDisc* const noticed = noticed_by(i, robot)) {
    constexpr double kForesight = 10;  // s
    if (holds_up(*noticed, {noticed->position + noticed->velocity * kForesight, noticed->velocity}))
      return true;
  }
  for (std::size_t j = 0; j < states_.size(); ++j)
    if (j != i && states_[j].is_present && holds_up(states_[j].disc, intents_[j])) return true;
  return false;
}

/// Who is held up wants to go further to the side, so that opposite and symmetric encounters end.
TPoint2D Crowd::wanted_velocity(std::size_t i, const std::optional<RobotDisc>& robot) const {
  const TPoint2D& straight = intents_[i].velocity;
  if (settings_.turn <= 0 || !is_held_up(i, robot)) return straight;
  const math::SinCos turn = math::sin_cos(settings_.turn);
  const double sign = settings_.side == PeopleSide::Left ? 1 : -1;
  return straight * turn.cos + left_of(straight) * (sign * turn.sin);
}

/// Whether the other one is nearer than `sight` (m), with no wall between the centers.
bool Crowd::sees(const CrowdDisc& self, const CrowdDisc& other, double sight) const {
  return norm(other.position - self.position) < sight &&
         is_in_sight(world_.ray_caster(), self.position, other.position);
}

void Crowd::look_at_walls() {
  const TPoint2D& here = around_.self.position;
  const double reach =
      around_.self.radius + std::max(kRepulsionReach, around_.max_speed * settings_.wall_horizon);
  around_.walls.clear();
  for (const std::size_t k : walls_.near(here)) {
    const auto& [a, b, to_free] = walls_.runs()[k];
    // Along an axis, so that the bits do not depend on which end is the first.
    const TPoint2D offset(std::clamp(here.x, a.x, b.x) - here.x,
                          std::clamp(here.y, a.y, b.y) - here.y);
    if (dot(offset, offset) < reach * reach)
      around_.walls.push_back({offset, dot(here - a, to_free) > 0});
  }
}

/// Adds a neighbor in sight, or so near that it has to be kept apart from, also through a wall.
void Crowd::look_at(Neighbor neighbor, double sight) {
  const double reach =
      around_.self.radius + neighbor.disc.radius + 2 * around_.max_speed * settings_.period;
  neighbor.keeps_apart =
      neighbor.keeps_apart && norm(neighbor.disc.position - around_.self.position) < reach;
  neighbor.is_visible = sees(around_.self, neighbor.disc, sight);
  if (neighbor.is_visible || neighbor.keeps_apart) around_.neighbors.push_back(neighbor);
}

void Crowd::gather_neighbors(std::size_t i, bool apart, const std::optional<RobotDisc>& robot) {
  const PersonState& state = states_[i];
  around_.self = state.disc;
  around_.rank = plans_[i].rank;
  around_.wanted = state.wanted;
  around_.max_speed = people_[i].speed * settings_.haste;
  around_.neighbors.clear();
  look_at_walls();
  const double reach = state.disc.radius + reach_of(people_[i], settings_);
  for (std::size_t j = 0; j < states_.size(); ++j)
    if (j != i && states_[j].is_present)
      look_at({states_[j].disc, plans_[j].rank, 0.5, true, apart},
              std::min(settings_.sight, reach + states_[j].disc.radius));
  if (const CrowdDisc* const noticed = noticed_by(i, robot))
    look_at({*noticed, kRobotRank, settings_.share, true, true},
            std::min(settings_.sight, reach + noticed->radius));
  sort_by_place(around_, settings_.side);
}

TPoint2D Crowd::choose(std::size_t i, bool apart, const std::optional<RobotDisc>& robot) {
  gather_neighbors(i, apart, robot);
  if (robot)
    intents_[i].robot_in_reach =
        std::any_of(around_.neighbors.begin(), around_.neighbors.end(),
                    [](const Neighbor& one) { return one.rank == kRobotRank; });
  return settings_.model == PeopleModel::Orca ? orca_velocity(around_, settings_)
                                              : speed_velocity(around_, settings_);
}

/// Exact: the motions are straight.
bool Crowd::would_touch(std::size_t i) const {
  const CrowdDisc& self = states_[i].disc;
  for (std::size_t j = 0; j < states_.size(); ++j) {
    const CrowdDisc& other = states_[j].disc;
    if (j == i || !states_[j].is_present) continue;
    const TPoint2D from = other.position - self.position;
    const double radius = self.radius + other.radius;
    const double reach =
        radius + (people_[i].speed + people_[j].speed) * settings_.haste * settings_.period;
    if (dot(from, from) >= reach * reach) continue;
    const TPoint2D to = from + (states_[j].chosen - states_[i].chosen) * settings_.period;
    if (norm(nearest_on_segment({0, 0}, from, to)) < radius) return true;
  }
  return false;
}

/// People who would touch another one decide again, until nobody would. The set only grows: there
/// are at most as many rounds as people, and their order does not matter.
std::vector<bool> Crowd::keep_apart(const std::optional<RobotDisc>& robot) {
  std::vector<bool> again(states_.size());
  if (!settings_.keep_apart) return again;
  for (std::vector<std::size_t> more;; more.clear()) {
    for (std::size_t i = 0; i < states_.size(); ++i)
      if (states_[i].is_present && !again[i] && would_touch(i)) more.push_back(i);
    if (more.empty()) return again;
    for (const std::size_t i : more) {
      again[i] = true;
      states_[i].chosen = choose(i, true, robot);
    }
  }
}

/// Among the others as they decided with it.
TPoint2D Crowd::choose_without_robot(std::size_t i, bool apart) {
  PersonState& state = states_[i];
  const TPoint2D wanted = state.wanted, chosen = state.chosen;
  state.wanted = wanted_velocity(i, {});
  state.chosen = choose(i, apart, {});
  if (settings_.keep_apart && !apart && would_touch(i)) state.chosen = choose(i, true, {});
  const TPoint2D without = state.chosen;
  state.wanted = wanted;
  state.chosen = chosen;
  return without;
}

/// Who has arrived is not hindered. The robot is in reach also if it only holds the person up.
void Crowd::add_hindrance(std::size_t i, bool apart, const std::optional<RobotDisc>& robot) {
  if (noticed_by(i, robot) == nullptr) return;
  PersonState& state = states_[i];
  Hindrance& hindrance = state.hindrance;
  hindrance.is_noticed = true;
  const bool in_reach = intents_[i].robot_in_reach || (is_held_up(i, robot) && !is_held_up(i, {}));
  const TPoint2D way = intents_[i].target - state.disc.position;
  const double length = norm(way);
  if (!in_reach || length <= 0) return;
  const TPoint2D change = choose_without_robot(i, apart) - state.chosen;
  ++hindrance.updates;
  hindrance.time += dot(change, way) / length * settings_.period / people_[i].speed;
  hindrance.speed_change += norm(change);
}

void Crowd::decide(const std::optional<RobotDisc>& robot) {
  constexpr double kRounding = 1e-9;  // s
  for (const std::size_t i : by_id_) {
    PersonState& state = states_[i];
    if (state.is_present)
      advance(i, robot);
    else if (!state.departure && time() >= people_[i].begin - kRounding && is_free(i, robot))
      state.is_present = true;
  }
  for (std::size_t i = 0; i < states_.size(); ++i)
    if (states_[i].is_present) {
      intents_[i] = intent_of(i);
      if (!plans_[i].is_beside) plans_[i].aim = intents_[i].target;
    }
  for (std::size_t i = 0; i < states_.size(); ++i)
    if (states_[i].is_present) states_[i].wanted = wanted_velocity(i, robot);
  for (std::size_t i = 0; i < states_.size(); ++i)
    if (states_[i].is_present) states_[i].chosen = choose(i, false, robot);
  const std::vector<bool> apart = keep_apart(robot);
  for (std::size_t i = 0; i < states_.size(); ++i)
    if (states_[i].is_present) add_hindrance(i, apart[i], robot);
}

void Crowd::move() {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    PersonState& state = states_[i];
    if (!state.is_present) continue;
    state.disc.velocity = state.chosen;
    state.disc.position += state.chosen * settings_.period;
  }
  ++updates_;
}

}  // namespace slalom
