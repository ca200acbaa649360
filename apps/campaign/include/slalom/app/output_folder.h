#pragma once

#include <string>

namespace slalom {

/// Makes the folder with its parents and checks that files can be made in it. Throws Error (Job).
void make_output_folder(const std::string& path);

}  // namespace slalom
