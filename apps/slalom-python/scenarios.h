// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

namespace slalom {

/// Class Scenario, read_scenarios(), write_scenarios() and generate().
void bind_scenarios(pybind11::module_& module);

}  // namespace slalom
