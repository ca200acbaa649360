// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaderboard.h"

namespace slalom {

/// `page` (pages/index.html) with the name of the campaign, its numbers of methods, scenarios and
/// runs, the first screen, `headlines`, and, for browsers without scripts, the summary and the
/// cross tables as plain tables.
std::string index_page(const std::string& page, const ReportInput& input,
                       const Leaderboard& leaderboard, const std::vector<std::string>& headlines);

}  // namespace slalom
