// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "unsafe_departures.h"

#include <slalom/references/earliest_arrival.h>

namespace slalom::arrival {

/// A lower bound (s) of every arrival in the goal region among the movers that is before `limit`,
/// by the search over squares (earliest_arrival.h); at least `known`, a lower bound itself. `limit`
/// if there is no arrival before it.
double moving_bound(const PlanningProblem& problem, const ArrivalLimits& limits, double known,
                    double limit);

}  // namespace slalom::arrival
