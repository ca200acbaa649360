// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/quick_sample.h>

#include <string>

namespace slalom {

/// Success of each method over all scenarios, as text: estimated from the results of the sample.
std::string quick_answer(const QuickSample& sample, const std::string& results_path,
                         double confidence);

}  // namespace slalom
