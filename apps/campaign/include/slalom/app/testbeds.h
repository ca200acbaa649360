// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace slalom {

/// The name of the test bed in configs/testbeds/ whose scenarios have this content_hash(); "" for
/// other scenarios.
std::string testbed_of(const std::string& content_hash);

}  // namespace slalom
