// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace slalom {

/// "a b" -> "a%20b", for a part of an address; slashes remain.
std::string address_text(const std::string& text);

}  // namespace slalom
