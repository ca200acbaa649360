// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "widgets/element.h"

#include <slalom/studio/form.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// A form, id "dialog". Calls `close` once, after the form was accepted or canceled; it is not used
/// afterwards.
Element* make_form_panel(nanogui::Widget* parent, FormDescription description,
                         std::function<void()> close);

/// Shows a modal form in the center of the screen, with the focus on its first field. The form
/// closes itself.
void open_form(nanogui::Screen& screen, FormDescription description);

/// Puts the files, which were dropped on the screen, into the browsed field of the form on top.
void drop_into_form(nanogui::Screen& screen, const std::vector<std::string>& files);

}  // namespace slalom
