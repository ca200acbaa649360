// SPDX-License-Identifier: BSD-3-Clause
#include "safe_interval_search.h"

#include <slalom/core/distance.h>

#include <limits>
#include <map>
#include <queue>

namespace slalom::arrival {
namespace {

/// Times (s) that differ by rounding errors; unsafe intervals are widened by more.
constexpr double kTimeRounding = 1e-10;

struct State {
  int node = 0;
  Interval safe;  ///< of the node
  double arrival = std::numeric_limits<double>::infinity();
  int parent = -1;
  double departure = 0;  ///< from the parent
  bool is_expanded = false;
};

struct QueueItem {
  double arrival;  ///< at the goal, s: a lower bound
  double rest;     ///< m
  int state;
  /// The earliest arrival first; among equal ones that nearest to the goal, then that found first.
  bool operator<(const QueueItem& other) const {
    if (arrival != other.arrival) return arrival > other.arrival;
    return rest != other.rest ? rest > other.rest : state > other.state;
  }
};

class SafeIntervalSearch {
 public:
  SafeIntervalSearch(const Roadmap& roadmap, const Traffic& traffic, double speed, double horizon)
      : roadmap_(roadmap), traffic_(traffic), speed_(speed), horizon_(horizon) {}

  std::vector<Stay> run() {
    const int first = state_at(0, 0);
    if (first < 0) return {};
    offer(first, 0, -1, 0);
    while (!queue_.empty()) {
      const int index = queue_.top().state;
      queue_.pop();
      State& state = states_[static_cast<std::size_t>(index)];
      if (state.is_expanded) continue;
      if (roadmap_.is_goal(state.node)) return stays_until(index);
      state.is_expanded = true;
      expand(index);
    }
    return {};
  }

 private:
  /// The state of a node at a time; -1 if the node is not safe then.
  int state_at(int node, double t) {
    const auto [found, is_new] = states_of_.try_emplace(node);
    if (is_new) {
      for (const Interval& safe : safe_intervals(roadmap_.position(node), traffic_, horizon_)) {
        found->second.push_back(static_cast<int>(states_.size()));
        states_.push_back({node, safe});
      }
    }
    for (const int state : found->second) {
      const Interval& safe = states_[static_cast<std::size_t>(state)].safe;
      if (safe.first - kTimeRounding <= t && t <= safe.last + kTimeRounding) return state;
    }
    return -1;
  }

  void offer(int index, double arrival, int parent, double departure) {
    State& state = states_[static_cast<std::size_t>(index)];
    if (arrival >= state.arrival) return;
    state.arrival = arrival;
    state.parent = parent;
    state.departure = departure;
    const double rest = roadmap_.rest(state.node);
    queue_.push({arrival + rest / speed_, rest, index});
  }

  void expand(int index) {
    const State from = states_[static_cast<std::size_t>(index)];  // states_ grows
    const auto here = roadmap_.position(from.node);
    for (const int neighbor : roadmap_.neighbors(from.node)) {
      const auto there = roadmap_.position(neighbor);
      const double length = distance_between(here, there);
      if (length == 0) continue;
      const Leg leg{here, (there - here) * (speed_ / length), length / speed_};
      const Interval stay{from.arrival, std::min(from.safe.last, horizon_ - leg.duration)};
      const auto unsafe = unsafe_departures(leg, traffic_, stay);
      for (const Interval& window : gaps_between(unsafe, stay.first, stay.last)) {
        const int next = state_at(neighbor, window.first + leg.duration);
        if (next >= 0) offer(next, window.first + leg.duration, index, window.first);
      }
    }
  }

  std::vector<Stay> stays_until(int last) const {
    std::vector<Stay> stays;
    double departure = states_[static_cast<std::size_t>(last)].arrival;
    for (int i = last; i >= 0; i = states_[static_cast<std::size_t>(i)].parent) {
      const State& state = states_[static_cast<std::size_t>(i)];
      stays.push_back({state.node, state.arrival, departure});
      departure = state.departure;
    }
    std::reverse(stays.begin(), stays.end());
    return stays;
  }

  const Roadmap& roadmap_;
  const Traffic& traffic_;
  double speed_, horizon_;
  std::vector<State> states_;
  std::map<int, std::vector<int>> states_of_;
  std::priority_queue<QueueItem> queue_;
};

}  // namespace

std::vector<Stay> search_safe_intervals(const Roadmap& roadmap, const Traffic& traffic,
                                        double speed, double horizon) {
  return SafeIntervalSearch(roadmap, traffic, speed, horizon).run();
}

}  // namespace slalom::arrival
