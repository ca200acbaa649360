// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/evaluate.h>
#include <slalom/slalom.h>

#include <nlohmann/json.hpp>

namespace slalom {

/// The methods of slalom_evaluate(), with those of the calling program. Throws Error (Usage).
Methods read_methods(const nlohmann::json& methods, const slalom_own_methods* own);

/// A method of the calling program with other options. Throws Error (Usage).
MethodFactory own_method(const slalom_own_methods& own, std::uint64_t type, const std::string& name,
                         const nlohmann::json& options);

}  // namespace slalom
