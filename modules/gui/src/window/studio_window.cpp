#include "views/descriptor_panel.h"
#include "views/list_panel.h"
#include "views/results_panel.h"
#include "views/scenario_view.h"
#include "views/status_bar.h"
#include "widgets/menu_bar.h"
#include "widgets/splitter.h"
#include "window/window_layout.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/gui/studio_window.h>
#include <slalom/studio/studio_actions.h>

#include <GLFW/glfw3.h>
#include <algorithm>

namespace slalom {
namespace {

constexpr double kFileInterval = 1;  // s between checks for changed files

}  // namespace

StudioWindow::StudioWindow(SceneSettings scene, const StudioSettings& settings,
                           StudioServices services)
    : PanelWindow("Slalom Studio", settings.width, settings.height, std::move(scene),
                  std::move(services)),
      settings_(settings) {
  make_elements();
  view_->set_legend_open(settings.legend);
  show_layers(settings.layers);
  add_actions();
  // Created last, to be drawn on top.
  menu_ = new MenuBar(this, actions_, [this](const std::string& id) { run_action(id); });
  studio().notices().observe([this](Change change) { studio_changed(change); });
  show();
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
  actions_.add({"file.quit", "File", "Quit", "Ctrl+Q", "Closes the window. All changes are saved.",
                [this] { setVisible(false); }});
  add_edit_actions(actions_, studio());
  add_list_actions(actions_, studio());
  add_generate_actions(actions_, studio());
  add_view_actions();
  add_help_actions(actions_, studio());
}

void StudioWindow::studio_changed(Change change) {
  if (change == Change::Current) {
    const auto entry = studio().current_entry();
    setWindowTitle((entry ? entry->name + " - " : "") + "Slalom Studio");
  }
  if (change == Change::Runs && results_->visible() != results_shown()) arrange();
}

void StudioWindow::make_elements() {
  using DragAxis = Splitter::DragAxis;
  list_ = new ListPanel(this, studio());
  descriptors_ = new DescriptorPanel(this, studio());
  view_ = new ScenarioView(this, studio(), ScenarioView::Mode::Edit);
  results_ = new ResultsPanel(this, studio());
  list_splitter_ = new Splitter(this, "splitter_list", DragAxis::Horizontal,
                                [this](int by) { resize_panel(&StudioSettings::list_width, by); });
  descriptors_splitter_ =
      new Splitter(this, "splitter_descriptors", DragAxis::Vertical,
                   [this](int by) { resize_panel(&StudioSettings::descriptors_height, -by); });
  results_splitter_ = new Splitter(this, "splitter_results", DragAxis::Vertical, [this](int by) {
    resize_panel(&StudioSettings::results_height, -by);
  });
  status_ = new StatusBar(this, studio());
}

void StudioWindow::next_panel() {
  std::vector<Element*> panels = {list_, descriptors_, view_};
  if (results_shown()) panels.push_back(results_);
  const auto now = std::find_if(panels.begin(), panels.end(), [this](const Element* panel) {
    return std::find(mFocusPath.begin(), mFocusPath.end(), panel) != mFocusPath.end();
  });
  const std::size_t next = now == panels.end() ? 0 : (now - panels.begin() + 1) % panels.size();
  panels[next]->requestFocus();
}

void StudioWindow::run_action(const std::string& id) {
  try {
    actions_.run(id);
  } catch (const Error& error) {
    studio().notices().show_error(error.what(), actions_.find(id).title);
  }
}

void StudioWindow::resize_panel(int StudioSettings::*size, int by) {
  settings_ = with_fitted_panels(settings_, width(), height());
  settings_.*size += by;
  settings_ = with_fitted_panels(settings_, width(), height());
  arrange();
}

void StudioWindow::arrange() {
  const WindowLayout layout = lay_out_window(width(), height(), settings_, results_shown());
  menu_->set_bounds(layout.menu);
  list_->set_bounds(layout.list);
  list_splitter_->set_bounds(layout.list_splitter);
  descriptors_->set_bounds(layout.descriptors);
  descriptors_splitter_->set_bounds(layout.descriptors_splitter);
  view_->set_bounds(layout.view);
  results_splitter_->set_bounds(layout.results_splitter);
  results_->set_bounds(layout.results);
  status_->set_bounds(layout.status);
  results_->setVisible(results_shown());
  results_splitter_->setVisible(results_shown());
  for (nanogui::Widget* element :
       std::initializer_list<nanogui::Widget*>{list_, descriptors_, view_, results_})
    element->performLayout(mNVGContext);
}

bool StudioWindow::dropEvent(const std::vector<std::string>& files) {
  if (!dialog_open()) open_files(studio(), files);
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
  return key_moved_focus_ || PanelWindow::keyboardCharacterEvent(letter);
}

bool StudioWindow::handle_key(int key, int scancode, int action, int modifiers) {
  const bool pressed = action == GLFW_PRESS || action == GLFW_REPEAT;
  if (!pressed || dialog_open())
    return PanelWindow::keyboardEvent(key, scancode, action, modifiers);
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
  Menu& popup = menu_->popup();
  if (down && popup.visible() && !popup.contains(p) && !menu_->contains(p)) {
    popup.close();
    return true;
  }
  return PanelWindow::mouseButtonEvent(p, button, down, modifiers);
}

void StudioWindow::frame() {
  const double now = glfwGetTime();
  if (now - files_checked_at_ > kFileInterval) {
    files_checked_at_ = now;
    studio().check_files();
  }
  PanelWindow::frame();
}

StudioSettings StudioWindow::settings() const {
  StudioSettings now = settings_;
  now.width = std::clamp(width(), 640, 8192);
  now.height = std::clamp(height(), 480, 8192);
  now.legend = view_->legend_open();
  now.layers.clear();
  for (const auto& layer : view_->layers())
    if (layer.on) now.layers += (now.layers.empty() ? "" : ",") + layer.id;
  return now;
}

}  // namespace slalom
