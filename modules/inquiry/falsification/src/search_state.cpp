// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/byte_stream.h>
#include <slalom/falsification/search.h>
#include <slalom/io/scenario_list.h>

namespace slalom {
namespace {

constexpr std::uint8_t kVersion = 1;

void write(ByteWriter& writer, const SearchTally& tally) {
  writer.u64(tally.runs).u64(tally.failures).u64(tally.without_witness).u64(tally.outcomes.size());
  for (const auto& [outcome, runs] : tally.outcomes) writer.text(outcome).u64(runs);
}

SearchTally read_tally(ByteReader& reader) {
  SearchTally tally;
  tally.runs = reader.u64();
  tally.failures = reader.u64();
  tally.without_witness = reader.u64();
  for (std::size_t left = reader.count(2 * sizeof(std::uint64_t)); left > 0; --left) {
    const std::string outcome = reader.text();
    tally.outcomes[outcome] = reader.u64();
  }
  return tally;
}

}  // namespace

std::string to_bytes(const SearchState& state) {
  ByteWriter writer;
  writer.u8(kVersion).u64(state.rounds);
  write(writer, state.random);
  write(writer, state.adaptive);
  writer.u64(state.failures.size());
  for (const FoundFailure& found : state.failures)
    writer.u8(static_cast<std::uint8_t>(found.strategy))
        .u64(found.index)
        .text(serialize(found.scenario))
        .text(to_bytes(found.trial));
  writer.u64(state.near_misses.size());
  for (const SearchState::NearMiss& call : state.near_misses)
    writer.f64(call.clearance).text(serialize(call.scenario));
  return writer.take();
}

SearchState search_state_from_bytes(const std::string& bytes, const std::string& where) {
  ByteReader reader(bytes, where);
  reader.expect_version(kVersion);
  SearchState state;
  state.rounds = reader.u64();
  state.random = read_tally(reader);
  state.adaptive = read_tally(reader);
  for (std::size_t left = reader.count(1); left > 0; --left) {
    const std::size_t strategy = reader.u8();
    if (strategy >= enum_values<SearchStrategy>().size()) throw reader.broken("unknown strategy");
    const std::uint64_t index = reader.u64();
    Scenario scenario = deserialize_scenario(reader.text(), where);
    state.failures.push_back({static_cast<SearchStrategy>(strategy), index, std::move(scenario),
                              trial_from_bytes(reader.text(), where)});
  }
  for (std::size_t left = reader.count(1); left > 0; --left) {
    const double clearance = reader.f64();
    state.near_misses.push_back({deserialize_scenario(reader.text(), where), clearance});
  }
  reader.expect_end();
  return state;
}

}  // namespace slalom
