// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/byte_stream.h>
#include <slalom/falsification/shrink.h>
#include <slalom/io/scenario_list.h>

namespace slalom {
namespace {

constexpr std::uint8_t kShrinkVersion = 1;

void write_fairness(ByteWriter& writer, const FairnessReport& fairness) {
  const GeometryReport& geometry = fairness.geometry;
  writer.f64(geometry.bottleneck).f64(geometry.start_clearance).f64(geometry.distance);
  writer.text(geometry.violation).text(to_bytes(fairness.witness_run)).text(fairness.witness);
  writer.u8(fairness.repeatable ? 1 : 0).u64(fairness.violations.size());
  for (const std::string& violation : fairness.violations) writer.text(violation);
}

FairnessReport read_fairness(ByteReader& reader, const std::string& where) {
  FairnessReport fairness;
  fairness.geometry.bottleneck = reader.f64();
  fairness.geometry.start_clearance = reader.f64();
  fairness.geometry.distance = reader.f64();
  fairness.geometry.violation = reader.text();
  fairness.witness_run = trial_from_bytes(reader.text(), where);
  fairness.witness = reader.text();
  fairness.repeatable = reader.u8() != 0;
  for (std::size_t left = reader.count(sizeof(std::uint64_t)); left > 0; --left)
    fairness.violations.push_back(reader.text());
  return fairness;
}

}  // namespace

std::string to_bytes(const ShrinkResult& result) {
  ByteWriter writer;
  writer.u8(kShrinkVersion).text(serialize(result.scenario)).text(to_bytes(result.trial));
  writer.u64(result.parts_before).u64(result.parts_after).u64(result.runs).u64(result.unfair);
  writer.f64(result.moved).u8(result.minimal ? 1 : 0).u64(result.removals.size());
  for (const Removal& removal : result.removals) writer.text(removal.part).text(removal.verdict);
  write_fairness(writer, result.fairness);
  return writer.take();
}

ShrinkResult shrink_result_from_bytes(const std::string& bytes, const std::string& where) {
  ByteReader reader(bytes, where);
  reader.expect_version(kShrinkVersion);
  Scenario scenario = deserialize_scenario(reader.text(), where);
  ShrinkResult result{std::move(scenario), trial_from_bytes(reader.text(), where)};
  result.parts_before = reader.u64();
  result.parts_after = reader.u64();
  result.runs = reader.u64();
  result.unfair = reader.u64();
  result.moved = reader.f64();
  result.minimal = reader.u8() != 0;
  for (std::size_t left = reader.count(2 * sizeof(std::uint64_t)); left > 0; --left) {
    std::string part = reader.text();
    result.removals.push_back({std::move(part), reader.text()});
  }
  result.fairness = read_fairness(reader, where);
  reader.expect_end();
  return result;
}

}  // namespace slalom
