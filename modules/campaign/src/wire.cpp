// SPDX-License-Identifier: BSD-3-Clause
#include "wire.h"

#include <slalom/core/error.h>
#include <slalom/references/reference_codec.h>
#include <slalom/trajectory/trajectory_codec.h>

#include <nlohmann/json.hpp>

#include <cmath>

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

Json binary(const std::string& bytes) {
  return Json::binary(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
}

std::string bytes_of(const Json& json) {
  const auto& bytes = json.get_binary();
  return {bytes.begin(), bytes.end()};
}

// MessagePack: unlike CBOR its strings are not nested, so that the reader recurses in containers
// only.
std::string pack(const Json& json) {
  const std::vector<std::uint8_t> bytes = Json::to_msgpack(json);
  return {bytes.begin(), bytes.end()};
}

/// Refuses values that are nested more deeply than those of pack(): they would exhaust the stack.
class ShallowParser : public nlohmann::detail::json_sax_dom_parser<Json> {
  using Base = nlohmann::detail::json_sax_dom_parser<Json>;
  static constexpr int kMaxDepth = 8;
  int depth_ = 0;

 public:
  using Base::Base;
  bool start_object(std::size_t size) { return ++depth_ <= kMaxDepth && Base::start_object(size); }
  bool start_array(std::size_t size) { return ++depth_ <= kMaxDepth && Base::start_array(size); }
  bool end_object() { return --depth_, Base::end_object(); }
  bool end_array() { return --depth_, Base::end_array(); }
};

Json unpack(const std::string& bytes) {
  Json json;
  ShallowParser parser(json);
  if (!Json::sax_parse(bytes, &parser, Json::input_format_t::msgpack))
    throw file_error("a worker", "sent values that are nested too deeply");
  return json;
}

/// Throws for a time that cannot be stored.
double seconds_from(const Json& json) {
  const double seconds = json.get<double>();
  if (!std::isfinite(seconds)) throw file_error("a worker", "sent a time that is not finite");
  return seconds;
}

}  // namespace

std::string to_wire(const ScenarioFindings& findings) {
  const ReferenceTiming& timing = findings.references.timing;
  return pack({{"hash", findings.record.hash},
               {"name", findings.record.name},
               {"descriptors", to_json(findings.record.descriptors)},
               {"references", binary(to_bytes(findings.references))},
               {"timing", {timing.exact, timing.planner, timing.safest}}});
}

ScenarioFindings scenario_findings_from_wire(const std::string& bytes) {
  const Json json = unpack(bytes);
  ScenarioFindings findings = {
      {json.at("hash").get<std::string>(), json.at("name").get<std::string>(),
       values_from(json.at("descriptors"))},
      references_from_bytes(bytes_of(json.at("references")), "a worker")};
  const Json& timing = json.at("timing");
  findings.references.timing = {seconds_from(timing.at(0)), seconds_from(timing.at(1)),
                                seconds_from(timing.at(2))};
  return findings;
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
               {"trajectory", binary(to_bytes(findings.trajectory))}});
}

RunFindings run_findings_from_wire(const std::string& bytes) {
  const Json json = unpack(bytes);
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
  findings.timing.wall_seconds = seconds_from(json.at("wall_seconds"));
  findings.timing.values = json.at("timing").get<std::map<std::string, double>>();
  findings.trajectory = trajectory_from_bytes(bytes_of(json.at("trajectory")), "a worker");
  return findings;
}

}  // namespace slalom
