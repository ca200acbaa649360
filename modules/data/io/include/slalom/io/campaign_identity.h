// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/run_record.h>

#include <map>
#include <string>
#include <vector>

namespace slalom {

/// Manifest keys of the identity of a campaign.
constexpr const char* kIdentityKey = "campaign.identity";    ///< campaign_identity()
constexpr const char* kEffectiveKey = "campaign.effective";  ///< .ini with all values that matter
/// Prefix of keys of replaced files of methods, for their earlier hashes; see open_results().
constexpr const char* kKeptPrefix = "kept.";

/// Everything in a manifest that may change a result, by key: "robot.max_v",
/// "method.nd.plugin_hash", "version.mrpt", "scenarios.hash", "until". Other keys of a manifest,
/// such as the number of a shard, are not part of it.
std::map<std::string, std::string> identity_parts(const Manifest& manifest);

/// A hash of identity_parts(): results of campaigns with the same identity may be mixed.
std::string campaign_identity(const Manifest& manifest);

/// A part of the identity that two campaigns do not share.
struct IdentityDifference {
  std::string key, here, there;  ///< texts as of identity_parts(); "absent"
};

/// Differences between the identities of two campaigns, settings first; empty if they are the same
/// campaign.
std::vector<IdentityDifference> identity_differences(const Manifest& here, const Manifest& there);

/// "robot.max_v is 0.5 here and 0.6 in FILE"; `file` names the second campaign.
std::string to_string(const IdentityDifference& difference, const std::string& file);

/// The differences as a part of a sentence, those after the third counted only.
std::string enumerate(const std::vector<IdentityDifference>& differences, const std::string& file);

/// Whether the key is about the content of a file that a method executes, loads or reads.
bool is_method_file(const std::string& key);

/// Throws Error (File) with the first differences unless both are the same campaign. `remedy` is
/// what the message expects instead.
void expect_same_campaign(const Manifest& here, const Manifest& there, const std::string& file,
                          const std::string& remedy);

/// Whether runs of several versions of the method are in the file of this manifest.
bool mixes_versions(const Manifest& manifest, const std::string& method);

/// Adds what `from` says about runs that were executed a second time, except of methods that `to`
/// mixes: their files were replaced since.
void add_repeated_runs(const Manifest& from, Manifest& to);

/// One line for each replacement of a file of a method, after which finished runs were kept.
std::vector<std::string> kept_run_notes(const Manifest& manifest);

}  // namespace slalom
