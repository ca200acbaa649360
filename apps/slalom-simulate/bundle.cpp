// SPDX-License-Identifier: BSD-3-Clause
#include "verbs.h"

#include <slalom/app/bundled_methods.h>
#include <slalom/app/external_options.h>
#include <slalom/app/output_folder.h>
#include <slalom/app/program.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_list.h>
#include <slalom/methods/registry.h>
#include <slalom/results/recorded_ini.h>

#include <filesystem>
#include <iostream>

namespace slalom {
namespace {

struct BundleArguments {
  std::string results, output;
  CampaignArguments campaign;
  bool with_sources = false;
};

void bundle(const BundleArguments& arguments) {
  const IniFile ini =
      arguments.campaign.config.empty()
          ? recorded_ini(ResultFile::open(arguments.results).read_manifest(), arguments.results)
          : load_campaign_ini(arguments.campaign);
  CampaignConfig config = read_campaign(ini);
  if (arguments.with_sources) {  // what methods need is known when they are built
    if (arguments.campaign.config.empty())
      require_no_foreign_code(ini, method_sections(ini, config.methods), arguments.results,
                              "-c with the campaign's .ini");
    check_campaign(config);
  }
  std::cout << write_campaign_bundle(arguments.results, arguments.output, config,
                                     arguments.with_sources)
            << "\n";
}

/// The names of files are the author's: none of the user's may be replaced.
void unpack(const std::string& path, const std::string& folder) {
  make_output_folder(folder);
  if (!std::filesystem::is_empty(folder))
    throw usage_error(folder, "is not empty", "a new or an empty folder");
  const std::string ini = unpack_methods(path, folder);
  const ResultFile file = ResultFile::open(path);
  const std::string list = (std::filesystem::path(folder) / "campaign.scenarios").string();
  ScenarioList::write(list, [&](ScenarioList& scenarios) {
    for (const auto& [hash, name] : file.read_scenario_names())
      scenarios.add(file.read_scenario(hash));
  });
  std::cout << ini << ", " << list << "\n";
}

}  // namespace

void define_bundle(CLI::App& app) {
  static BundleArguments arguments;
  CLI::App* verb = app.add_subcommand(
      "bundle", "Write a result that others can verify into one small file (.slalom)");
  verb->add_option("results", arguments.results, "A result file (.results)")->required();
  verb->add_option("-o,--output", arguments.output, "The bundle (.slalom) to write")->required();
  verb->add_option("-c,--config", arguments.campaign.config,
                   "The campaign's .ini, if its files are elsewhere; default: that in the results");
  verb->add_flag("--with-sources", arguments.with_sources,
                 "With the libraries, modules and models that the methods consist of");
  verb->callback([] { bundle(arguments); });

  static std::string path, folder;
  CLI::App* unpacking = app.add_subcommand(
      "unpack", "Write the campaign, the scenarios and the methods of a bundle into a folder");
  unpacking->add_option("bundle", path, "A bundle (.slalom)")->required();
  unpacking->add_option("-o,--output", folder, "The folder to write")->required();
  unpacking->callback([] { unpack(path, folder); });
}

}  // namespace slalom
