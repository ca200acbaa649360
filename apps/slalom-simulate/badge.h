// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/verify_results.h>

#include <string>

namespace slalom {

/// Writes what a verification found beside the result: FILE.verified.json, which badge services
/// read ("label", "message", "color") and which states what was run again, when and where, and
/// FILE.verified.svg, the badge. With a folder: FOLDER/HASH_VERSION.json and .svg, by the hash of
/// the file and the version of Slalom, as slalom-analyze registry reads them.
void write_badge(const std::string& results, const std::string& folder, const VerifySample& sample,
                 const VerifyReport& report);

/// Whether the folder has the verification of a file by this version.
bool has_badge(const std::string& results, const std::string& folder);

}  // namespace slalom
