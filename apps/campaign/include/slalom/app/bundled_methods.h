// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/campaign_program.h>
#include <slalom/io/bundle.h>

#include <string>

namespace slalom {

/// Writes a bundle of the results of the whole campaign `config`, see write_bundle(); with
/// `with_sources` it contains the files that its methods consist of, without those shipped with
/// Slalom. Throws Error: Usage unless the results are complete, Job if such a file has changed
/// since the runs were executed. Returns a line about it: "out.slalom: 2001 runs, 1.3 MB".
std::string write_campaign_bundle(const std::string& results, const std::string& path,
                                  const CampaignConfig& config, bool with_sources);

/// Writes the campaign's .ini of a bundle, and the files of methods that it contains, into a
/// folder. The options of that .ini name these files. Returns its path. Executes nothing. Throws
/// Error.
std::string unpack_methods(const std::string& bundle, const std::string& folder);

}  // namespace slalom
