// SPDX-License-Identifier: BSD-3-Clause
// Written by scripts/difficulty.py.
#pragma once

namespace slalom::descriptors {

/// Model of the Rasch difficulty of the scenarios in slalom-standard (logit).
constexpr double kEasiest = -5.281;
constexpr double kNarrow = 4.389;
constexpr double kDetour = 5.467;
constexpr double kHalfNarrow = 0.1;
constexpr double kHalfDetour = 0.05;

}  // namespace slalom::descriptors
