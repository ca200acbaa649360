// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/campaign_options.h>
#include <slalom/io/result_file.h>

#include <string>
#include <vector>

namespace slalom {

/// Treatment of a result file that exists.
enum class ExistingResults {
  Continue,      ///< if there is one
  Require,       ///< it must exist and is continued
  KeepFinished,  ///< it is continued, even if files of methods were replaced since
  Overwrite
};

/// The result file of a campaign with this manifest and these scenarios: the existing one, or a new
/// one. A file whose campaign the given one only extends, by scenarios, methods or repetitions, is
/// continued with the new manifest: its runs are then part of the larger campaign. Where
/// replaced files of methods are accepted, the manifest says so, see kept_run_notes(). Throws Error
/// (File) for a file of another campaign, naming what differs, for any other file, and if it is
/// required and missing; Error (Job) when it cannot be written.
ResultFile open_results(const std::string& path, Manifest manifest,
                        const std::vector<Scenario>& scenarios, const CampaignOptions& options,
                        ExistingResults existing);

}  // namespace slalom
