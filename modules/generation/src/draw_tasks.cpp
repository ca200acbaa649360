#include "solvable.h"

#include <cmath>
#include <set>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// The free places of a map for a disc, in connected areas (8 neighbours of cell centres that keep
/// the radius): tells at once most pairs that no path joins.
class FreeAreas {
 public:
  FreeAreas(const World& map, double radius)
      : cells_(map.occupancy()), field_(map.distance_field()), area_(cells_.cells().size(), -1) {
    int areas = 0;
    for (std::size_t i = 0; i < area_.size(); ++i) {
      if (area_[i] >= 0 || !is_open(i, radius)) continue;
      flood(i, areas++, radius);
    }
    for (std::size_t i = 0; i < area_.size(); ++i)
      if (area_[i] >= 0) open_.push_back(i);
  }

  bool empty() const { return open_.empty(); }
  std::size_t draw(RandomEngine& engine) const {
    return open_[static_cast<std::size_t>(
        uniform_int(engine, 0, static_cast<int>(open_.size()) - 1))];
  }
  bool joined(std::size_t a, std::size_t b) const { return area_[a] == area_[b]; }
  TPoint2D center(std::size_t i) const { return cells_.cell_center(x_of(i), y_of(i)); }

 private:
  int x_of(std::size_t i) const {
    return static_cast<int>(i % static_cast<std::size_t>(cells_.size_x()));
  }
  int y_of(std::size_t i) const {
    return static_cast<int>(i / static_cast<std::size_t>(cells_.size_x()));
  }
  bool is_open(std::size_t i, double radius) const {
    return field_.at_center(x_of(i), y_of(i)) >= radius;
  }

  void flood(std::size_t from, int area, double radius) {
    std::vector<std::size_t> waiting = {from};
    area_[from] = area;
    while (!waiting.empty()) {
      const std::size_t at = waiting.back();
      waiting.pop_back();
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          if (!cells_.inside(x_of(at) + dx, y_of(at) + dy)) continue;
          const std::size_t next = cells_.index(x_of(at) + dx, y_of(at) + dy);
          if (area_[next] >= 0 || !is_open(next, radius)) continue;
          area_[next] = area;
          waiting.push_back(next);
        }
    }
  }

  const Occupancy& cells_;
  const DistanceField& field_;
  std::vector<int> area_;
  std::vector<std::size_t> open_;
};

}  // namespace

std::vector<Scenario> draw_tasks(const Scenario& map, const GenerationTask& task,
                                 double min_distance) {
  constexpr double kPi = 3.14159265358979323846;
  constexpr double kMargin = 0.05;  // m, so that the robot does not begin by touching
  constexpr int kDrawsPerAttempt = 1000;
  const World world(map, task.resolution);
  const FreeAreas areas(world, task.robot_radius + kMargin);
  const SolvableSearch search(task);
  std::set<std::string> hashes;
  std::vector<Scenario> scenarios;
  for (int i = 0; i < task.count; ++i) {
    const std::string name = scenario_name(task.name_prefix, i);
    RandomEngine engine(derive_seed(task.seed, "pair", static_cast<std::uint64_t>(i)));
    const auto draw = [&](int, std::string& reason) -> std::optional<Scenario> {
      reason = "no two joined free places that far apart were drawn";
      for (int k = 0; k < kDrawsPerAttempt && !areas.empty(); ++k) {
        const std::size_t a = areas.draw(engine), b = areas.draw(engine);
        const TPoint2D start = areas.center(a), goal = areas.center(b);
        if (!areas.joined(a, b) || a == b ||
            std::hypot(goal.x - start.x, goal.y - start.y) < min_distance)
          continue;
        const double heading = uniform_real(engine, -kPi, kPi);
        return map.with_task({start.x, start.y, heading}, goal).renamed(name);
      }
      return std::nullopt;
    };
    SolvableWorld found = search.find(name, draw);
    while (!hashes.insert(found.world->scenario().hash()).second)
      found = search.find(name, draw, found.attempt + 1);
    scenarios.push_back(found.world->scenario());
  }
  return scenarios;
}

}  // namespace slalom
