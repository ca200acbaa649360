#pragma once

#include <slalom/results/run_record.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// A key of the campaign's .ini as the manifest keeps it, "SECTION.KEY"; none where the campaign
/// left it at its default.
std::optional<std::string> campaign_setting(const Manifest& manifest, const std::string& key);

/// Where two campaigns differ in what may change a run: keys of their .ini ("sensor.noise_sigma: 0
/// in A, 0.1 in B"), seed, scenarios, versions and hashes of methods. Names, tables and records do
/// not count, nor do keys in `expected`.
std::vector<std::string> campaign_differences(const Manifest& a, const Manifest& b,
                                              const std::vector<std::string>& expected);

}  // namespace slalom
