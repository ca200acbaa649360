// SPDX-License-Identifier: BSD-3-Clause
#include "services.h"

#include <slalom/app/import_scenarios.h>
#include <slalom/core/child_process.h>
#include <slalom/core/error.h>
#include <slalom/core/options.h>
#include <slalom/core/program_path.h>
#include <slalom/core/progress_line.h>
#include <slalom/core/text.h>
#include <slalom/core/version.h>
#include <slalom/map_formats/map_export.h>

#include <cstdlib>
#include <filesystem>

namespace slalom {
namespace {

using Visit = void (ImportRequest::*)(OptionVisitor&);

VisitOptions defaults_of(Visit visit) {
  return [visit](OptionVisitor& visitor) {
    ImportRequest request;
    (request.*visit)(visitor);
  };
}

StudioServices::ImportedFiles import_files(const std::vector<std::string>& files,
                                           const IniFile& options, Progress& progress) {
  ImportRequest request = read_options<ImportRequest>(options, "import");
  request.files = files;
  ImportedScenarios imported = import_scenarios(request, progress);
  return {std::move(imported.scenarios), std::move(imported.notes), std::move(imported.messages)};
}

std::string export_to(const Scenario& scenario, const std::string& format, double resolution,
                      const std::string& path) {
  MapExportOptions options;
  options.resolution = resolution;
  return export_scenario(scenario, format, options, path);
}

/// Runs another program of Slalom, since methods run in processes that the window must not fork:
/// only the forking thread survives in them, and locks held by others are never released. Returns
/// what it printed.
std::string execute(const std::string& program, std::vector<std::string> command,
                    Progress& progress) {
  command.insert(command.begin(), program_folder() + "/" + program);
  std::string output, last;
  ProgressLine now;
  const auto read_line = [&](const std::string& line) {
    if (const auto shown = parse_progress_line(line)) {
      now = *shown;
      return progress.start(now.what, now.total);
    }
    output += line + "\n";
    if (!line.empty()) last = line;
  };
  const int status = execute_program(command, read_line, [&] { progress.advance(now.done); });
  if (status == 0) return output;
  const std::string prefix = program + ": ";
  if (!starts_with(last, prefix))
    throw job_error(program, "ended with status " + std::to_string(status));
  throw Error(ErrorKind::Job, last.substr(prefix.size()));
}

std::string shrink_run(const StudioServices::ShrinkRequest& request, Progress& progress) {
  std::vector<std::string> command = {"shrink",   request.results, "--run",      request.run,
                                      "--output", request.folder,  "--max-runs", request.max_runs};
  if (!request.requires_witness) command.emplace_back("--no-witness");
  if (request.trust) command.emplace_back("--trust");
  return execute("slalom-falsify", std::move(command), progress);
}

std::string search_failures(const StudioServices::SearchRequest& request, Progress& progress) {
  std::vector<std::string> command = {"search",     request.campaign, "--method", request.method,
                                      "--output",   request.folder,   "--runs",   request.runs,
                                      "--failures", request.failures};
  if (request.all_outcomes) command.emplace_back("--all-outcomes");
  if (!request.requires_witness) command.emplace_back("--no-witness");
  return execute("slalom-falsify", std::move(command), progress);
}

/// Records trajectories, and nothing beside the result file.
void run_methods(const StudioServices::RunRequest& request,
                 const std::vector<std::string>& assignments, Progress& progress) {
  std::vector<std::string> command = {"run",      request.campaign, "--scenarios", request.list,
                                      "--output", request.results,  "--jobs",      "0"};
  if (request.trust) command.emplace_back("--trust");
  std::vector<std::string> all = assignments;
  all.insert(all.end(), {"record.rawlog=none", "record.bag=none", "record.trajectories=all"});
  for (const std::string& assignment : all) command.insert(command.end(), {"--set", assignment});
  execute("slalom-simulate", std::move(command), progress);
}

/// The user's folder for what can be made again.
std::string cache_folder() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  if (cache != nullptr && *cache != '\0') return cache;
  const char* home = std::getenv("HOME");
  if (home == nullptr || *home == '\0')
    throw job_error("demo", "no folder for it", "XDG_CACHE_HOME or HOME");
  return std::string(home) + "/.cache";
}

std::string make_demo(Progress& progress) {
  std::string folder = cache_folder() + "/slalom/demo-" + version();
  if (!std::filesystem::exists(folder + "/report/index.html"))
    execute("slalom-evaluate", {"--demo", "--output", folder, "--jobs", "0"}, progress);
  return folder;
}

}  // namespace

StudioServices make_services(const std::string& campaign,
                             const std::vector<std::string>& assignments) {
  StudioServices services;
  services.campaign = campaign;
  services.run_methods = [assignments](const StudioServices::RunRequest& request,
                                       Progress& progress) {
    run_methods(request, assignments, progress);
  };
  services.make_demo = make_demo;
  services.load_map = load_occupancy_grid;
  services.import_options = {{"Start and goal on maps", defaults_of(&ImportRequest::visit_pairs)},
                             {"Maps", defaults_of(&ImportRequest::visit_maps)},
                             {"Data sets", defaults_of(&ImportRequest::visit_data_sets)}};
  services.import_files = import_files;
  for (const ExportFormat& format : export_formats())
    services.export_formats.push_back({format.name, format.ending, format.content});
  services.export_scenario = export_to;
  services.shrink_run = shrink_run;
  services.search_failures = search_failures;
  return services;
}

}  // namespace slalom
