// SPDX-License-Identifier: BSD-3-Clause
#include "forms/requests.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/core/version.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/studio/actions.h>
#include <slalom/studio/studio.h>

#include <filesystem>

namespace slalom {
namespace {

constexpr const char* kDemoKey = "demo";
const char* const kDemoTitle = "Open the demo";

FormField path_field(const std::string& label, const std::string& help,
                     const std::string& extension = ".scenarios") {
  FormField field{"file", label, FieldKind::Text, "", "", help};
  field.wide = true;
  field.extensions = {extension};
  return field;
}

FormField choice_field(const std::string& key, const std::string& label,
                       const std::vector<std::string>& choices, const std::string& value = "") {
  const std::string initial = value.empty() && !choices.empty() ? choices.front() : value;
  return {key, label, FieldKind::Choice, initial, "", "", choices};
}

FormField text_field(const std::string& key, const std::string& label, const std::string& help,
                     const std::string& value = "", bool required = true) {
  return {key, label, FieldKind::Text, value, "", help, {}, Range::any(), required};
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  for (const std::string& word : split(text, ','))
    if (!word.empty()) words.push_back(word);
  return words;
}

std::vector<double> edges_of(const std::string& text) {
  std::vector<double> edges;
  for (const std::string& word : words_of(text)) {
    double edge = 0;
    if (!parse_number(word, edge))
      throw usage_error("edges", "invalid number '" + word + "'",
                        "numbers such as 0, 0.1, 0.2, 0.4");
    edges.push_back(edge);
  }
  return edges;
}

std::vector<std::string> index_names(const Studio& studio) {
  std::vector<std::string> names;
  for (const ListIndex& index : studio.active()->indexes()) names.push_back(index.name);
  return names;
}

/// The other open lists as "NUMBER OF THE TAB: TITLE".
std::vector<std::string> other_lists(const Studio& studio) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < studio.documents().size(); ++i)
    if (i != studio.active_index())
      names.push_back(std::to_string(i + 1) + ": " + studio.documents()[i]->title());
  return names;
}

ListDocument& list_of(const Studio& studio, const std::string& name) {
  return *studio.documents().at(std::stoul(name) - 1);
}

std::string selection_text(const Studio& studio) {
  return count_text(studio.active()->selected_count(), "scenario") + " of " +
         studio.active()->title();
}

FormDescription transfer_form(Studio& studio, const std::string& verb,
                              void (ListDocument::*transfer)(ListDocument&)) {
  return {verb + " to another list",
          verb,
          selection_text(studio),
          {choice_field("list", "To", other_lists(studio))},
          [&studio, transfer](const FormValues& values) {
            (studio.active()->*transfer)(list_of(studio, values.at("list")));
          }};
}

FormDescription open_list_form(Studio& studio) {
  return {"Open list",
          "Open",
          "",
          {path_field("List", "a .scenarios file")},
          [&studio](const FormValues& values) { studio.open_list(values.at("file")); }};
}

FormDescription new_list_form(Studio& studio) {
  return {"New list",
          "Create",
          "",
          {path_field("List", "path of a new .scenarios file")},
          [&studio](const FormValues& values) { studio.create_list(values.at("file")); }};
}

FormDescription open_results_form(Studio& studio) {
  return {"Open results",
          "Open",
          "Shows recorded runs on top of their scenarios.",
          {path_field("Results", "a .results file", ".results")},
          [&studio](const FormValues& values) { studio.results().open(values.at("file")); }};
}

FormDescription save_as_form(Studio& studio) {
  return {"Save list as",
          "Save",
          "Saves a copy of the list; an existing file is overwritten.",
          {path_field("List", "a .scenarios file")},
          [&studio](const FormValues& values) {
            studio.active()->save_as(values.at("file"));
            studio.open_list(values.at("file"));
          }};
}

FormDescription copy_form(Studio& studio) {
  return transfer_form(studio, "Copy", &ListDocument::copy_to);
}

FormDescription move_form(Studio& studio) {
  return transfer_form(studio, "Move", &ListDocument::move_to);
}

/// One choice for each deletion, and all of them.
FormDescription restore_form(Studio& studio) {
  std::vector<std::string> choices, all;
  std::map<std::string, std::vector<std::string>> hashes;
  for (const auto& deletion : studio.active()->list().deletions()) {
    const std::size_t others = deletion.size() - 1;
    choices.push_back(deletion[0].name + " (" + deletion[0].id + ")" +
                      (others == 0 ? "" : " and " + std::to_string(others) + " more"));
    for (const auto& entry : deletion) {
      hashes[choices.back()].push_back(entry.hash);
      all.push_back(entry.hash);
    }
  }
  choices.push_back("all (" + std::to_string(all.size()) + ")");
  hashes[choices.back()] = all;
  return {"Restore deleted scenarios",
          "Restore",
          "Brings scenarios back that were deleted from this list, the latest first.",
          {choice_field("scenarios", "Scenarios", choices)},
          [&studio, hashes](const FormValues& values) {
            studio.active()->restore(hashes.at(values.at("scenarios")));
            studio.events().show_status(studio.active()->history().undo_title());
          }};
}

FormDescription rename_form(Studio& studio) {
  const std::string hash = studio.current_hash();
  return {"Rename scenario",
          "Rename",
          "",
          {text_field("name", "Name", "of the current scenario",
                      studio.current_entry() ? studio.current_entry()->name : "")},
          [&studio, hash](const FormValues& values) {
            studio.active()->rename(hash, values.at("name"));
          }};
}

FormDescription tag_form(Studio& studio) {
  return {"Tags",
          "Apply",
          selection_text(studio),
          {text_field("add", "Add", "words, comma separated", "", false),
           text_field("remove", "Remove", "words, comma separated", "", false)},
          [&studio](const FormValues& values) {
            studio.active()->tag(words_of(values.at("add")), words_of(values.at("remove")));
          }};
}

FormDescription create_index_form(Studio& studio) {
  return {"Create index",
          "Create",
          "Divides the values of a descriptor into ranges, for groups and filters (by_density[0]).",
          {text_field("name", "Name", "a word", "by_density"),
           choice_field("descriptor", "Descriptor", descriptor_ids(), "density"),
           text_field("edges", "Edges", "increasing, comma separated", "0, 0.1, 0.2, 0.4")},
          [&studio](const FormValues& values) {
            studio.active()->create_index(values.at("name"), values.at("descriptor"),
                                          edges_of(values.at("edges")));
            studio.active()->set_group_by(values.at("name"));
          }};
}

FormDescription drop_index_form(Studio& studio) {
  return {"Drop index",
          "Drop",
          "",
          {choice_field("index", "Index", index_names(studio))},
          [&studio](const FormValues& values) {
            ListDocument& document = *studio.active();
            if (document.request().group_by == values.at("index")) document.set_group_by("");
            document.drop_index(values.at("index"));
          }};
}

FormDescription deduplicate_form(Studio& studio) {
  FormField min_difference =
      text_field("min_difference", "Minimum difference", "in that descriptor", "0.01");
  min_difference.kind = FieldKind::Number;
  min_difference.range = Range::positive();
  return {"Remove near-duplicates",
          "Remove",
          "Keeps only the first of scenarios that differ by less than this.",
          {choice_field("descriptor", "Descriptor", descriptor_ids(), "density"), min_difference},
          [&studio](const FormValues& values) {
            double difference = 0;
            parse_number(values.at("min_difference"), difference);
            const std::size_t removed =
                studio.active()->deduplicate({{values.at("descriptor"), difference}});
            studio.events().show_status(count_text(removed, "near-duplicate") + " removed");
          }};
}

FormDescription edit_movers_form(Studio& studio) {
  const Scenario scenario = studio.active()->list().read(studio.current_hash());
  FormDescription form = movers_form(scenario);
  form.accepted = [&studio, scenario](const FormValues& values) {
    studio.edit_current({read_movers(scenario, values), "Edit moving obstacles"});
  };
  return form;
}

FormDescription edit_people_form(Studio& studio) {
  const Scenario scenario = studio.active()->list().read(studio.current_hash());
  FormDescription form = people_form(scenario);
  const double resolution = studio.scenes().scene()->settings.resolution;
  form.accepted = [&studio, scenario, resolution](const FormValues& values) {
    const SceneEdit edit{read_people(scenario, values), "Edit people"};
    check_edited_people(World(scenario, resolution), edit.scenario);
    studio.edit_current(edit);
  };
  return form;
}

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
  return [&studio, check = list_disabled_check(studio, action)]() -> std::string {
    if (!check().empty()) return check();
    return studio.documents().size() < 2 ? "no other list is open" : "";
  };
}

std::function<void()> opens(Studio& studio, Form form) {
  return [&studio, form] { studio.events().show_form(form(studio)); };
}

/// The path without as many of its first folders as a menu has no space for.
std::string short_path(const std::string& path) {
  constexpr std::size_t kMaxLength = 36;
  std::size_t begin = 0;
  while (path.size() - begin > kMaxLength) {
    const std::size_t slash = path.find('/', begin + 1);
    if (slash == std::string::npos) break;
    begin = slash;
  }
  return (begin == 0 ? "" : "...") + path.substr(begin);
}

/// For example "Undo: delete 3 scenarios".
std::string with_title(const std::string& word, const std::string& title) {
  return title.empty() ? word : word + ": " + title;
}

/// Headings, and lines of two columns with a tab between them.
std::string key_lines(const Actions& actions) {
  std::string text, heading;
  const auto add = [&](const std::string& below, const std::string& keys, const std::string& help) {
    if (below != heading) text += (text.empty() ? "" : "\n") + below + "\n";
    heading = below;
    text += keys + "\t" + help + "\n";
  };
  for (const Action& action : actions.all())
    if (!action.shortcut.empty()) add("Menu " + action.menu, action.shortcut, action.title);
  for (const PanelKey& key : panel_keys())
    add("In the panel '" + key.panel + "'", join(key.keys, ", "), key.help);
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

void add_recent_actions(Actions& actions, Studio& studio) {
  for (std::size_t i = 0; i < studio.recent().size(); ++i) {
    const auto path = [&studio, i]() -> std::string { return studio.recent()[i]; };
    const std::string number = std::to_string(i + 1);
    actions.add({"file.recent_" + number,
                 "File",
                 "Recent file " + number,
                 "",
                 "Opens a list or results that were open before.",
                 [&studio, path] { open_files(studio, {path()}); },
                 [path]() -> std::string {
                   std::error_code error;
                   return std::filesystem::exists(path(), error)
                              ? ""
                              : short_path(path()) + " does not exist";
                 },
                 [path] { return short_path(path()); },
                 {},
                 [path] { return path().empty(); }});
  }
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
               [&studio] { studio.remove_selected(); },
               list_disabled_check(studio, ListAction::Remove)});
  actions.add({"edit.restore", "Edit", "Restore deleted...", "",
               "Brings back deleted scenarios of this list, also of earlier sessions.",
               opens(studio, restore_form), list_disabled_check(studio, ListAction::Restore)});
  actions.add({"edit.rename", "Edit", "Rename...", "F2", "Renames the current scenario.",
               opens(studio, rename_form), list_disabled_check(studio, ListAction::Rename)});
  actions.add({"edit.movers", "Edit", "Moving obstacles...", "Ctrl+M",
               "Edits ids, radii, positions and times of the moving obstacles of the scenario.",
               opens(studio, edit_movers_form), [&studio]() -> std::string {
                 const ScenePtr& scene = studio.scenes().scene();
                 if (!scene || studio.current_hash().empty()) return "no scenario is shown";
                 return scene->scenario().movers().empty()
                            ? "this scenario has no moving obstacles; the tool + Mover adds one"
                            : "";
               }});
  actions.add({"edit.people", "Edit", "People...", "Ctrl+Shift+M",
               "Edits ids, radii, speeds, starts and routes of the people of the scenario.",
               opens(studio, edit_people_form), [&studio]() -> std::string {
                 const ScenePtr& scene = studio.scenes().scene();
                 if (!scene || studio.current_hash().empty()) return "no scenario is shown";
                 return scene->scenario().people().empty()
                            ? "this scenario has no people; the tool + Person adds one"
                            : "";
               }});
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
  actions.add({"list.replay", "List", "Replay runs", "",
               "Plays the recorded runs of the current scenario from their start.",
               [&studio] { studio.results().replay(); },
               [&studio] { return studio.results().replay_disabled_reason(); }});
  actions.add({"list.describe", "List", "Compute all descriptors", "F5",
               "Computes the missing values of all scenarios and stores them in the list.",
               [&studio] { studio.describe_list(); }, needs_list(studio)});
}

void open_demo(Studio& studio) {
  studio.jobs().start(
      kDemoKey, kDemoTitle,
      [&studio](Progress& progress) -> Jobs::Delivery {
        return [&studio, folder = studio.services().make_demo(progress)] {
          studio.open_list(folder + "/campaign.scenarios");
          studio.results().open(folder + "/runs.results");
        };
      },
      [&studio](const std::string& message) { studio.events().show_error(message, kDemoTitle); });
}

std::string demo_disabled_reason(Studio& studio) {
  if (!studio.services().make_demo) return "this program has no demo";
  return studio.jobs().is_pending(kDemoKey) ? "the demo is running; the status bar cancels it" : "";
}

void add_help_actions(Actions& actions, Studio& studio) {
  actions.add({"help.demo", "Help", kDemoTitle, "",
               "Opens 70 scenarios with the runs of four methods, which are made the first time.",
               [&studio] { open_demo(studio); },
               [&studio] { return demo_disabled_reason(studio); }});
  actions.add({"help.keys", "Help", "Keys", "F1", "Lists the keyboard shortcuts.",
               [&studio, &actions] { studio.events().show_message("Keys", key_lines(actions)); }});
  actions.add({"help.about", "Help", "About", "", "Shows the version.", [&studio] {
                 studio.events().show_message("Slalom Studio",
                                              "Version " + version() + ", MRPT " + mrpt_version());
               }});
}

}  // namespace slalom
