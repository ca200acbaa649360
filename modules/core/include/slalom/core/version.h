// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace slalom {

std::string version();                    ///< of Slalom, e.g. "0.1.0"
std::string compiler_version();           ///< e.g. "g++ 12.2.0"
std::string mrpt_version();               ///< of the MRPT headers at build time
std::string mrpt_version(unsigned code);  ///< from the code MRPT_VERSION of MRPT's version.h
std::string processor_name();             ///< "unknown" if the system does not tell

}  // namespace slalom
