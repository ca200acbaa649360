// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/scenario.h>
#include <slalom/slalom.h>

#include <vector>

struct slalom_scenarios {
  std::vector<slalom::Scenario> scenarios;
};
