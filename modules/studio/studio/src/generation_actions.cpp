// SPDX-License-Identifier: BSD-3-Clause
#include "forms/requests.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/studio/actions.h>
#include <slalom/studio/studio.h>

#include <algorithm>
#include <filesystem>

namespace slalom {
namespace {

namespace fs = std::filesystem;

/// An unused file name in the folder of the active list.
std::string new_file(const Studio& studio, const std::string& stem) {
  const fs::path folder =
      studio.active() == nullptr ? fs::path() : fs::path(studio.active()->path()).parent_path();
  fs::path file = folder / (stem + ".scenarios");
  for (int i = 2; fs::exists(file); ++i)
    file = folder / (stem + "_" + std::to_string(i) + ".scenarios");
  return file.string();
}

ListTarget target_of(const Studio& studio, const std::string& stem) {
  return {studio.active() != nullptr, new_file(studio, stem)};
}

GenerationDefaults generation_defaults(Studio& studio) {
  const SceneSettings& settings = studio.scenes().settings();
  GenerationDefaults defaults;
  defaults.robot_radius = settings.robot.radius;
  defaults.sensor_range = settings.sensor.max_range;
  defaults.resolution = settings.resolution;
  defaults.target = target_of(studio, "generated");
  return defaults;
}

ListDocument* document_at(const Studio& studio, const std::string& path) {
  for (const auto& document : studio.documents())
    if (document->path() == path) return document.get();
  return nullptr;
}

std::string added_text(std::size_t count, const std::string& where) {
  return count_text(count, "scenario") + " added to " + where;
}

/// Shows a list that a worker thread added to, and adds the change to its undo history.
void show_added(Studio& studio, AddedScenarios& added, const std::string& list) {
  ListDocument* const document = document_at(studio, list);
  if (document != nullptr) {
    document->run(std::move(added.command));
    document->set_current(added.first);
  }
  studio.events().show_status(added_text(added.count, list));
}

using CreateList = std::function<NewList(Progress&)>;

/// Creates scenarios and adds them to their target, in a worker thread. Returns the work for the
/// thread of the window.
Jobs::Delivery create_and_add(Studio& studio, const std::string& list, const CreateList& create,
                              Progress& progress) {
  const NewList made = create(progress);
  // Shared, because deliveries are copied and the command cannot be. Null without new scenarios.
  std::shared_ptr<AddedScenarios> added;
  if (made.staging != nullptr)
    added = std::make_shared<AddedScenarios>(add_to_list(list, made, progress));
  return [&studio, list, added, file = made.file, report = made.report] {
    try {
      if (!file.empty())
        studio.open_list(file);
      else if (added != nullptr)
        show_added(studio, *added, list);
    } catch (const Error& error) {
      studio.events().show_message("Add scenarios", error.what());
    }
    if (!report.empty()) studio.events().show_message("Result", report);
  };
}

void start_job(Studio& studio, const std::string& title, CreateList create) {
  const std::string list = studio.active() == nullptr ? "" : studio.active()->path();
  studio.jobs().start(
      "make", title,
      [&studio, list, create = std::move(create)](Progress& progress) {
        return create_and_add(studio, list, create, progress);
      },
      [&studio, title](const std::string& message) {
        studio.events().show_status(title + ": " + message, true);
        studio.events().show_message(title, message);
      });
}

using ReadGeneration = GenerationRequest (*)(const FormValues&);

void open_generation_form(Studio& studio, FormDescription form, ReadGeneration read) {
  form.accepted = [&studio, read, title = form.title](const FormValues& values) {
    start_job(studio, title, [&studio, request = read(values)](Progress& progress) {
      return generate(request, studio.services().load_map, progress);
    });
  };
  studio.events().show_form(std::move(form));
}

void open_export_form(Studio& studio) {
  const Scenario scenario = studio.active()->list().read(studio.current_hash());
  FormDescription form =
      export_form(studio.services(), scenario, studio.describe_options().resolution);
  form.accepted = [&studio, scenario](const FormValues& values) {
    check_export(studio.services(), values);
    studio.jobs().start(
        "export", "Export " + scenario.name(),
        [&studio, scenario, values](Progress&) -> Jobs::Delivery {
          const std::string left_out = export_as(studio.services(), scenario, values);
          return [&studio, left_out, name = scenario.name(), file = values.at("file")] {
            studio.events().show_status(name + " was exported to " + file);
            if (!left_out.empty()) studio.events().show_message("Export", left_out);
          };
        },
        [&studio](const std::string& message) { studio.events().show_message("Export", message); });
  };
  studio.events().show_form(std::move(form));
}

/// Only one generation, import, search or shrinking runs at a time.
std::string busy_reason(Studio& studio) {
  return studio.jobs().is_pending("make")
             ? "scenarios are being generated, imported, searched or shrunk"
             : "";
}

/// An unused folder beside a file.
std::string new_folder(const std::string& file, const std::string& name) {
  fs::path folder = fs::path(file).parent_path() / name;
  for (int i = 2; fs::exists(folder); ++i) folder.replace_filename(name + "_" + std::to_string(i));
  return folder.string();
}

std::string new_shrink_folder(const std::string& results, const RunRecord& run) {
  std::string name = "shrunk_" + run_id(run);
  std::replace(name.begin(), name.end(), '/', '_');
  return new_folder(results, name);
}

std::string search_disabled_reason(Studio& studio) {
  return studio.services().search_failures ? busy_reason(studio)
                                           : "this program does not search failures";
}

void open_search_form(Studio& studio) {
  FormDescription form = search_form(
      new_folder(studio.active() == nullptr ? "" : studio.active()->path(), "failures"));
  form.accepted = [&studio](const FormValues& values) {
    const StudioServices::SearchRequest request = read_search(values);
    start_job(studio, "Search failures of " + request.method,
              [&studio, request](Progress& progress) {
                return search_into_list(studio.services(), request, progress);
              });
  };
  studio.events().show_form(std::move(form));
}

void open_import_form(Studio& studio, const std::vector<std::string>& files) {
  FormDescription form = import_form(studio.services(), target_of(studio, "imported"), files);
  form.accepted = [&studio](const FormValues& values) {
    start_job(studio, "Import",
              [&studio, request = read_import(studio.services(), values)](Progress& progress) {
                return import_into_list(studio.services(), request, progress);
              });
  };
  studio.events().show_form(std::move(form));
}

}  // namespace

std::string shrink_disabled_reason(Studio& studio) {
  if (!studio.services().shrink_run) return "this program does not shrink runs";
  const RunRecord* run = studio.results().overlay().selected();
  if (run == nullptr) return "no run of a result file is selected";
  if (run->outcome == "success") return "the robot reached the goal in this run";
  return studio.active() == nullptr ? "no list is open" : busy_reason(studio);
}

void open_shrink_form(Studio& studio) {
  const std::string results = studio.results().overlay().source().path;
  const RunRecord run = *studio.results().overlay().selected();
  // The folder of runs that were made here is a temporary one.
  const bool here = studio.results().overlay().source().here;
  FormDescription form =
      shrink_form(run, new_shrink_folder(here ? studio.active()->path() : results, run));
  form.accepted = [&studio, results, run](const FormValues& values) {
    start_job(studio, "Shrink " + run_id(run),
              [&studio, request = read_shrink(results, run, values)](Progress& progress) {
                return shrink_into_list(studio.services(), request, progress);
              });
  };
  studio.events().show_form(std::move(form));
}

/// Sorted by name, so that the order of the files has no effect.
void open_files(Studio& studio, std::vector<std::string> files) {
  std::sort(files.begin(), files.end());
  std::vector<std::string> others;
  for (const std::string& file : files) {
    const std::string extension = fs::path(file).extension().string();
    try {
      if (extension == ".scenarios")
        studio.open_list(file);
      else if (extension == ".results")
        studio.results().open(file);
      else
        others.push_back(file);
    } catch (const Error& error) {
      studio.events().show_message("Open", error.what());
    }
  }
  if (!others.empty()) open_import_form(studio, others);
}

void add_import_export_actions(Actions& actions, Studio& studio) {
  actions.add({"file.import", "File", "Import...", "Ctrl+Shift+I",
               "Imports maps, BARN worlds or .scenario.yaml files.",
               [&studio] { open_import_form(studio, {}); },
               [&studio] { return busy_reason(studio); }});
  actions.add({"file.export", "File", "Export scenario...", "Ctrl+E",
               "Exports the current scenario to the format of another program.",
               [&studio] { open_export_form(studio); },
               [&studio]() -> std::string {
                 return studio.current_hash().empty() ? "no scenario is shown" : "";
               }});
}

void add_generate_actions(Actions& actions, Studio& studio) {
  const auto disabled_check = [&studio] { return busy_reason(studio); };
  actions.add({"generate.random", "Generate", "Random scenarios...", "Ctrl+G",
               "Generates scenarios of chosen families that are solvable for the robot.",
               [&studio] {
                 open_generation_form(studio, random_generation_form(generation_defaults(studio)),
                                      read_random_generation);
               },
               disabled_check});
  actions.add({"generate.bins", "Generate", "By bins...", "Ctrl+Shift+G",
               "Generates a number of scenarios for each range of one or several descriptors.",
               [&studio] {
                 open_generation_form(studio, bins_generation_form(generation_defaults(studio)),
                                      read_bins_generation);
               },
               disabled_check});
  actions.add({"generate.search", "Generate", "Search failures...", "",
               "Searches scenarios in which a method fails, and shrinks them.",
               [&studio] { open_search_form(studio); },
               [&studio] { return search_disabled_reason(studio); }});
  actions.add({"generate.shrink", "Generate", "Shrink run...", "",
               "Finds the smallest scenario that reproduces the failure of the run.",
               [&studio] { open_shrink_form(studio); },
               [&studio] { return shrink_disabled_reason(studio); }});
}

}  // namespace slalom
