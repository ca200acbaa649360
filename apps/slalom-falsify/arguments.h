// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/campaign_program.h>
#include <slalom/falsification/fairness.h>

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace slalom {

/// Arguments of both verbs.
struct FalsifyArguments {
  CampaignArguments campaign;
  std::string method;
  std::vector<std::string> witnesses;  ///< empty: the other methods of the campaign
  std::string surrogate;               ///< a light method that fails in similar scenarios; or none
  std::string output;
  FairnessOptions fairness;
  std::size_t max_runs = 5000;  ///< to shrink one failure
};

/// Adds --witness, -o, the conditions of fairness, --max-runs, --set and --quiet.
void add_falsify_options(CLI::App& app, FalsifyArguments& arguments);

/// Only witnesses that are named must reach the goal also in the method's own failures.
void excuse_unnamed_witnesses(FalsifyArguments& arguments);

/// A campaign's .ini whose methods are the one that is tested and its witnesses.
struct FalsifyCampaign {
  IniFile ini;
  CampaignConfig config;
  FalsificationSetup setup;
  CampaignConfig surrogate = {};  ///< with the surrogate as its only method, if there is one
};

/// Throws Error (Usage) for a method without section and without an adapter that can build it.
FalsifyCampaign read_falsify_campaign(IniFile ini, const FalsifyArguments& arguments);

}  // namespace slalom
