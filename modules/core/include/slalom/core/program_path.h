// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace slalom {

/// The file of the running program, and its folder; empty if unknown.
std::string program_path();
std::string program_folder();

}  // namespace slalom
