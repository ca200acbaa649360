// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/scratch_folder.h>
#include <slalom/core/text.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_list.h>
#include <slalom/studio/actions.h>
#include <slalom/studio/studio.h>

#include <filesystem>
#include <map>

namespace slalom {
namespace {

constexpr const char* kRunKey = "run";
const char* const kRunTitle = "Run methods here";

std::string campaign_of(Studio& studio) {
  const std::string& chosen = studio.run_choice().campaign;
  if (!chosen.empty()) return chosen;
  return studio.services().campaign.empty() ? studio.results().path() : studio.services().campaign;
}

/// Holds what a process made: a result file in `folder`, and why it failed if it did.
struct MadeRuns {
  StudioServices::RunRequest request;
  std::shared_ptr<const ScratchFolder> folder = std::make_shared<ScratchFolder>();
  OverlaySource source;
  std::vector<RunRecord> runs;
  std::string error;
};

/// Runs that ended before an error, such as a crash of each, are shown too.
MadeRuns make_runs(const StudioServices& services, const Scenario& scenario,
                   StudioServices::RunRequest request, Progress& progress) {
  MadeRuns made;
  made.request = request;
  request.list = made.folder->path() + "/one.scenarios";
  request.results = made.folder->path() + "/runs.results";
  ScenarioList::write(request.list, [&](ScenarioList& list) { list.add(scenario); });
  try {
    services.run_methods(request, progress);
  } catch (const Error& error) {
    made.error = error.what();
  }
  if (!std::filesystem::exists(request.results)) return made;
  made.source = open_overlay_source(request.results);
  made.source.here = true;
  made.runs = ResultFile::open(request.results).read_runs(scenario.hash());
  return made;
}

/// "4 runs on passage: 3 success, 1 collision".
std::string summary_of(const std::vector<RunRecord>& runs, const std::string& scenario) {
  std::map<std::string, std::size_t> outcomes;
  for (const RunRecord& run : runs) ++outcomes[run.outcome];
  std::vector<std::string> parts;
  for (const auto& [outcome, count] : outcomes)
    parts.push_back(std::to_string(count) + " " + outcome);
  return count_text(runs.size(), "run") + " on " + scenario + ": " + join(parts, ", ");
}

void run_methods_here(Studio& studio);

/// Asks whether the results are trusted, if that is what they lack.
void show_failure(Studio& studio, const MadeRuns& made) {
  const std::string error = made.error.empty() ? "no run ended" : made.error;
  // The words of the refusal in apps/campaign.
  if (made.request.trust || error.find("would execute what the file names") == std::string::npos)
    return studio.events().show_error(
        error + " (Generate > Campaign of runs... chooses another campaign)", kRunTitle);
  studio.events().show_status(error, true);
  studio.events().show_form({kRunTitle,
                             "Trust and run",
                             error,
                             {},
                             [&studio, campaign = made.request.campaign](const FormValues&) {
                               studio.run_choice().trusted = campaign;
                               run_methods_here(studio);
                             }});
}

void show_made_runs(Studio& studio, const MadeRuns& made, const std::string& hash,
                    const std::string& name) {
  if (made.runs.empty()) return show_failure(studio, made);
  studio.results().show_here(hash, made.source, made.folder);
  std::string text = summary_of(made.runs, name);
  if (hash != studio.current_hash()) text += "; select it to see them";
  if (!made.error.empty()) text += "; the line below the table says why";
  studio.events().show_status(text, !made.error.empty());
}

std::string run_disabled_reason(Studio& studio) {
  if (!studio.services().run_methods) return "this program does not run methods";
  if (studio.current_hash().empty()) return "no scenario is shown";
  if (campaign_of(studio).empty())
    return "no campaign is open: open results, or choose an .ini by Generate > Campaign of runs...";
  return studio.jobs().is_pending(kRunKey) ? "methods are running; the status bar cancels them"
                                           : "";
}

void run_methods_here(Studio& studio) {
  const Scenario scenario = studio.active()->list().read(studio.current_hash());
  StudioServices::RunRequest request;
  request.campaign = campaign_of(studio);
  request.trust = studio.run_choice().trusted == request.campaign;
  studio.jobs().start(
      kRunKey, "Run methods on " + scenario.name(),
      [&studio, scenario, request](Progress& progress) -> Jobs::Delivery {
        return [&studio, made = make_runs(studio.services(), scenario, request, progress),
                hash = scenario.hash(),
                name = scenario.name()] { show_made_runs(studio, made, hash, name); };
      },
      [&studio](const std::string& message) { studio.events().show_error(message, kRunTitle); });
}

FormDescription campaign_form(Studio& studio) {
  const std::string campaign = campaign_of(studio);
  FormField path{"campaign", "Campaign", FieldKind::Text,
                 campaign,   "",         "its .ini, or a .results file that contains it"};
  path.wide = true;
  path.extensions = {".ini", ".results"};
  FormField trust{"trust",
                  "Trust the results",
                  FieldKind::Flag,
                  !campaign.empty() && studio.run_choice().trusted == campaign ? "true" : "false",
                  "",
                  "execute the libraries, modules and commands that they name"};
  return {"Campaign of runs",
          "Choose",
          "All its methods are run by 'Run methods here', with its seed and repetitions.",
          {path, trust},
          [&studio](const FormValues& values) {
            const std::string& chosen = values.at("campaign");
            if (!std::filesystem::exists(chosen))
              throw usage_error(chosen, "does not exist", "the .ini of a campaign, or results");
            Studio::RunChoice& choice = studio.run_choice();
            choice.campaign.clear();
            // The default follows the open results.
            if (campaign_of(studio) != chosen) choice.campaign = chosen;
            choice.trusted = values.at("trust") == "true" ? chosen : "";
          }};
}

}  // namespace

void add_run_actions(Actions& actions, Studio& studio) {
  actions.add({"generate.run", "Generate", kRunTitle, "F9",
               "Runs the methods of the campaign on the current scenario and shows their runs.",
               [&studio] { run_methods_here(studio); },
               [&studio] { return run_disabled_reason(studio); }});
  actions.add({"generate.campaign", "Generate", "Campaign of runs...", "",
               "Chooses the campaign whose methods are run, and whether its results are trusted.",
               [&studio] { studio.events().show_form(campaign_form(studio)); }});
  actions.add({"generate.discard", "Generate", "Discard runs made here", "",
               "Shows the runs of the open result file again.",
               [&studio] { studio.results().discard_here(); },
               [&studio]() -> std::string {
                 return studio.results().shows_here() ? ""
                                                      : "no runs on this scenario were made here";
               }});
}

}  // namespace slalom
