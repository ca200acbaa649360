// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/question.h>

#include <string>

namespace slalom {

/// Claimed ranges of an answer of limit, and success beyond them with 95 % intervals.
StatementFigure curve_figure(const std::string& parameter, const Json& answer);

/// Success of the default and of the tuned options in the scenarios of the claim of an answer of
/// tune, and in its hard end, with intervals.
StatementFigure tune_figure(const Json& sealed);

/// The cells of an answer of envelope.
StatementFigure envelope_figure(const std::string& columns, const std::string& rows,
                                const Json& answer);

}  // namespace slalom
