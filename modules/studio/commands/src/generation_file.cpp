// SPDX-License-Identifier: BSD-3-Clause
#include "generation_state.h"

#include <slalom/commands/generation_file.h>
#include <slalom/core/error.h>
#include <slalom/core/hash.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/core/version.h>
#include <slalom/io/campaign_identity.h>
#include <slalom/io/file_lock.h>
#include <slalom/io/list_hash.h>

#include <filesystem>

namespace slalom {
namespace {

constexpr const char* kGenerationNote = "generation";

bool matters(const std::string& section, const std::string& key) {
  if (section == "scenarios" || section == "coverage" || starts_with(section, "generator."))
    return true;
  const std::string name = section + "." + key;
  return contains({"robot.radius", "robot.footprint", "sensor.max_range", "simulation.resolution"},
                  name);
}

/// The content of a file that the .ini names.
std::string hash_of_file(const std::string& path) {
  if (ends_with(path, ".scenarios")) return content_hash(ScenarioList::open(path));
  return Hasher().add(read_file(path, "a map")).hex();
}

/// Everything that may change the scenarios, as .ini text.
std::string identity_of(const IniFile& ini, const GenerationOptions& options) {
  IniFile identity = IniFile::from_text("");
  for (const std::string& section : ini.sections())
    for (const std::string& key : ini.keys(section)) {
      if (!matters(section, key)) continue;
      const std::string text = ini.get(section, key).value_or("");
      identity.set(section, key, text);
      for (const std::string& path : split(text, ','))
        if (std::error_code ignored; std::filesystem::is_regular_file(path, ignored))
          identity.set("files", path, hash_of_file(path));
    }
  identity.set("generation", "seed", std::to_string(options.seed));
  identity.set("generation", "descriptors", join(options.descriptors, ","));
  identity.set("generation", "version", version());
  return identity.canonical_text();
}

/// Throws Error (File) unless the list is of that generation.
void expect_same_generation(const ScenarioList& list, const std::string& identity) {
  constexpr const char* kRemedy = "the same generation, another output, or --overwrite";
  const auto stored = list.note(kGenerationNote);
  if (!stored)
    throw file_error(list.path(), "was not written by slalom-scenarios generate", kRemedy);
  const auto differences =
      identity_differences({{kEffectiveKey, identity}}, {{kEffectiveKey, *stored}});
  if (!differences.empty())
    throw file_error(list.path(),
                     "is of another generation: " + enumerate(differences, list.path()), kRemedy);
}

std::string are_there(std::size_t scenarios) {
  return count_text(scenarios, "scenario") + (scenarios == 1 ? " is there" : " are there");
}

bool is_there(const std::string& path) {
  return std::filesystem::exists(path);
}

/// Whether the partial list of this generation exists. One of another generation is an error,
/// unless it contains nothing.
bool find_partial(const std::string& path, const std::string& identity,
                  const std::function<void(const std::string&)>& notify) {
  if (!is_there(path)) return false;
  const ScenarioList list = ScenarioList::open(path);
  if (!is_begun(list)) return false;
  expect_same_generation(list, identity);
  notify("continues: " + are_there(list.size()));
  return true;
}

}  // namespace

std::optional<GeneratedBins> generate_file(const GenerationFile& file, const IniFile& ini,
                                           const GenerationOptions& options,
                                           const MapLoader& load_map, Progress& progress) {
  ScenarioList::expect_replaceable(file.path);
  const FileLock lock(file.path, file.take_over, file.notify);
  const std::string partial = file.path + ".partial", identity = identity_of(ini, options);
  const bool starts_over = file.existing == ExistingResults::Overwrite;
  if (!starts_over && is_there(file.path)) {
    const ScenarioList list = ScenarioList::open(file.path);
    expect_same_generation(list, identity);
    file.notify((list.size() == 1 ? "" : "all ") + are_there(list.size()));
    return std::nullopt;
  }
  if (starts_over || !find_partial(partial, identity, file.notify)) {
    if (file.existing == ExistingResults::Require)
      throw file_error(file.path, "does not exist", "a list to continue, or no --resume");
    ScenarioList::write(partial,
                        [&](ScenarioList& list) { list.set_note(kGenerationNote, identity); });
  }
  std::optional<GeneratedBins> bins;
  try {
    ScenarioList list = ScenarioList::open(partial);
    bins = generate_list(list, ini, options, load_map, progress);
    list.save_as(file.path);  // rewritten: its bytes do not depend on interruptions
  } catch (...) {
    if (!is_begun(ScenarioList::open(partial))) ScenarioList::remove_file(partial);
    throw;
  }
  ScenarioList::remove_file(partial);
  return bins;
}

}  // namespace slalom
