// SPDX-License-Identifier: BSD-3-Clause
#include "forms/requests.h"

#include <slalom/core/error.h>

#include <filesystem>

namespace slalom {

FormDescription shrink_form(const RunRecord& run, const std::string& folder) {
  FormDescription form;
  form.title = "Shrink " + run.method + " " + std::to_string(run.repetition);
  form.accept = "Shrink";
  form.intro = "Finds the smallest scenario in which " + run.method + " ends as " + run.outcome +
               ", and adds it to the list.";
  FormField target{
      "folder", "Folder", FieldKind::Text,
      folder,   "",       "new folder for the proof, a campaign that repeats it and a report"};
  target.wide = true;
  target.extensions = {"/"};
  FormField witness{"witness", "Witness", FieldKind::Flag,
                    "true",    "",        "another method of the campaign must reach the goal"};
  FormField max_runs{"max_runs", "Maximum runs", FieldKind::Integer, "5000", "", "to shrink it"};
  max_runs.range = Range::between(1, 1e9);
  FormField trust{"trust",
                  "Trust the results",
                  FieldKind::Flag,
                  "false",
                  "",
                  "execute the libraries, modules and commands that they name"};
  form.fields = {target, witness, max_runs, trust};
  return form;
}

StudioServices::ShrinkRequest read_shrink(const std::string& results, const RunRecord& run,
                                          const FormValues& values) {
  const std::string& folder = values.at("folder");
  if (std::filesystem::exists(folder))
    throw usage_error(folder, "already exists", "the path of a new folder");
  return {results,
          run_id(run),
          folder,
          values.at("max_runs"),
          values.at("witness") == "true",
          values.at("trust") == "true"};
}

NewList shrink_into_list(const StudioServices& services,
                         const StudioServices::ShrinkRequest& request, Progress& progress) {
  std::string report;
  NewList made = make_list("", [&](ScenarioList& list) {
    report = services.shrink_run(request, progress);
    const ScenarioList found = ScenarioList::open(request.folder + "/failures.scenarios");
    for (const ScenarioList::Entry& entry : found.entries())
      list.add(found.read(entry.hash), {"", std::nullopt, entry.tags});
  });
  made.report = std::move(report);
  return made;
}

}  // namespace slalom
