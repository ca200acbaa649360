#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/gui/descriptor_panel.h>
#include <slalom/gui/display.h>
#include <slalom/gui/form_dialog.h>
#include <slalom/gui/list_panel.h>
#include <slalom/gui/menu_bar.h>
#include <slalom/gui/palette.h>
#include <slalom/gui/results_panel.h>
#include <slalom/gui/scenario_view.h>
#include <slalom/gui/splitter.h>
#include <slalom/gui/status_bar.h>
#include <slalom/gui/studio_window.h>

#include <GLFW/glfw3.h>
#include <algorithm>

namespace slalom {
namespace {

constexpr int kMenuHeight = 28, kStatusHeight = 28;
constexpr int kLeastPanel = 120;       // pixels, so that none is dragged out of sight
constexpr double kFileInterval = 1;    // s between looks at whether files were changed
constexpr double kIdleInterval = 0.5;  // s between frames when nothing happens

}  // namespace

StudioWindow::StudioWindow(SceneSettings scene, const StudioSettings& settings)
    : CDisplayWindowGUI("Slalom Studio", static_cast<unsigned>(settings.width),
                        static_cast<unsigned>(settings.height)),
      studio_(std::make_unique<Studio>(std::move(scene), [] { glfwPostEmptyEvent(); })),
      settings_(settings) {
  setBackground(palette().window);
  make_elements();
  connect();
  view_->set_legend_open(settings.legend);
  show_layers(settings.layers);
}

StudioWindow::~StudioWindow() {
  studio_.reset();  // workers end before what they report to
}

/// Names that are no layers any more are passed over.
void StudioWindow::show_layers(const std::string& names) {
  const std::vector<std::string> wanted = split(names, ',');
  for (const auto& layer : view_->layers())
    view_->set_layer(layer->id(),
                     std::find(wanted.begin(), wanted.end(), layer->id()) != wanted.end());
}

void StudioWindow::finish() {
  // The last ones are drawn over all others.
  popup_ = new MenuPopup(this, actions_, [this](const std::string& id) { run_action(id); });
  menu_ = new MenuBar(this, actions_, *popup_);
  show_documents();
  show_current();
  setVisible(true);
  performLayout(mNVGContext);
}

void StudioWindow::make_elements() {
  using Moves = Splitter::Moves;
  list_ = new ListPanel(this, studio_->jobs());
  descriptors_ = new DescriptorPanel(this);
  view_ = new ScenarioView(this);
  results_ = new ResultsPanel(this);
  list_splitter_ = new Splitter(this, "splitter_list", Moves::Across, [this](int by) {
    settings_.list_width += by;
    arrange();
  });
  descriptors_splitter_ =
      new Splitter(this, "splitter_descriptors", Moves::UpAndDown, [this](int by) {
        settings_.descriptors_height += by;
        arrange();
      });
  results_splitter_ = new Splitter(this, "splitter_results", Moves::UpAndDown, [this](int by) {
    settings_.results_height -= by;
    arrange();
  });
  status_ = new StatusBar(this, studio_->jobs());
}

void StudioWindow::next_panel() {
  std::vector<Element*> panels = {list_, descriptors_, view_};
  if (results_shown_) panels.push_back(results_);
  const auto now = std::find_if(panels.begin(), panels.end(), [this](const Element* panel) {
    return std::find(mFocusPath.begin(), mFocusPath.end(), panel) != mFocusPath.end();
  });
  const std::size_t next = now == panels.end() ? 0 : (now - panels.begin() + 1) % panels.size();
  panels[next]->requestFocus();
}

void StudioWindow::say(const std::string& message, bool is_error) {
  status_->say(message, is_error);
}

void StudioWindow::show_message(const std::string& title, const std::string& text) {
  FormDescription form;
  form.title = title;
  form.intro = text;
  open_form(*this, form);
}

void StudioWindow::run_action(const std::string& id) {
  try {
    actions_.run(id);
  } catch (const Error& error) {
    say(error.what(), true);
    show_message(actions_.find(id).title, error.what());
  }
}

void StudioWindow::show_results(bool shown) {
  results_shown_ = shown;
  arrange();
}

void StudioWindow::place(nanogui::Widget& widget, int left, int top, int width, int height) const {
  widget.setPosition({left, top});
  widget.setSize({std::max(width, 0), std::max(height, 0)});
}

void StudioWindow::arrange() {
  const int thick = Splitter::kThickness;
  const int tall = height() - kMenuHeight - kStatusHeight, bottom = kMenuHeight + tall;
  int& list = settings_.list_width;
  int& upper = settings_.descriptors_height;
  int& lower = settings_.results_height;
  list = std::clamp(list, kLeastPanel, std::max(width() - 2 * kLeastPanel, kLeastPanel));
  upper = std::clamp(upper, kLeastPanel, std::max(tall - 2 * kLeastPanel, kLeastPanel));
  const int most = std::max(tall - upper - kLeastPanel - 2 * thick, kLeastPanel);
  lower = std::clamp(lower, kLeastPanel, most);
  const int left = list + thick, right = width() - left;
  const int results = results_shown_ ? lower + thick : 0;
  place(*menu_, 0, 0, width(), kMenuHeight);
  place(*list_, 0, kMenuHeight, list, tall);
  place(*list_splitter_, list, kMenuHeight, thick, tall);
  place(*descriptors_, left, kMenuHeight, right, upper);
  place(*descriptors_splitter_, left, kMenuHeight + upper, right, thick);
  place(*view_, left, kMenuHeight + upper + thick, right, tall - upper - thick - results);
  place(*results_splitter_, left, bottom - results, right, thick);
  place(*results_, left, bottom - lower, right, lower);
  place(*status_, 0, bottom, width(), kStatusHeight);
  results_->setVisible(results_shown_);
  results_splitter_->setVisible(results_shown_);
  for (nanogui::Widget* element :
       std::initializer_list<nanogui::Widget*>{list_, descriptors_, view_, results_})
    element->performLayout(mNVGContext);
}

void StudioWindow::performLayout(NVGcontext* ctx) {
  Widget::performLayout(ctx);
  if (menu_ != nullptr) arrange();
}

bool StudioWindow::resizeEvent(const nanogui::Vector2i& size) {
  const bool handled = CDisplayWindowGUI::resizeEvent(size);
  if (menu_ != nullptr) arrange();
  return handled;
}

bool StudioWindow::dropEvent(const std::vector<std::string>& files) {
  if (on_drop && !dialog_open()) on_drop(files);
  return true;
}

bool StudioWindow::dialog_open() const {
  return std::any_of(children().begin(), children().end(), [](const nanogui::Widget* child) {
    const auto* window = dynamic_cast<const nanogui::Window*>(child);
    return window != nullptr && window->modal() && window->visible();
  });
}

bool StudioWindow::typing() const {
  return std::any_of(mFocusPath.begin(), mFocusPath.end(), [](const nanogui::Widget* widget) {
    return widget->focused() && dynamic_cast<const nanogui::TextBox*>(widget) != nullptr;
  });
}

bool StudioWindow::menu_key(int key) {
  if (!popup_->visible()) return false;
  switch (key) {
    case GLFW_KEY_UP:
      popup_->move_choice(-1);
      return true;
    case GLFW_KEY_DOWN:
      popup_->move_choice(1);
      return true;
    case GLFW_KEY_LEFT:
      menu_->open_beside(-1);
      return true;
    case GLFW_KEY_RIGHT:
      menu_->open_beside(1);
      return true;
    case GLFW_KEY_ENTER:
      popup_->choose_current();
      return true;
    default:
      popup_->close();
      return key == GLFW_KEY_ESCAPE;
  }
}

bool StudioWindow::keyboardEvent(int key, int scancode, int action, int modifiers) {
  const bool pressed = action == GLFW_PRESS || action == GLFW_REPEAT;
  if (!pressed || dialog_open())
    return CDisplayWindowGUI::keyboardEvent(key, scancode, action, modifiers);
  if (menu_key(key)) return true;
  const Action* wanted = actions_.find(KeyStroke{key, modifiers & 7});
  const bool control = (modifiers & GLFW_MOD_CONTROL) != 0;
  const bool of_text = std::string("ACVX").find(static_cast<char>(key)) != std::string::npos;
  const bool at_once = (control && !(typing() && of_text)) || key >= GLFW_KEY_F1;
  if (!(wanted != nullptr && at_once) &&
      CDisplayWindowGUI::keyboardEvent(key, scancode, action, modifiers))
    return true;
  if (wanted == nullptr) return false;
  run_action(wanted->id);
  return true;
}

bool StudioWindow::mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down,
                                    int modifiers) {
  if (down && popup_->visible() && !popup_->contains(p) && !menu_->contains(p)) {
    popup_->close();
    return true;
  }
  return CDisplayWindowGUI::mouseButtonEvent(p, button, down, modifiers);
}

void StudioWindow::frame() {
  const double now = glfwGetTime();
  if (now - files_looked_at_ > kFileInterval) {
    files_looked_at_ = now;
    studio_->look_at_files();
  }
  studio_->poll();
  show_progress();
  drawAll();
}

void StudioWindow::run(ScriptPlayer* script) {
  while (visible() && glfwWindowShouldClose(glfwWindow()) == 0) {
    frame();
    if (script != nullptr) {
      script->step();
      if (script->ended()) return;
      glfwPollEvents();
    } else {
      glfwWaitEventsTimeout(results_->overlay().clock().playing() ? 0.02 : kIdleInterval);
    }
  }
}

void StudioWindow::save_picture(const std::string& path) {
  save_window_picture(*this, path);
}

StudioSettings StudioWindow::settings() const {
  StudioSettings now = settings_;
  now.width = std::clamp(width(), 640, 8192);
  now.height = std::clamp(height(), 480, 8192);
  now.legend = view_->legend_open();
  now.layers.clear();
  for (const auto& layer : view_->layers())
    if (layer->on()) now.layers += (now.layers.empty() ? "" : ",") + layer->id();
  return now;
}

}  // namespace slalom
