// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "widgets/element.h"

#include <slalom/studio/jobs.h>
#include <slalom/studio/script.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// Services of the window that a script uses.
struct ScriptHost {
  nanogui::Screen* screen = nullptr;
  /// Draws a frame, which may remain unseen. Returns false when the window was closed.
  std::function<bool(bool seen)> draw_frame;
  const Jobs* jobs = nullptr;
  std::function<void(const std::string& id)> run_action;    ///< throws Error if disabled or unknown
  std::function<void(const std::string& path)> screenshot;  ///< throws Error (Job)
};

/// The visible element (or other widget) with this id; null if there is none. If there are several,
/// the one drawn last.
nanogui::Widget* find_visible_widget(nanogui::Widget& root, const std::string& id);

/// The text of a widget and its children, as lines.
std::string shown_text(const nanogui::Widget& widget);

/// Plays a script by sending mouse and keyboard events to the window, until the script ends or the
/// window is closed. Executes one command per frame, so that the window is drawn in between; a
/// frame that the next command replaces at once remains unseen. Throws Error (Job) with the line of
/// the script when an element is missing, an expectation fails or a job does not end in time.
void play_script(const std::vector<ScriptCommand>& script, const std::string& name,
                 const ScriptHost& host);

}  // namespace slalom
