#include <slalom/core/version.h>
#include <slalom/gui/form_dialog.h>
#include <slalom/gui/list_dialogs.h>
#include <slalom/gui/list_panel.h>
#include <slalom/gui/scenario_view.h>
#include <slalom/gui/studio_actions.h>

namespace slalom {
namespace {

using Obstacle = std::function<std::string()>;
using Form = FormDescription (*)(Studio&);

/// Why an action on the list that is before the others cannot be done.
Obstacle obstacle_to(StudioWindow& window, ListAction action) {
  return [&window, action]() -> std::string {
    const ListDocument* document = window.studio().active();
    return document == nullptr ? "no list is open" : document->obstacle(action);
  };
}

Obstacle needs_list(StudioWindow& window) {
  return [&window]() -> std::string {
    return window.studio().active() == nullptr ? "no list is open" : "";
  };
}

Obstacle needs_another_list(StudioWindow& window, ListAction action) {
  return [&window, action, other = obstacle_to(window, action)]() -> std::string {
    if (!other().empty()) return other();
    return window.studio().documents().size() < 2 ? "no other list is open" : "";
  };
}

std::function<void()> asking(StudioWindow& window, Form form) {
  return [&window, form] { open_form(window, form(window.studio())); };
}

/// "Undo: delete 3 scenarios"
std::string with_title(const std::string& word, const std::string& title) {
  return title.empty() ? word : word + ": " + title;
}

void add_undo_actions(StudioWindow& window) {
  Studio& studio = window.studio();
  window.actions().add(
      {"edit.undo", "Edit", "Undo", "Ctrl+Z", "Takes the last change of this list back.",
       [&studio] { studio.active()->undo(); }, obstacle_to(window, ListAction::Undo),
       [&studio] {
         ListDocument* list = studio.active();
         return with_title("Undo", list ? list->history().undo_title() : "");
       }});
  window.actions().add({"edit.redo", "Edit", "Redo", "Ctrl+Y", "Does again what was taken back.",
                        [&studio] { studio.active()->redo(); },
                        obstacle_to(window, ListAction::Redo),
                        [&studio] {
                          ListDocument* list = studio.active();
                          return with_title("Redo", list ? list->history().redo_title() : "");
                        }});
}

void add_layer_action(StudioWindow& window, const SceneLayer& layer) {
  ScenarioView& view = window.view();
  const std::string id = layer.id();
  window.actions().add({"layer." + id,
                        "Layers",
                        layer.title(),
                        "",
                        "Draws it, or leaves it out.",
                        [&view, id] { view.set_layer(id, !view.layer_on(id)); },
                        {},
                        {},
                        [&view, id] { return view.layer_on(id); }});
}

void add_tool_action(StudioWindow& window, const EditToolInfo& info) {
  ScenarioView& view = window.view();
  window.actions().add({"tool." + info.id,
                        "Tools",
                        info.title,
                        "",
                        info.help,
                        [&view, tool = info.tool] { view.set_tool(tool); },
                        [&view, tool = info.tool]() -> std::string {
                          if (!view.scene()) return "no scenario is shown";
                          return slalom::obstacle_to(tool,
                                                     view.scene()->scenario().representation());
                        },
                        {},
                        [&view, tool = info.tool] { return view.tool() == tool; }});
}

std::string key_lines(const Actions& actions) {
  std::string text;
  for (const Action& action : actions.all())
    if (!action.shortcut.empty()) text += action.shortcut + "  " + action.title + "\n";
  return text;
}

}  // namespace

void add_file_actions(StudioWindow& window) {
  Studio& studio = window.studio();
  Actions& actions = window.actions();
  actions.add({"file.new", "File", "New list...", "Ctrl+N", "A new, empty list.",
               asking(window, new_list_form)});
  actions.add({"file.open", "File", "Open list...", "Ctrl+O",
               "Opens a list beside those that are open.", asking(window, open_list_form)});
  actions.add({"file.save_as", "File", "Save list as...", "Ctrl+Shift+S",
               "Copies the list to another file. Changes are saved at once as they are made.",
               asking(window, save_as_form), obstacle_to(window, ListAction::SaveAs)});
  actions.add({"file.close", "File", "Close list", "Ctrl+W", "Everything is saved already.",
               [&studio] { studio.close_list(studio.active_index()); }, needs_list(window)});
  actions.add({"file.open_results", "File", "Open results...", "Ctrl+R",
               "Lays the runs of a campaign over the scenarios.",
               asking(window, open_results_form)});
  actions.add(
      {"file.close_results", "File", "Close results", "", "Takes them off again.",
       [&studio] { studio.results().close(); },
       [&window]() -> std::string { return window.results_shown() ? "" : "no results are open"; }});
}

void add_quit_action(StudioWindow& window) {
  window.actions().add({"file.quit", "File", "Quit", "Ctrl+Q", "Everything is saved already.",
                        [&window] { window.setVisible(false); }});
}

void add_edit_actions(StudioWindow& window) {
  Studio& studio = window.studio();
  Actions& actions = window.actions();
  add_undo_actions(window);
  actions.add({"edit.select_all", "Edit", "Select all", "", "All that the list shows.",
               [&studio] { studio.active()->select_all(); }, needs_list(window)});
  actions.add({"edit.select_none", "Edit", "Select none", "Ctrl+D", "Takes all marks off.",
               [&studio] { studio.active()->select_none(); }, needs_list(window)});
  actions.add({"edit.copy", "Edit", "Copy to another list...", "Ctrl+Shift+C",
               "Copies the selected scenarios with tags and values.", asking(window, copy_form),
               needs_another_list(window, ListAction::CopyTo)});
  actions.add({"edit.move", "Edit", "Move to another list...", "Ctrl+Shift+X",
               "Moves the selected scenarios.", asking(window, move_form),
               needs_another_list(window, ListAction::MoveTo)});
  actions.add({"edit.delete", "Edit", "Delete", "Delete", "Removes the selected scenarios.",
               [&studio] { studio.active()->remove_selected(); },
               obstacle_to(window, ListAction::Remove)});
  actions.add({"edit.rename", "Edit", "Rename...", "F2", "Another name for the current scenario.",
               asking(window, rename_form), obstacle_to(window, ListAction::Rename)});
  actions.add({"edit.tag", "Edit", "Tags...", "Ctrl+T",
               "Adds tags to the selected scenarios, or takes them off.", asking(window, tag_form),
               obstacle_to(window, ListAction::Tag)});
}

void add_list_actions(StudioWindow& window) {
  Studio& studio = window.studio();
  Actions& actions = window.actions();
  actions.add({"list.sort", "List", "Sort...", "", "By any descriptor.",
               [&window] { window.list().choose_sort(); }, needs_list(window)});
  actions.add({"list.group", "List", "Group...", "", "By the ranges of an index.",
               [&window] { window.list().choose_group(); }, needs_list(window)});
  actions.add({"list.create_index", "List", "Create index...", "Ctrl+I",
               "Cuts the values of a descriptor into ranges.", asking(window, create_index_form),
               obstacle_to(window, ListAction::CreateIndex)});
  actions.add({"list.drop_index", "List", "Drop index...", "", "The scenarios stay.",
               asking(window, drop_index_form), obstacle_to(window, ListAction::DropIndex)});
  actions.add({"list.deduplicate", "List", "Remove what is alike...", "",
               "Leaves one of scenarios that hardly differ in a descriptor.",
               asking(window, deduplicate_form), obstacle_to(window, ListAction::Deduplicate)});
  actions.add({"list.describe", "List", "Compute all descriptors", "F5",
               "Of all scenarios of the list that lack them; kept in its file.",
               [&studio] { studio.describe_list(); }, needs_list(window)});
}

void add_view_actions(StudioWindow& window) {
  ScenarioView& view = window.view();
  Actions& actions = window.actions();
  actions.add(
      {"view.fit", "View", "Show all", "Ctrl+0", "The whole scenario.", [&view] { view.fit(); }});
  actions.add({"view.zoom_in", "View", "Zoom in", "Ctrl+Plus", "About the middle of the view.",
               [&view] { view.zoom(1.25); }});
  actions.add({"view.zoom_out", "View", "Zoom out", "Ctrl+Minus", "About the middle of the view.",
               [&view] { view.zoom(0.8); }});
  actions.add({"view.legend",
               "View",
               "Legend",
               "",
               "The list of layers in the view.",
               [&view] { view.set_legend_open(!view.legend_open()); },
               {},
               {},
               [&view] { return view.legend_open(); }});
  actions.add({"view.next_panel", "View", "Next panel", "F6",
               "Gives the keyboard to the list, the descriptors, the scenario, the results.",
               [&window] { window.next_panel(); }});
  for (const auto& layer : view.layers()) add_layer_action(window, *layer);
  for (const EditToolInfo& info : edit_tools()) add_tool_action(window, info);
}

void add_help_actions(StudioWindow& window) {
  Actions& actions = window.actions();
  actions.add({"help.keys", "Help", "Keys", "F1", "What keys and the mouse do.",
               [&window] { window.show_message("Keys", key_lines(window.actions())); }});
  actions.add({"help.about", "Help", "About", "", "Which version this is.", [&window] {
                 window.show_message("Slalom Studio",
                                     "Version " + version() + ", MRPT " + mrpt_version());
               }});
}

}  // namespace slalom
