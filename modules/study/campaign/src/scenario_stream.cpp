// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/campaign/scenario_sources.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {
namespace {

GenerationSettings generation_settings(const ScenarioSources& sources, int count,
                                       const std::string& name) {
  const SourceContext& context = sources.context;
  GenerationSettings settings;
  settings.count = count;
  settings.seed = source_seed(context.seed, name);
  settings.robot_radius = context.robot_radius;
  settings.footprint = context.footprint;
  settings.resolution = context.resolution;
  settings.name_prefix = name;
  settings.goal_headings = sources.section.goal_headings;
  return settings;
}

MixSettings mix_settings(const ScenarioSources& sources) {
  const ScenariosSection& section = sources.section;
  MixSettings settings;
  settings.each = generation_settings(sources, sources.families.empty() ? 0 : section.count, "");
  settings.jobs = sources.context.jobs;
  settings.representation = section.representation;
  settings.conversion_resolution = section.resolution;
  settings.walkers = section.walkers;
  settings.people = section.people;
  settings.describe = sources.context.describe;
  return settings;
}

/// Names the key for maps if what was given as a list may be one.
ScenarioList open_given_list(const std::string& path) try {
  return ScenarioList::open(path);
} catch (const Error& error) {
  if (ends_with(path, ".scenarios")) throw;
  throw Error(error.kind(), std::string(error.what()) + ", or maps = " + path + " for a map");
}

}  // namespace

ScenarioStream::ScenarioStream(const ScenarioSources& sources, const MapLoader& load_map,
                               SourceState state)
    : sources_(sources), load_map_(load_map), state_(std::move(state)) {
  if (!sources.section.list.empty()) given_.push_back(sources.section.list);
  for (const std::string& path : split(sources.section.maps, ',')) given_.push_back(path);
}

bool ScenarioStream::finished() const {
  if (state_.given < given_.size()) return false;
  return sources_.families.empty() || state_.mix.done() >= sources_.section.count;
}

std::vector<GeneratedScenario> ScenarioStream::next(Progress& progress) {
  if (state_.given >= given_.size()) return next_of_mix(progress);
  const bool is_list = state_.given == 0 && !sources_.section.list.empty();
  std::vector<GeneratedScenario> part = is_list ? next_of_list() : next_of_map();
  part_ = part.size();
  return part;
}

void ScenarioStream::commit_part(const std::vector<std::size_t>& duplicates) {
  if (state_.given >= given_.size()) {
    mix_->commit_part(duplicates);
    state_.mix = mix_->state();
    return;
  }
  // Duplicates among given scenarios are left out.
  state_.passed = ends_given_ ? 0 : state_.passed + part_;
  state_.given += ends_given_ ? 1 : 0;
}

std::vector<GeneratedScenario> ScenarioStream::next_of_list() {
  constexpr std::size_t kPart = 128;
  if (!list_) {
    list_ = std::make_unique<ScenarioList>(open_given_list(given_[0]));
    entries_ = list_->entries();
  }
  const std::size_t end = std::min(state_.passed + kPart, entries_.size());
  std::vector<GeneratedScenario> part;
  for (std::size_t i = state_.passed; i < end; ++i)
    part.push_back({list_->read(entries_[i].hash), entries_[i].generator, entries_[i].seed});
  ends_given_ = end >= entries_.size();
  return part;
}

std::vector<GeneratedScenario> ScenarioStream::next_of_map() {
  const std::string& path = given_[state_.given];
  const Scenario map = map_scenario(path, load_map_(path));
  const GenerationSettings settings =
      generation_settings(sources_, sources_.section.pairs_per_map, map.name());
  std::vector<GeneratedScenario> part;
  for (Scenario& scenario : sample_tasks(map, settings, sources_.section.min_distance))
    part.push_back({std::move(scenario), "", std::nullopt});
  ends_given_ = true;
  return part;
}

std::vector<GeneratedScenario> ScenarioStream::next_of_mix(Progress& progress) {
  if (!mix_) {
    mix_.emplace(sources_.families, mix_settings(sources_), state_.mix);
    progress.start("Generating scenarios", static_cast<std::size_t>(sources_.section.count));
    if (state_.mix.done() > 0) progress.advance(static_cast<std::size_t>(state_.mix.done()));
  }
  return mix_->next(progress);
}

void stream_scenarios(const ScenarioSources& sources, const MapLoader& load_map, Progress& progress,
                      const GenerationSink& sink) {
  ScenarioStream stream(sources, load_map);
  while (!stream.finished()) {
    std::vector<GeneratedScenario> part = stream.next(progress);
    stream.commit_part(sink(part));
  }
  if (!sources.families.empty()) progress.finish();
}

std::vector<Scenario> collect_scenarios(const ScenarioSources& sources, const MapLoader& load_map,
                                        Progress& progress) {
  DistinctScenarios distinct;
  stream_scenarios(sources, load_map, progress,
                   [&](std::vector<GeneratedScenario>& part) { return distinct.add(part); });
  return distinct.take();
}

}  // namespace slalom
