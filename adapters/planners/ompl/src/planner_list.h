// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace slalom {

/// The planners of OMPL that find shortest paths; sorted. make_ompl_planner() knows each of them.
inline constexpr std::array kOmplPlanners = {"ABITstar",        "AITstar", "BITstar", "FMT",
                                             "InformedRRTstar", "PRMstar", "RRTstar"};

}  // namespace slalom
