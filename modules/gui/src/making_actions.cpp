#include <slalom/core/error.h>
#include <slalom/gui/form_dialog.h>
#include <slalom/gui/generation_request.h>
#include <slalom/gui/import_request.h>
#include <slalom/gui/making_actions.h>

#include <algorithm>
#include <filesystem>

namespace slalom {
namespace {

namespace fs = std::filesystem;

/// A name that is free, beside the list that is before the others.
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
  return std::to_string(count) + (count == 1 ? " scenario" : " scenarios") + " added to " + where;
}

/// Shows a list that a worker added to, and lets the user take that back.
void take_in(StudioWindow& window, AddedScenarios& added, const std::string& list) {
  ListDocument* const document = document_at(window.studio(), list);
  if (document != nullptr) {
    document->run(std::move(added.command));
    document->set_current(added.first);
  }
  window.say(added_text(added.count, list));
}

using Make = std::function<MadeList(Progress&)>;

/// Makes scenarios and adds them where they are to go, on a worker; what is left to be done on the
/// window's thread.
Jobs::Delivery make_and_add(StudioWindow& window, const std::string& list, const Make& make,
                            Progress& progress) {
  const MadeList made = make(progress);
  // Deliveries are copied; the command cannot be.
  const auto added = std::make_shared<AddedScenarios>();
  if (made.aside != nullptr) *added = add_to_list(list, made, progress);
  return [&window, list, added, file = made.file, report = made.report] {
    try {
      file.empty() ? take_in(window, *added, list) : window.studio().open_list(file);
    } catch (const Error& error) {
      window.show_message("Add scenarios", error.what());
    }
    if (!report.empty()) window.show_message("How it went", report);
  };
}

void start_making(StudioWindow& window, const std::string& title, Make make) {
  Studio& studio = window.studio();
  const std::string list = studio.active() == nullptr ? "" : studio.active()->path();
  studio.jobs().start(
      "make", title,
      [&window, list, make = std::move(make)](Progress& progress) {
        return make_and_add(window, list, make, progress);
      },
      [&window, title](const std::string& message) {
        window.say(title + ": " + message, true);
        window.show_message(title, message);
      });
}

using ReadGeneration = GenerationRequest (*)(const FormValues&);

void ask_to_generate(StudioWindow& window, const StudioServicesPtr& services, FormDescription form,
                     ReadGeneration read) {
  form.accepted = [&window, services, read, title = form.title](const FormValues& values) {
    start_making(window, title, [services, request = read(values)](Progress& progress) {
      return generate(request, services->load_map, progress);
    });
  };
  open_form(window, std::move(form));
}

void ask_to_export(StudioWindow& window, const StudioServicesPtr& services) {
  Studio& studio = window.studio();
  const Scenario scenario = studio.active()->list().read(studio.current_hash());
  FormDescription form = export_form(*services, scenario, studio.describe_options().resolution);
  form.accepted = [&window, services, scenario](const FormValues& values) {
    check_export(*services, values);
    window.studio().jobs().start(
        "export", "Export " + scenario.name(),
        [&window, services, scenario, values](Progress&) -> Jobs::Delivery {
          export_as(*services, scenario, values);
          return [&window, name = scenario.name(), file = values.at("file")] {
            window.say(name + " is exported to " + file);
          };
        },
        [&window](const std::string& message) { window.show_message("Export", message); });
  };
  open_form(window, std::move(form));
}

/// Lists and results are opened, all else is imported; in the order of their names, so that the
/// order in which they were dropped has no effect.
void take_dropped(StudioWindow& window, const StudioServicesPtr& services,
                  std::vector<std::string> files) {
  std::sort(files.begin(), files.end());
  std::vector<std::string> others;
  for (const std::string& file : files) {
    const std::string ending = fs::path(file).extension().string();
    try {
      if (ending == ".scenarios") {
        window.studio().open_list(file);
      } else if (ending == ".results") {
        window.studio().results().open(file);
      } else {
        others.push_back(file);
      }
    } catch (const Error& error) {
      window.show_message("Open", error.what());
    }
  }
  if (!others.empty()) ask_to_import(window, services, others);
}

/// While one list is made the next one waits for the user, not for a worker.
std::string making(StudioWindow& window) {
  return window.studio().jobs().is_pending("make") ? "scenarios are being made" : "";
}

}  // namespace

void ask_to_import(StudioWindow& window, const StudioServicesPtr& services,
                   const std::vector<std::string>& files) {
  FormDescription form = import_form(*services, target_of(window.studio(), "imported"), files);
  form.accepted = [&window, services](const FormValues& values) {
    start_making(window, "Import",
                 [services, request = read_import(*services, values)](Progress& progress) {
                   return import_into_list(*services, request, progress);
                 });
  };
  open_form(window, std::move(form));
}

void add_exchange_actions(StudioWindow& window, StudioServicesPtr services) {
  window.on_drop = [&window, services](const std::vector<std::string>& files) {
    take_dropped(window, services, files);
  };
  window.actions().add({"file.import", "File", "Import...", "Ctrl+Shift+I",
                        "Scenarios from maps, BARN worlds or .scenario.yaml files.",
                        [&window, services] { ask_to_import(window, services, {}); },
                        [&window] { return making(window); }});
  window.actions().add({"file.export", "File", "Export scenario...", "Ctrl+E",
                        "Writes the scenario that is shown for another program.",
                        [&window, services] { ask_to_export(window, services); },
                        [&window]() -> std::string {
                          return window.studio().current_hash().empty() ? "no scenario is shown"
                                                                        : "";
                        }});
}

void add_generate_actions(StudioWindow& window, StudioServicesPtr services) {
  const auto no_other = [&window] { return making(window); };
  window.actions().add(
      {"generate.random", "Generate", "Random scenarios...", "Ctrl+G",
       "A number of scenarios of some families, each one that the robot can solve.",
       [&window, services] {
         ask_to_generate(window, services,
                         random_generation_form(generation_defaults(window.studio())),
                         read_random_generation);
       },
       no_other});
  window.actions().add({"generate.bins", "Generate", "By bins...", "Ctrl+Shift+G",
                        "So many scenarios in each range of one or several descriptors.",
                        [&window, services] {
                          ask_to_generate(
                              window, services,
                              bins_generation_form(generation_defaults(window.studio())),
                              read_bins_generation);
                        },
                        no_other});
}

}  // namespace slalom
