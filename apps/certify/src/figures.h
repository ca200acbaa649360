// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/question.h>

#include <string>

namespace slalom {

/// Claimed ranges of an answer of limit, and success beyond them with 95 % intervals.
StatementFigure curve_figure(const std::string& parameter, const Json& answer);

/// The cells of an answer of envelope.
StatementFigure envelope_figure(const std::string& columns, const std::string& rows,
                                const Json& answer);

}  // namespace slalom
