// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/result_table.h>

#include <string>
#include <vector>

namespace slalom {

/// Statements on the reliability that a table of trials shows, of one method or (empty) of each:
/// "a: 20 of 20 runs without collision: at least 0.86 with 95 % confidence, if they are
/// independent; 39 more without collision would show 0.95". Bounds are exact (Clopper and Pearson
/// 1934, one-sided). With columns of distance (m) and time (s) of all runs also collisions per km
/// and per hour, with the exact interval of Poisson events (Garwood 1936, Biometrika 28:437).
/// Collisions count where the kind of each end is known. Empty unless the table is_foreign().
std::vector<std::string> acceptance_sentences(const ResultTable& table, const std::string& method,
                                              double confidence);

}  // namespace slalom
