// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/byte_stream.h>
#include <slalom/core/error.h>
#include <slalom/core/hash.h>
#include <slalom/core/read_file.h>
#include <slalom/falsification/search_files.h>
#include <slalom/io/result_file.h>

#include <filesystem>

namespace slalom {
namespace {

std::string key_of(const FoundFailure& found) {
  return to_string(found.strategy) + " " + std::to_string(found.index);
}

}  // namespace

std::string search_identity(const std::string& methods, const FalsificationSetup& setup,
                            const SearchOptions& options) {
  Hasher hasher;
  hasher.add(methods).add(setup.method.name);
  for (const NamedMethod& witness : setup.witnesses) hasher.add(witness.name);
  const WalkerOptions& walkers = setup.walkers;
  hasher.add(std::uint64_t(walkers.count)).add(walkers.min_radius).add(walkers.max_radius);
  hasher.add(walkers.min_speed).add(walkers.max_speed);
  if (const PeopleOptions& people = setup.people; people.count > 0) {
    hasher.add(std::uint64_t(people.count)).add(people.min_radius).add(people.max_radius);
    hasher.add(people.min_speed).add(people.max_speed);
    hasher.add(std::uint64_t{setup.unnoticed_witness});
  }
  const FairnessOptions& fairness = options.fairness;
  hasher.add(fairness.min_bottleneck).add(fairness.min_start_clearance).add(fairness.min_distance);
  hasher.add(static_cast<std::uint64_t>(fairness.witness)).add(std::uint64_t{options.probe});
  hasher.add(options.seed).add(std::uint64_t{options.max_failures});
  for (const Outcome outcome : options.outcomes) hasher.add(to_string(outcome));
  return hasher.hex();
}

SearchState StateFile::load(ExistingResults existing) const {
  const bool exists = std::filesystem::exists(path_);
  if (existing == ExistingResults::Require && !exists)
    throw usage_error("--resume", "there is no search to continue in " + path_);
  if (existing == ExistingResults::Overwrite || !exists) return {};
  const std::string bytes = read_file(path_, "the state of a search");
  if (bytes.compare(0, search_.size(), search_) != 0)
    throw usage_error(path_, "is of a search with other settings",
                      "another folder, or --overwrite to start over");
  return search_state_from_bytes(bytes.substr(search_.size()), path_);
}

void StateFile::save(const SearchState& state) const {
  write_file_atomically(path_, search_ + to_bytes(state));
}

ShrunkFile::ShrunkFile(const std::string& folder, const std::string& search,
                       const ShrinkOptions& options, ExistingResults existing)
    : path_(folder + "/search.shrunk") {
  Hasher hasher;
  hasher.add(search).add(std::uint64_t{options.max_runs});
  identity_ = hasher.add(std::uint64_t{options.fairness.repeatable}).hex();
  if (existing == ExistingResults::Overwrite || !std::filesystem::exists(path_)) return;
  const std::string bytes = read_file(path_, "shrunk failures");
  ByteReader reader(bytes, path_);
  if (reader.text() != identity_) return;
  for (std::size_t left = reader.count(2 * sizeof(std::uint64_t)); left > 0; --left) {
    const std::string key = reader.text();
    known_.emplace(key, shrink_result_from_bytes(reader.text(), path_));
  }
  reader.expect_end();
}

const ShrinkResult* ShrunkFile::find(const FoundFailure& found) const {
  const auto known = known_.find(key_of(found));
  return known == known_.end() ? nullptr : &known->second;
}

void ShrunkFile::save(const FoundFailure& found, const ShrinkResult& small) {
  known_.emplace(key_of(found), small);
  ByteWriter writer;
  writer.text(identity_).u64(known_.size());
  for (const auto& [key, result] : known_) writer.text(key).text(to_bytes(result));
  write_file_atomically(path_, writer.take());
}

}  // namespace slalom
