// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace slalom {

/// s, the time from the beginning of a run that descriptors of movers look at; as in the code of
/// Shi et al. 2024.
constexpr double kMoverHorizon = 12;

constexpr const char* kNoMovers = "no moving obstacles";

}  // namespace slalom
