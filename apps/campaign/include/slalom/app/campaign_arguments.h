#pragma once

#include <slalom/app/campaign_program.h>

#include <CLI/CLI.hpp>

namespace slalom {

/// Adds the options that every program with a campaign has: -j/--jobs, --seed, --set, --quiet.
void add_campaign_options(CLI::App& app, CampaignArguments& arguments);

}  // namespace slalom
