#include "wire.h"

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

using Json = nlohmann::json;

Json to_json(const Value& value) {
  if (value.is_na()) return value.reason();
  if (value.standard_error()) return Json::array({value.number(), *value.standard_error()});
  return value.number();
}

Value value_from(const Json& json) {
  if (json.is_string()) return Value::na(json.get<std::string>());
  if (json.is_array()) return Value::of(json.at(0).get<double>(), json.at(1).get<double>());
  return Value::of(json.get<double>());
}

Json to_json(const std::map<std::string, VersionedValue>& values) {
  Json json = Json::object();
  for (const auto& [id, value] : values)
    json[id] = Json::array({value.version, to_json(value.value)});
  return json;
}

std::map<std::string, VersionedValue> values_from(const Json& json) {
  std::map<std::string, VersionedValue> values;
  for (const auto& [id, value] : json.items())
    values[id] = {value.at(0).get<int>(), value_from(value.at(1))};
  return values;
}

Json to_json(const Path& path) {
  Json json = Json::array();
  for (const auto& p : path) {
    json.push_back(p.x);
    json.push_back(p.y);
  }
  return json;
}

Path path_from(const Json& json) {
  Path path(json.size() / 2);
  for (std::size_t i = 0; i < path.size(); ++i)
    path[i] = {json.at(2 * i).get<double>(), json.at(2 * i + 1).get<double>()};
  return path;
}

Json to_json(const References& references) {
  const ReferenceTiming& timing = references.timing;
  Json json = {{"shortest_reason", references.shortest_reason},
               {"safest_reason", references.safest_reason},
               {"timing", {timing.exact, timing.planner, timing.safest}}};
  if (references.shortest) {
    const ShortestPath& s = *references.shortest;
    json["shortest"] = {{"path", to_json(s.path)},
                        {"length", s.length},
                        {"lower", s.certificate.lower_bound},
                        {"upper", s.certificate.upper_bound},
                        {"planner", s.planner},
                        {"note", s.note},
                        {"exact_length", s.exact_length}};
    if (s.planner_length) json["shortest"]["planner_length"] = *s.planner_length;
  }
  if (references.safest) {
    const SafestPath& s = *references.safest;
    json["safest"] = {{"path", to_json(s.path)},
                      {"bottleneck", s.bottleneck},
                      {"planner", s.planner},
                      {"note", s.note}};
  }
  return json;
}

References references_from(const Json& json) {
  References references;
  references.shortest_reason = json.at("shortest_reason").get<std::string>();
  references.safest_reason = json.at("safest_reason").get<std::string>();
  if (json.contains("shortest")) {
    const Json& s = json.at("shortest");
    references.shortest = ShortestPath{path_from(s.at("path")),
                                       s.at("length").get<double>(),
                                       {s.at("lower").get<double>(), s.at("upper").get<double>()},
                                       s.at("planner").get<std::string>(),
                                       s.at("note").get<std::string>(),
                                       s.at("exact_length").get<double>()};
    if (s.contains("planner_length"))
      references.shortest->planner_length = s.at("planner_length").get<double>();
  }
  if (json.contains("safest")) {
    const Json& s = json.at("safest");
    references.safest =
        SafestPath{path_from(s.at("path")), s.at("bottleneck").get<double>(),
                   s.at("planner").get<std::string>(), s.at("note").get<std::string>()};
  }
  const Json& timing = json.at("timing");
  references.timing = {timing.at(0).get<double>(), timing.at(1).get<double>(),
                       timing.at(2).get<double>()};
  return references;
}

Json to_json(const Trajectory& trajectory) {
  Json json = Json::array();
  for (const Sample& s : trajectory.samples)
    for (const double number : s.numbers()) json.push_back(number);
  return json;
}

Trajectory trajectory_from(const Json& json) {
  Trajectory trajectory;
  trajectory.samples.resize(json.size() / Sample::kNumbers);
  std::array<double, Sample::kNumbers> numbers{};
  for (std::size_t i = 0; i < trajectory.samples.size(); ++i) {
    for (std::size_t k = 0; k < numbers.size(); ++k)
      numbers[k] = json.at(Sample::kNumbers * i + k).get<double>();
    trajectory.samples[i] = Sample::from_numbers(numbers);
  }
  return trajectory;
}

std::string pack(const Json& json) {
  const std::vector<std::uint8_t> bytes = Json::to_cbor(json);
  return {bytes.begin(), bytes.end()};
}

}  // namespace

std::string to_wire(const ScenarioFindings& findings) {
  return pack({{"hash", findings.record.hash},
               {"name", findings.record.name},
               {"descriptors", to_json(findings.record.descriptors)},
               {"references", to_json(findings.references)}});
}

ScenarioFindings scenario_findings_from_wire(const std::string& bytes) {
  const Json json = Json::from_cbor(bytes);
  return {{json.at("hash").get<std::string>(), json.at("name").get<std::string>(),
           values_from(json.at("descriptors"))},
          references_from(json.at("references"))};
}

std::string to_wire(const RunFindings& findings) {
  const RunRecord& r = findings.record;
  return pack({{"scenario_hash", r.scenario_hash},
               {"scenario_name", r.scenario_name},
               {"method", r.method},
               {"repetition", r.repetition},
               {"seed", r.seed},
               {"outcome", r.outcome},
               {"outcome_detail", r.outcome_detail},
               {"trajectory_hash", r.trajectory_hash},
               {"metrics", to_json(r.metrics)},
               {"wall_seconds", findings.timing.wall_seconds},
               {"timing", findings.timing.values},
               {"trajectory", to_json(findings.trajectory)}});
}

RunFindings run_findings_from_wire(const std::string& bytes) {
  const Json json = Json::from_cbor(bytes);
  RunFindings findings;
  RunRecord& r = findings.record;
  r.scenario_hash = json.at("scenario_hash").get<std::string>();
  r.scenario_name = json.at("scenario_name").get<std::string>();
  r.method = json.at("method").get<std::string>();
  r.repetition = json.at("repetition").get<int>();
  r.seed = json.at("seed").get<std::uint64_t>();
  r.outcome = json.at("outcome").get<std::string>();
  r.outcome_detail = json.at("outcome_detail").get<std::string>();
  r.trajectory_hash = json.at("trajectory_hash").get<std::string>();
  r.metrics = values_from(json.at("metrics"));
  findings.timing.wall_seconds = json.at("wall_seconds").get<double>();
  findings.timing.values = json.at("timing").get<std::map<std::string, double>>();
  findings.trajectory = trajectory_from(json.at("trajectory"));
  return findings;
}

}  // namespace slalom
