// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace slalom {

/// Writes a figure as .svg, or as .pdf by the program rsvg-convert (package librsvg2-bin). Throws
/// Error (Usage) for another ending, Error (Job) when the file cannot be written or the program is
/// missing or fails.
void write_figure(const std::string& svg, const std::string& path);

}  // namespace slalom
