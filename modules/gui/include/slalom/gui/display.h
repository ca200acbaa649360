#pragma once

#include <functional>
#include <nanogui/nanogui.h>
#include <string>

namespace slalom {

/// Runs `show`, which opens windows and ends when they are closed. Where none can be opened (no
/// display, no OpenGL 3.3) throws Error (Job) naming `program` and what to do `without`, e.g.
/// "xvfb-run -a PROGRAM". An Error of `show` stays as it is.
void with_display(const std::string& program, const std::string& without,
                  const std::function<void()>& show);

/// Draws the window and writes what is seen as PNG. Throws Error (Job).
void save_window_picture(nanogui::Screen& screen, const std::string& path);

}  // namespace slalom
