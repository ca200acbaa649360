// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "names.h"
#include "report_data.h"

namespace slalom {

/// The value of a run: a number, or an array with the index of its reason.
OrderedJson value_json(const ValueColumn& metric, std::size_t run, Names& reasons);

/// "values", "reasons" and "bins" of report.json: every metric of every run, and the quartiles of
/// all quantities, for the pages in which the reader chooses.
OrderedJson value_data(const ResultTable& runs);

}  // namespace slalom
