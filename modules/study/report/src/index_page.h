// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report_data.h"

namespace slalom {

/// `page` (pages/index.html) with the name of the campaign, its numbers of methods, scenarios and
/// runs, and, for browsers without scripts, the summary and the cross tables as plain tables.
std::string index_page(const std::string& page, const ReportInput& input);

}  // namespace slalom
