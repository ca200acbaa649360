// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace slalom {

/// Creates the folder with its parents and checks that it is writable. Throws Error (Job).
void make_output_folder(const std::string& path);

}  // namespace slalom
