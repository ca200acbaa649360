#pragma once

#include <slalom/gui/studio_window.h>

namespace slalom {

// All that a user can do, menu by menu in their order: what menus, keys, the help and scripts
// offer. Other files may add to the same menus in between.

void add_file_actions(StudioWindow& window);
void add_quit_action(StudioWindow& window);
void add_edit_actions(StudioWindow& window);
void add_list_actions(StudioWindow& window);
void add_view_actions(StudioWindow& window);  ///< with the menus Layers and Tools
void add_help_actions(StudioWindow& window);

}  // namespace slalom
