// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/result_table.h>
#include <slalom/results/run_record.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The value of a key "SECTION.KEY" of the campaign's .ini in the manifest; none if the campaign
/// uses the default.
std::optional<std::string> campaign_setting(const Manifest& manifest, const std::string& key);

/// Differences of two campaigns that may affect runs: keys of their .ini ("sensor.noise_sigma: 0,
/// 0.1"), scenarios, versions and hashes of methods. Seed, names, [analysis], [record]
/// and methods that only one of them has are ignored, as are the keys in `expected`.
std::vector<std::string> campaign_differences(const Manifest& a, const Manifest& b,
                                              const std::vector<std::string>& expected);

/// Differences of them that change what is asked of every method, or how it is measured: the robot,
/// its sensors, the simulation, people, limits, references and metrics. Not the options of methods
/// and the scenarios, which comparisons are about, and pair.
std::vector<std::string> task_differences(const Manifest& a, const Manifest& b);

/// Sentences of campaign_differences() between successive results, "the campaigns differ:
/// sensor.max_range: (default), 4".
std::vector<std::string> difference_sentences(const std::vector<ResultTable>& results);

}  // namespace slalom
