// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/run_record.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The value of a key "SECTION.KEY" of the campaign's .ini in the manifest; none if the campaign
/// uses the default.
std::optional<std::string> campaign_setting(const Manifest& manifest, const std::string& key);

/// Differences of two campaigns that may affect runs: keys of their .ini ("sensor.noise_sigma: 0,
/// 0.1"), scenarios, versions and hashes of methods. Seed, names, [analysis] and [record] are
/// ignored, as are the keys in `expected`.
std::vector<std::string> campaign_differences(const Manifest& a, const Manifest& b,
                                              const std::vector<std::string>& expected);

}  // namespace slalom
