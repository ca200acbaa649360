// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/campaign_program.h>

#include <CLI/CLI.hpp>

namespace slalom {

/// Adds the options of all programs that run campaigns: -j/--jobs, --seed, --set, --resume,
/// --overwrite, --take-over, --keep-finished, --quiet.
void add_campaign_options(CLI::App& app, CampaignArguments& arguments);

}  // namespace slalom
