// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace slalom {

/// The file of the running program, and its folder; empty if unknown.
std::string program_path();
std::string program_folder();

/// The path of a file or folder below share/slalom that comes with the program, built or installed.
std::string shipped_file(const std::string& name);

}  // namespace slalom
