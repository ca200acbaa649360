#pragma once

#include <functional>
#include <nanogui/nanogui.h>
#include <string>

namespace slalom {

/// Runs `show`, which opens windows and returns when they are closed. When no window can be opened
/// (no display, no OpenGL 3.3), throws Error (Job) naming `program` and the `alternative`, e.g.
/// "xvfb-run -a PROGRAM". Errors thrown by `show` are passed on.
void with_display(const std::string& program, const std::string& alternative,
                  const std::function<void()>& show);

/// Draws the window and writes its content as PNG. Throws Error (Job).
void save_window_picture(nanogui::Screen& screen, const std::string& path);

}  // namespace slalom
