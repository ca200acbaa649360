#pragma once

#include <slalom/results/run_record.h>

#include <map>
#include <string>
#include <vector>

namespace slalom {

/// Manifest keys of the identity of a campaign.
constexpr const char* kIdentityKey = "campaign.identity";    ///< campaign_identity()
constexpr const char* kEffectiveKey = "campaign.effective";  ///< .ini with all values that matter

/// Everything in a manifest that may change a result, by key: "robot.max_v",
/// "method.nd.plugin_hash", "version.mrpt", "scenarios.hash", "until". Other keys of a manifest,
/// such as the number of a shard, are not part of it.
std::map<std::string, std::string> identity_parts(const Manifest& manifest);

/// A hash of identity_parts(): results of campaigns with the same identity may be mixed.
std::string campaign_identity(const Manifest& manifest);

/// What differs between the identities of two campaigns, as "robot.max_v is 0.5 here and 0.6 in
/// FILE", settings first; empty if they are the same campaign. `file` names the second one.
std::vector<std::string> identity_differences(const Manifest& here, const Manifest& there,
                                              const std::string& file);

/// Throws Error (File) with the first differences unless both are the same campaign. `remedy` is
/// what the message expects instead.
void expect_same_campaign(const Manifest& here, const Manifest& there, const std::string& file,
                          const std::string& remedy);

}  // namespace slalom
