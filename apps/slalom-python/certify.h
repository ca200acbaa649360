// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

namespace slalom {

/// Adds certify().
void bind_certify(pybind11::module_& module);

}  // namespace slalom
