// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/references/reference.h>

#include <string>

namespace slalom {

/// References as bytes, for files and between processes, without their timing; doubles are exact.
/// Reading validates all data and throws Error (File) at `where`.
std::string to_bytes(const References& references);
References references_from_bytes(const std::string& bytes, const std::string& where);

}  // namespace slalom
