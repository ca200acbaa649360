// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace slalom {

/// The function `symbol` of a part of Slalom that depends on large libraries. The part is a shared
/// library, runtime/libslalom_NAME.so in shipped_folder(), built by slalom_add_part() of CMake; it
/// is loaded when it is first needed, and stays. Throws Error (Usage) at `where` if it was not
/// built
/// (-DSLALOM_WITH_NAME=ON), or from other headers than this program: types of C++ cross this
/// border.
void* find_in_part(const std::string& name, const char* symbol, const std::string& where);

}  // namespace slalom
