#pragma once

#include <slalom/studio/actions.h>
#include <slalom/studio/studio.h>

namespace slalom {

// The actions of the studio, menu by menu in order, for menus, keyboard shortcuts, the help and
// scripts. The window adds those that concern only itself.

void add_file_actions(Actions& actions, Studio& studio);
void add_edit_actions(Actions& actions, Studio& studio);
void add_list_actions(Actions& actions, Studio& studio);
void add_generate_actions(Actions& actions, Studio& studio);
/// `actions` must outlive the studio's notices.
void add_help_actions(Actions& actions, Studio& studio);

/// Import and export, of the menu File.
void add_import_export_actions(Actions& actions, Studio& studio);
/// Opens lists and results, and the import form for other files.
void open_files(Studio& studio, std::vector<std::string> files);

}  // namespace slalom
