#include <slalom/app/campaign_arguments.h>

namespace slalom {

void add_campaign_options(CLI::App& app, CampaignArguments& arguments) {
  app.add_option("-j,--jobs", arguments.jobs,
                 "Worker processes, and threads for scenario generation")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--seed", arguments.seed, "Seed instead of [campaign] seed");
  app.add_option("--set", arguments.overrides, "Override a key of the .ini: SECTION.KEY=VALUE")
      ->take_all()
      ->allow_extra_args(false);
  const auto existing = [&arguments](ExistingResults choice) {
    return [&arguments, choice] { arguments.existing = choice; };
  };
  CLI::Option* resume =
      app.add_flag_callback("--resume", existing(ExistingResults::Require),
                            "Fail unless there are results to continue. Without it they are "
                            "continued if they exist");
  app.add_flag_callback("--overwrite", existing(ExistingResults::Overwrite),
                        "Start over: replace the results of this or another campaign")
      ->excludes(resume);
  app.add_flag("--take-over", arguments.take_over,
               "Take the lock of a program on another host, which must have ended");
  app.add_flag("--quiet", arguments.quiet, "No progress and no messages, except errors");
}

}  // namespace slalom
