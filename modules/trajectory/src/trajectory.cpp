#include <slalom/core/error.h>
#include <slalom/core/hash.h>
#include <slalom/trajectory/trajectory.h>

#include <array>

namespace slalom {
namespace {

struct OutcomeName {
  Outcome outcome;
  const char* name;
};

constexpr std::array<OutcomeName, 11> kOutcomes = {{
    {Outcome::Success, "success"},
    {Outcome::Collision, "collision"},
    {Outcome::Timeout, "timeout"},
    {Outcome::Stuck, "stuck"},
    {Outcome::LeftWorkspace, "left_workspace"},
    {Outcome::MethodCrash, "method_crash"},
    {Outcome::MethodDeadline, "method_deadline"},
    {Outcome::MethodInvalidCommand, "method_invalid_command"},
    {Outcome::MethodError, "method_error"},
    {Outcome::UnsolvableScenario, "unsolvable_scenario"},
    {Outcome::InfrastructureError, "infrastructure_error"},
}};

}  // namespace

std::array<double, Sample::kNumbers> Sample::numbers() const {
  return {t, pose.x, pose.y, pose.phi, v, w, command_v, command_w, vy, command_vy};
}

Sample Sample::from_numbers(const std::array<double, kNumbers>& n) {
  return {n[0], {n[1], n[2], n[3]}, n[4], n[5], n[6], n[7], n[8], n[9]};
}

double Trajectory::duration() const {
  return samples.size() < 2 ? 0.0 : samples.back().t - samples.front().t;
}

Path Trajectory::path() const {
  Path path;
  path.reserve(samples.size());
  for (const Sample& sample : samples) path.emplace_back(sample.pose.x, sample.pose.y);
  return path;
}

std::string Trajectory::hash() const {
  Hasher hasher;
  for (const Sample& s : samples)
    for (const double number : s.numbers()) hasher.add(number);
  return hasher.hex();
}

std::string to_string(Outcome outcome) {
  for (const OutcomeName& entry : kOutcomes)
    if (entry.outcome == outcome) return entry.name;
  return "unknown";
}

Outcome outcome_from_string(const std::string& text) {
  for (const OutcomeName& entry : kOutcomes)
    if (text == entry.name) return entry.outcome;
  throw file_error("outcome", "'" + text + "' is unknown", "success, collision, timeout, ...");
}

const std::vector<Outcome>& all_outcomes() {
  static const std::vector<Outcome> outcomes = [] {
    std::vector<Outcome> list;
    for (const OutcomeName& entry : kOutcomes) list.push_back(entry.outcome);
    return list;
  }();
  return outcomes;
}

}  // namespace slalom
