// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/io/reference_text.h>

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

nlohmann::ordered_json polyline_json(const Path& path) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const auto& p : path) json.push_back({p.x, p.y});
  return json;
}

nlohmann::ordered_json plan_json(const std::vector<TimedPoint>& plan) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const TimedPoint& p : plan) json.push_back({p.t, p.position.x, p.position.y});
  return json;
}

void add_arrival(const References& references, nlohmann::ordered_json& json) {
  if (references.arrival) {
    const EarliestArrival& a = *references.arrival;
    json["earliest_arrival_lower_bound"] = a.certificate.lower_bound;
    json["earliest_arrival_upper_bound"] = a.certificate.upper_bound;
    json["earliest_arrival_gap"] = a.certificate.gap();
    json["earliest_arrival_plan"] = plan_json(a.plan);
  } else {
    json["earliest_arrival_lower_bound"] = nullptr;
    json["earliest_arrival_reason"] = references.arrival_reason;
  }
}

nlohmann::ordered_json to_json(const References& references, const std::string& id,
                               const std::string& name, const World* world) {
  nlohmann::ordered_json json = {{"id", id}, {"name", name}};
  if (references.shortest) {
    const ShortestPath& s = *references.shortest;
    json["shortest_length"] = s.length;
    json["lower_bound"] = s.certificate.lower_bound;
    json["upper_bound"] = s.certificate.upper_bound;
    json["gap"] = s.certificate.gap();
    json["planner"] = s.planner;
    json["exact_length"] = s.exact_length;
    if (s.planner_length) json["planner_length"] = *s.planner_length;
    if (!s.note.empty()) json["note"] = s.note;
    json["shortest_path"] = polyline_json(s.path);
  } else {
    json["shortest_length"] = nullptr;
    json["shortest_reason"] = references.shortest_reason;
  }
  if (references.safest) {
    const SafestPath& s = *references.safest;
    json["safest_length"] = length(s.path);
    json["safest_bottleneck"] = s.bottleneck;
    json["safest_planner"] = s.planner;
    if (!s.note.empty()) json["safest_note"] = s.note;
    json["safest_path"] = polyline_json(s.path);
    if (world != nullptr) {
      const mrpt::math::TPoint2D narrowest = narrowest_place(*world, s.path);
      json["narrowest_width"] = 2 * s.bottleneck;
      json["narrowest_place"] = {narrowest.x, narrowest.y};
    }
  } else {
    json["safest_length"] = nullptr;
    json["safest_reason"] = references.safest_reason;
  }
  const bool has_arrival = references.arrival || !references.arrival_reason.empty();
  if (has_arrival) add_arrival(references, json);
  const ReferenceTiming& timing = references.timing;
  json["time_seconds"] = timing.exact + timing.planner + timing.safest + timing.arrival;
  json["exact_seconds"] = timing.exact;
  json["planner_seconds"] = timing.planner;
  json["safest_seconds"] = timing.safest;
  if (has_arrival) json["earliest_arrival_seconds"] = timing.arrival;
  return json;
}

}  // namespace

std::string render_json(const References& references, const std::string& id,
                        const std::string& name, const World* world) {
  return to_json(references, id, name, world).dump();
}

std::string render_text(const References& references, const std::string& id,
                        const std::string& name, const World* world) {
  const nlohmann::ordered_json json = to_json(references, id, name, world);
  std::string text;
  for (const auto& [key, value] : json.items()) {
    if (value.is_array() && (value.empty() || value[0].is_array())) continue;
    text +=
        "  " + key + " = " + (value.is_string() ? value.get<std::string>() : value.dump()) + "\n";
  }
  return text;
}

}  // namespace slalom
