#include "forms/list_dialogs.h"

#include <slalom/core/version.h>
#include <slalom/studio/studio_actions.h>

namespace slalom {
namespace {

using DisabledCheck = std::function<std::string()>;
using Form = FormDescription (*)(Studio&);

/// The disabled check of an action on the active list.
DisabledCheck list_disabled_check(Studio& studio, ListAction action) {
  return [&studio, action]() -> std::string {
    const ListDocument* document = studio.active();
    return document == nullptr ? "no list is open" : document->disabled_reason(action);
  };
}

DisabledCheck needs_list(Studio& studio) {
  return [&studio]() -> std::string { return studio.active() == nullptr ? "no list is open" : ""; };
}

DisabledCheck needs_another_list(Studio& studio, ListAction action) {
  return [&studio, action, check = list_disabled_check(studio, action)]() -> std::string {
    if (!check().empty()) return check();
    return studio.documents().size() < 2 ? "no other list is open" : "";
  };
}

std::function<void()> opens(Studio& studio, Form form) {
  return [&studio, form] { studio.notices().show_form(form(studio)); };
}

/// For example "Undo: delete 3 scenarios".
std::string with_title(const std::string& word, const std::string& title) {
  return title.empty() ? word : word + ": " + title;
}

std::string key_lines(const Actions& actions) {
  std::string text;
  for (const Action& action : actions.all())
    if (!action.shortcut.empty()) text += action.shortcut + "  " + action.title + "\n";
  return text;
}

}  // namespace

void add_file_actions(Actions& actions, Studio& studio) {
  actions.add({"file.new", "File", "New list...", "Ctrl+N", "Creates an empty list.",
               opens(studio, new_list_form)});
  actions.add({"file.open", "File", "Open list...", "Ctrl+O", "Opens a list in a new tab.",
               opens(studio, open_list_form)});
  actions.add({"file.save_as", "File", "Save list as...", "Ctrl+Shift+S",
               "Copies the list to another file. Changes are always saved at once.",
               opens(studio, save_as_form), list_disabled_check(studio, ListAction::SaveAs)});
  actions.add({"file.close", "File", "Close list", "Ctrl+W",
               "Closes the active list. All changes are saved.",
               [&studio] { studio.close_list(studio.active_index()); }, needs_list(studio)});
  actions.add({"file.open_results", "File", "Open results...", "Ctrl+R",
               "Shows the runs of a campaign on top of the scenarios.",
               opens(studio, open_results_form)});
  actions.add({"file.close_results", "File", "Close results", "", "Hides the runs.",
               [&studio] { studio.results().close(); },
               [&studio]() -> std::string {
                 return studio.results().overlay().is_open() ? "" : "no results are open";
               }});
}

void add_edit_actions(Actions& actions, Studio& studio) {
  actions.add({"edit.undo", "Edit", "Undo", "Ctrl+Z", "Undoes the last change of this list.",
               [&studio] { studio.undo(); }, list_disabled_check(studio, ListAction::Undo),
               [&studio] {
                 ListDocument* list = studio.active();
                 return with_title("Undo", list ? list->history().undo_title() : "");
               }});
  actions.add({"edit.redo", "Edit", "Redo", "Ctrl+Y", "Repeats the last undone change.",
               [&studio] { studio.redo(); }, list_disabled_check(studio, ListAction::Redo),
               [&studio] {
                 ListDocument* list = studio.active();
                 return with_title("Redo", list ? list->history().redo_title() : "");
               }});
  actions.add({"edit.select_all", "Edit", "Select all", "", "Selects all visible scenarios.",
               [&studio] { studio.active()->select_all(); }, needs_list(studio)});
  actions.add({"edit.select_none", "Edit", "Clear selection", "Ctrl+D", "Clears the selection.",
               [&studio] { studio.active()->select_none(); }, needs_list(studio)});
  actions.add({"edit.copy", "Edit", "Copy to another list...", "Ctrl+Shift+C",
               "Copies the selected scenarios with tags and values.", opens(studio, copy_form),
               needs_another_list(studio, ListAction::CopyTo)});
  actions.add({"edit.move", "Edit", "Move to another list...", "Ctrl+Shift+X",
               "Moves the selected scenarios.", opens(studio, move_form),
               needs_another_list(studio, ListAction::MoveTo)});
  actions.add({"edit.delete", "Edit", "Delete", "Delete", "Removes the selected scenarios.",
               [&studio] { studio.active()->remove_selected(); },
               list_disabled_check(studio, ListAction::Remove)});
  actions.add({"edit.rename", "Edit", "Rename...", "F2", "Renames the current scenario.",
               opens(studio, rename_form), list_disabled_check(studio, ListAction::Rename)});
  actions.add({"edit.tag", "Edit", "Tags...", "Ctrl+T",
               "Adds or removes tags of the selected scenarios.", opens(studio, tag_form),
               list_disabled_check(studio, ListAction::Tag)});
}

void add_list_actions(Actions& actions, Studio& studio) {
  actions.add({"list.create_index", "List", "Create index...", "Ctrl+I",
               "Divides the values of a descriptor into ranges.", opens(studio, create_index_form),
               list_disabled_check(studio, ListAction::CreateIndex)});
  actions.add({"list.drop_index", "List", "Drop index...", "",
               "Removes an index, not its scenarios.", opens(studio, drop_index_form),
               list_disabled_check(studio, ListAction::DropIndex)});
  actions.add({"list.deduplicate", "List", "Remove near-duplicates...", "",
               "Keeps only one of scenarios that hardly differ in a descriptor.",
               opens(studio, deduplicate_form),
               list_disabled_check(studio, ListAction::Deduplicate)});
  actions.add({"list.describe", "List", "Compute all descriptors", "F5",
               "Computes the missing values of all scenarios and stores them in the list.",
               [&studio] { studio.describe_list(); }, needs_list(studio)});
}

void add_help_actions(Actions& actions, Studio& studio) {
  actions.add({"help.keys", "Help", "Keys", "F1", "Lists the keyboard shortcuts.",
               [&studio, &actions] { studio.notices().show_message("Keys", key_lines(actions)); }});
  actions.add({"help.about", "Help", "About", "", "Shows the version.", [&studio] {
                 studio.notices().show_message("Slalom Studio",
                                               "Version " + version() + ", MRPT " + mrpt_version());
               }});
}

}  // namespace slalom
