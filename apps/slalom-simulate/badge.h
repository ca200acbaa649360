// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/verify_results.h>

#include <string>

namespace slalom {

/// Writes what a verification found beside the result: FILE.verified.json, which badge services
/// read ("label", "message", "color") and which states what was run again, when and where, and
/// FILE.verified.svg, the badge.
void write_badge(const std::string& results, const VerifySample& sample,
                 const VerifyReport& report);

}  // namespace slalom
