// SPDX-License-Identifier: BSD-3-Clause
#include "views/form_panel.h"
#include "views/panels.h"
#include "views/scenario_view.h"
#include "widgets/action_finder.h"
#include "widgets/drawing.h"
#include "widgets/menu.h"
#include "widgets/splitter.h"
#include "window/script_player.h"
#include "window/window_layout.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/gui/studio_window.h>
#include <slalom/studio/actions.h>

#include <GLFW/glfw3.h>
#include <algorithm>

namespace slalom {
namespace {

constexpr double kFileInterval = 1;  // s between checks for changed files

Action layer_action(ScenarioView& view, const SceneLayer& layer) {
  const std::string& id = layer.id;
  return {"layer." + id,
          "Layers",
          layer.title,
          "",
          "Shows or hides the layer.",
          [&view, id] { view.set_layer(id, !view.layer_on(id)); },
          {},
          {},
          [&view, id] { return view.layer_on(id); }};
}

Action coloring_action(Studio& studio, RunColoring coloring) {
  const std::string name = to_string(coloring);
  return {"coloring." + name,
          "Layers",
          "Color runs by " + name,
          "",
          coloring == RunColoring::Method
              ? "Draws each run in the color of its method."
              : "Draws each run in colors of its " + name + ", with a color bar.",
          [&studio, coloring] { studio.results().overlay().set_coloring(coloring); },
          {},
          {},
          [&studio, coloring] { return studio.results().overlay().coloring() == coloring; }};
}

Action grid_action(Studio& studio) {
  return {"view.grid",
          "View",
          "Grid of pictures",
          "",
          "Shows the scenarios of the list as larger pictures side by side.",
          [&studio] { studio.grid() = !studio.grid(); },
          {},
          {},
          [&studio] { return studio.grid(); }};
}

Action theme_action(std::function<void()> change) {
  return {"view.light_theme",
          "View",
          "Light theme",
          "",
          "Dark text on light panels, for bright rooms and pictures in print.",
          std::move(change),
          {},
          {},
          [] { return theme_in_use() == Theme::Light; }};
}

Action tool_action(ScenarioView& view, const EditToolInfo& info) {
  return {"tool." + info.id,
          "Tools",
          info.title,
          "",
          info.help,
          [&view, tool = info.tool] { view.set_tool(tool); },
          [&view, tool = info.tool]() -> std::string {
            if (!view.scene()) return "no scenario is shown";
            return tool_disabled_reason(tool, view.scene()->scenario());
          },
          {},
          [&view, tool = info.tool] { return view.tool() == tool; }};
}

}  // namespace

StudioWindow::StudioWindow(SceneSettings scene, const StudioSettings& settings,
                           StudioServices services)
    : PanelWindow("Slalom Studio", settings.width, settings.height, std::move(scene),
                  std::move(services)),
      settings_(settings) {
  make_elements();
  studio().recent() = settings.recent;
  studio().grid() = settings.grid;
  show_theme(settings.theme);
  view_->set_legend_open(settings.legend);
  show_layers(settings.layers);
  add_actions();
  // Created last, to be drawn on top.
  menu_ = new MenuBar(this, actions_, [this](const std::string& id) { run_action(id); });
  finder_ = new ActionFinder(this, actions_, [this](const std::string& id) { run_action(id); });
  studio().events().observe({Change::Current}, [this] {
    const auto entry = studio().current_entry();
    setWindowTitle((entry ? entry->name + " - " : "") + "Slalom Studio");
  });
  studio().events().observe({Change::Runs, Change::Scene}, [this] {
    if (results_->visible() != results_shown() || timeline_->visible() != timeline_shown())
      arrange();
  });
  set_scale(settings.scale);
  show();
}

void StudioWindow::show_theme(Theme theme) {
  use_theme(theme);
  setBackground(draw::nvg(palette().window));
}

/// Ignores unknown names.
void StudioWindow::show_layers(const std::string& names) {
  const std::vector<std::string> visible = split(names, ',');
  for (const auto& layer : view_->layers())
    view_->set_layer(layer.id,
                     std::find(visible.begin(), visible.end(), layer.id) != visible.end());
}

void StudioWindow::add_actions() {
  add_file_actions(actions_, studio());
  add_import_export_actions(actions_, studio());
  add_recent_actions(actions_, studio());
  actions_.add({"file.quit", "File", "Quit", "Ctrl+Q", "Closes the window. All changes are saved.",
                [this] { setVisible(false); }});
  add_edit_actions(actions_, studio());
  add_list_actions(actions_, studio());
  add_generate_actions(actions_, studio());
  add_run_actions(actions_, studio());
  add_view_actions();
  add_help_actions(actions_, studio());
}

void StudioWindow::make_elements() {
  using DragAxis = Splitter::DragAxis;
  list_ = make_list_panel(this, studio());
  descriptors_ = make_descriptor_panel(this, studio());
  view_ = new ScenarioView(this, studio(), ScenarioView::Mode::Edit);
  results_ = make_results_panel(this, studio());
  timeline_ = make_replay_bar(this, studio().results().overlay().clock(), "timeline");
  const auto add_splitter = [this](const std::string& id, DragAxis axis, int StudioSettings::*size,
                                   int sign) {
    new Splitter(this, id, axis, [=](int by) { resize_panel(size, sign * by); });
  };
  add_splitter("splitter_list", DragAxis::Horizontal, &StudioSettings::list_width, 1);
  add_splitter("splitter_descriptors", DragAxis::Vertical, &StudioSettings::descriptors_height, -1);
  add_splitter("splitter_results", DragAxis::Vertical, &StudioSettings::results_height, -1);
  make_status_bar(this, studio(), [this] { run_action("edit.undo"); });
}

bool StudioWindow::has_movers() {
  const ScenePtr& scene = studio().scenes().scene();
  return scene && !scene->scenario().movers().empty();
}

void StudioWindow::next_panel() {
  std::vector<Element*> panels = {list_, descriptors_, view_};
  if (results_shown()) panels.push_back(results_);
  if (timeline_shown()) panels.push_back(timeline_);
  const auto now = std::find_if(panels.begin(), panels.end(), [this](const Element* panel) {
    return std::find(mFocusPath.begin(), mFocusPath.end(), panel) != mFocusPath.end();
  });
  const std::size_t next = now == panels.end() ? 0 : (now - panels.begin() + 1) % panels.size();
  panels[next]->requestFocus();
}

/// A disabled action only shows its reason in the status line. The line shows nothing of earlier
/// actions.
void StudioWindow::run_action(const std::string& id) {
  const Action& action = actions_.find(id);
  const std::string reason = action.disabled_reason();
  studio().events().show_status(reason.empty() ? "" : action.title + ": " + reason,
                                !reason.empty());
  if (!reason.empty()) return;
  try {
    actions_.run(id);
  } catch (const Error& error) {
    studio().events().show_error(error.what(), action.title);
  }
}

void StudioWindow::resize_panel(int StudioSettings::*size, int by) {
  settings_ = with_fitted_panels(settings_, width(), height());
  settings_.*size += by;
  settings_ = with_fitted_panels(settings_, width(), height());
  arrange();
}

void StudioWindow::arrange() {
  const BelowView below = results_shown()    ? BelowView::Results
                          : timeline_shown() ? BelowView::Timeline
                                             : BelowView::Nothing;
  const WindowLayout layout = lay_out_window(width(), height(), settings_, below);
  for (nanogui::Widget* child : children()) {
    const auto bounds = layout.find(child->id());
    if (bounds == layout.end()) continue;  // a dialog or a menu
    static_cast<Element*>(child)->set_bounds(bounds->second);
    child->setVisible(bounds->second.height > 0);
    child->performLayout(mNVGContext);
  }
}

bool StudioWindow::dropEvent(const std::vector<std::string>& files) {
  dialog_open() ? drop_into_form(*this, files) : open_files(studio(), files);
  return true;
}

bool StudioWindow::dialog_open() const {
  return std::any_of(children().begin(), children().end(), [](const nanogui::Widget* child) {
    const auto* window = dynamic_cast<const nanogui::Window*>(child);
    return window != nullptr && window->modal() && window->visible();
  });
}

nanogui::Widget* StudioWindow::focused_text_field() const {
  const auto found =
      std::find_if(mFocusPath.begin(), mFocusPath.end(), [](const nanogui::Widget* widget) {
        return widget->focused() && dynamic_cast<const nanogui::TextBox*>(widget) != nullptr;
      });
  return found == mFocusPath.end() ? nullptr : *found;
}

bool StudioWindow::keyboardEvent(int key, int scancode, int action, int modifiers) {
  const nanogui::Widget* before = mFocusPath.empty() ? nullptr : mFocusPath.front();
  const bool handled = handle_key(key, scancode, action, modifiers);
  const nanogui::Widget* after = mFocusPath.empty() ? nullptr : mFocusPath.front();
  key_moved_focus_ = action != GLFW_RELEASE && before != after;
  return handled;
}

/// GLFW sends a key event before its character event. If the key moved the focus to another
/// element, the character is not meant for that element.
bool StudioWindow::keyboardCharacterEvent(unsigned int letter) {
  if (finder_->visible() && !dialog_open()) return finder_->insert(letter), true;
  return key_moved_focus_ || PanelWindow::keyboardCharacterEvent(letter);
}

bool StudioWindow::handle_key(int key, int scancode, int action, int modifiers) {
  const bool pressed = action == GLFW_PRESS || action == GLFW_REPEAT;
  if (!pressed || dialog_open())
    return PanelWindow::keyboardEvent(key, scancode, action, modifiers);
  if (finder_->visible()) return finder_->key(key, modifiers & 7), true;
  if (menu_->popup_key(key, modifiers & 7)) return true;
  // nanogui passes keys to outer elements first; a focused text field has priority over them.
  nanogui::Widget* text_field = focused_text_field();
  if (text_field != nullptr && is_key_of_text({key, modifiers & 7}))
    return text_field->keyboardEvent(key, scancode, action, modifiers);
  const Action* found = actions_.find(KeyStroke{key, modifiers & 7});
  const bool has_priority = (modifiers & GLFW_MOD_CONTROL) != 0 || key >= GLFW_KEY_F1;
  if (!(found != nullptr && has_priority) &&
      PanelWindow::keyboardEvent(key, scancode, action, modifiers))
    return true;
  if (found == nullptr) return false;
  run_action(found->id);
  return true;
}

bool StudioWindow::mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down,
                                    int modifiers) {
  if (down && finder_->visible() && !finder_->contains(p)) {
    finder_->close();
    return true;
  }
  Menu& popup = menu_->popup();
  if (down && popup.visible() && !popup.contains(p) && !menu_->contains(p)) {
    popup.close();
    return true;
  }
  const bool handled = PanelWindow::mouseButtonEvent(p, button, down, modifiers);
  if (down && button == GLFW_MOUSE_BUTTON_RIGHT && !dialog_open() && is_on_rows(p))
    menu_->open_context({static_cast<double>(p.x()), static_cast<double>(p.y())},
                        scenario_actions());
  return handled;
}

bool StudioWindow::is_on_rows(const nanogui::Vector2i& p) const {
  const nanogui::Widget* rows = find_visible_widget(*list_, "rows");
  const ListDocument* list = studio().active();
  return rows != nullptr && list != nullptr && !list->view().hashes.empty() &&
         rows->contains(p - rows->parent()->absolutePosition());
}

void StudioWindow::update() {
  const double now = glfwGetTime();
  if (now - files_checked_at_ > kFileInterval) {
    files_checked_at_ = now;
    studio().check_files();
  }
  PanelWindow::update();
}

StudioSettings StudioWindow::settings() const {
  StudioSettings now = settings_;
  now.width = std::clamp(width(), 640, 8192);
  now.height = std::clamp(height(), 480, 8192);
  now.theme = theme_in_use();
  now.legend = view_->legend_open();
  now.recent = studio().recent();
  now.grid = studio().grid();
  now.layers.clear();
  for (const auto& layer : view_->layers())
    if (layer.on) now.layers += (now.layers.empty() ? "" : ",") + layer.id;
  return now;
}

/// The actions that concern only the window.
void StudioWindow::add_view_actions() {
  const auto needs_list = [this]() -> std::string {
    return studio().active() == nullptr ? "no list is open" : "";
  };
  actions_.add({"list.sort", "List", "Sort...", "", "Sorts by name or by a descriptor.",
                [this] { list_->click("sort"); }, needs_list});
  actions_.add({"list.group", "List", "Group...", "", "Groups by the ranges of an index.",
                [this] { list_->click("group_by"); }, needs_list});
  ScenarioView& view = *view_;
  actions_.add({"view.fit", "View", "Show all", "Ctrl+0", "Fits the scenario to the view.",
                [&view] { view.fit(); }});
  actions_.add({"view.zoom_in", "View", "Zoom in", "Ctrl+Plus",
                "Zooms about the center of the view.", [&view] { view.zoom(1.25); }});
  actions_.add({"view.zoom_out", "View", "Zoom out", "Ctrl+Minus",
                "Zooms about the center of the view.", [&view] { view.zoom(0.8); }});
  actions_.add(grid_action(studio()));
  actions_.add({"view.legend",
                "View",
                "Legend",
                "",
                "Shows or hides the list of layers.",
                [&view] { view.set_legend_open(!view.legend_open()); },
                {},
                {},
                [&view] { return view.legend_open(); }});
  actions_.add(theme_action(
      [this] { show_theme(theme_in_use() == Theme::Dark ? Theme::Light : Theme::Dark); }));
  actions_.add({"view.scenario", "View", "Show scenario", "",
                "Moves the focus to the current scenario and fits it to the view.",
                [&view] {
                  view.fit();
                  view.requestFocus();
                },
                [this]() -> std::string {
                  return studio().current_hash().empty() ? "no scenario is selected" : "";
                }});
  actions_.add({"view.play", "View", "Play moving obstacles", "Ctrl+P",
                "Plays or pauses the moving obstacles, and the runs if results are open.",
                [this] { studio().results().overlay().clock().toggle(); },
                [this]() -> std::string {
                  if (studio().results().overlay().clock().duration() > 0) return "";
                  return has_movers() ? "no moving obstacle of this scenario moves"
                                      : "this scenario has no moving obstacles";
                }});
  actions_.add({"view.next_panel", "View", "Next panel", "F6",
                "Moves the focus to the list, the descriptors, the scenario, the results or times.",
                [this] { next_panel(); }});
  actions_.add({"view.find_action", "View", "Find action...", "Ctrl+K",
                "Lists all actions; typing filters them by words in any order, Enter runs one.",
                [this] { finder_->open(); }});
  for (const auto& layer : view.layers()) actions_.add(layer_action(view, layer));
  for (const RunColoring coloring :
       {RunColoring::Method, RunColoring::Speed, RunColoring::Clearance})
    actions_.add(coloring_action(studio(), coloring));
  for (const EditToolInfo& info : edit_tools()) actions_.add(tool_action(view, info));
}

}  // namespace slalom
