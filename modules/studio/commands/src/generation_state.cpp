// SPDX-License-Identifier: BSD-3-Clause
#include "generation_state.h"

#include <slalom/core/error.h>

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

using Json = nlohmann::json;

constexpr const char *kStateNote = "generation.state", *kNone = "{}";

std::vector<MixDraw> draws_from(const Json& json) {
  std::vector<MixDraw> draws;
  for (const Json& one : json)
    draws.push_back({one.at(0).get<std::size_t>(), one.at(1).get<int>(), one.at(2).get<int>()});
  return draws;
}

Json to_json(const std::vector<MixDraw>& draws) {
  Json json = Json::array();
  for (const MixDraw& draw : draws)
    json.push_back(Json::array({draw.generator, draw.index, draw.attempt}));
  return json;
}

/// Calls `read` with the note; nothing is read if there is none.
template <typename Read>
void with_state(const ScenarioList& list, Read read) {
  try {
    const Json json = Json::parse(list.note(kStateNote).value_or(kNone));
    if (!json.empty()) read(json);
  } catch (const Json::exception&) {
    throw file_error(list.path(), "has a corrupt resume state", "an unmodified file");
  }
}

}  // namespace

SourceState read_source_state(const ScenarioList& list) {
  SourceState state;
  with_state(list, [&](const Json& json) {
    state.given = json.at("given").get<std::size_t>();
    state.passed = json.at("passed").get<std::size_t>();
    state.mix = {json.at("begun").get<int>(), draws_from(json.at("round")),
                 draws_from(json.at("redraws"))};
  });
  return state;
}

void store_source_state(ScenarioList& list, const SourceState& state) {
  const Json json = {{"given", state.given},
                     {"passed", state.passed},
                     {"begun", state.mix.begun},
                     {"round", to_json(state.mix.round)},
                     {"redraws", to_json(state.mix.redraws)}};
  list.set_note(kStateNote, json.dump());
}

std::string read_evaluations(const ScenarioList& list) {
  std::string evaluations;
  with_state(list,
             [&](const Json& json) { evaluations = json.at("evaluations").get<std::string>(); });
  return evaluations;
}

void store_evaluations(ScenarioList& list, const std::string& evaluations) {
  list.set_note(kStateNote, Json{{"evaluations", evaluations}}.dump());
}

bool is_begun(const ScenarioList& list) {
  return list.note(kStateNote).has_value();
}

void store_end_of_generation(ScenarioList& list) {
  list.set_note(kStateNote, kNone);
}

}  // namespace slalom
