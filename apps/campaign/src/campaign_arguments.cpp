// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/campaign_arguments.h>
#include <slalom/app/campaign_names.h>
#include <slalom/app/existing_options.h>
#include <slalom/app/program.h>

namespace slalom {

void add_campaign_options(CLI::App& app, CampaignArguments& arguments) {
  add_jobs_option(app, arguments.jobs, "Worker processes, and threads for scenario generation");
  app.add_option("--seed", arguments.seed, "Seed instead of [campaign] seed");
  CLI::Option* set =
      app.add_option("--set", arguments.overrides, "Override a key of the .ini: SECTION.KEY=VALUE")
          ->take_all()
          ->allow_extra_args(false);
  complete_with(set, setting_names);
  add_existing_options(app, arguments.existing, arguments.take_over);
  app.add_flag_callback(
         "--keep-finished", [&arguments] { arguments.existing = ExistingResults::KeepFinished; },
         "Continue although a program, library, module or model of a method has changed: the "
         "finished runs are kept, and the results say so")
      ->excludes("--resume", "--overwrite");
  app.add_flag("--quiet", arguments.quiet, "No progress and no messages, except errors");
}

}  // namespace slalom
