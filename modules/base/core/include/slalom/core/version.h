// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/error.h>

#include <string>

namespace slalom {

std::string version();                    ///< of Slalom, e.g. "0.1.0"
std::string compiler_version();           ///< e.g. "g++ 12.2.0"
std::string mrpt_version();               ///< of the MRPT headers at build time
std::string mrpt_version(unsigned code);  ///< from the code MRPT_VERSION of MRPT's version.h
std::string processor_name();             ///< "unknown" if the system does not tell

/// The error where an optional part is used that was not built: `part` is the option of CMake, as
/// SLALOM_WITH_GUI.
Error not_built(const std::string& where, const std::string& part);

}  // namespace slalom
