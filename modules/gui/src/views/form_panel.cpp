#include "views/form_panel.h"
#include "widgets/drawing.h"

#include <slalom/core/error.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <utility>

namespace slalom {
namespace {

constexpr double kButtonWidth = 120;  // pixels

}  // namespace

FormPanel::FormPanel(nanogui::Widget* parent, FormDescription description,
                     std::function<void()> close)
    : Element(parent, "dialog"),
      model_(std::move(description)),
      close_(std::move(close)),
      layout_(model_, 0, [](const std::string&, float) { return 0; }) {
  set_focus_to(tab_stops().front());
}

void FormPanel::fit(NVGcontext* ctx, const nanogui::Vector2i& max_size) {
  context_ = ctx;
  const FormDescription& form = model_.description();
  const double width = std::min<double>(FormLayout::preferred_width(form), max_size.x());
  intro_height_ =
      form.intro.empty() ? 0 : draw::wrapped_height(ctx, form.intro, width - 2 * kMargin) + 10;
  setWidth(static_cast<int>(width));
  lay_out();
  const double preferred = kTitleHeight + intro_height_ + layout_.height() + footer_height();
  // The dialog only grows, so that it does not jump when fields are shown or hidden.
  setHeight(std::max(height(), static_cast<int>(std::min<double>(preferred + 1, max_size.y()))));
  setHeight(std::min(height(), max_size.y()));
  setFixedSize(size());
  scroll_.set(is_message() ? intro_height_ : layout_.height(), content());
}

void FormPanel::lay_out() {
  if (context_ == nullptr) return;
  layout_ = FormLayout(model_, width(), [this](const std::string& text, float size) {
    return draw::text_width(context_, text, size);
  });
  scroll_.set(is_message() ? intro_height_ : layout_.height(), content());
}

void FormPanel::accept() {
  if (const auto error = model_.first_error()) {
    for (std::size_t i = 0; i < model_.fields().size(); ++i) touched_.insert(i);
    set_focus_to(error->first);
    message_ = error->second;
    return;
  }
  try {
    if (model_.description().accepted) model_.description().accepted(model_.values());
  } catch (const std::exception& error) {
    message_ = reason_of(error);
    return;
  }
  cancel();
}

void FormPanel::cancel() {
  const auto close = std::exchange(close_, nullptr);
  if (close) close();
}

std::string FormPanel::text() const {
  std::string all = model_.description().title + "\n" + model_.description().intro + "\n";
  for (std::size_t i = 0; i < model_.fields().size(); ++i) {
    if (!model_.is_shown(i)) continue;
    const FormField& field = model_.fields()[i];
    all += field.label;
    if (field.kind != FieldKind::Heading) all += ": " + model_.value(i);
    if (!field.unit.empty()) all += " " + field.unit;
    const std::string error = error_of(i);
    all += (error.empty() ? "" : " (" + error + ")") + "\n";
  }
  return all + (message_.empty() ? "" : message_ + "\n");
}

std::string FormPanel::error_of(std::size_t field) const {
  return touched_.count(field) > 0 ? model_.error_of(field) : "";
}

std::vector<Element::Part> FormPanel::parts() const {
  std::vector<Part> all = {{"ok", ok_rect()}};
  if (!is_message()) all.push_back({"cancel", cancel_rect()});
  const auto add = [&](const std::string& name, const ScreenRect& rect) {
    if (is_in_view(rect)) all.push_back({name, to_panel(rect)});
  };
  for (const FormLine& line : layout_.lines()) {
    const FormField& field = model_.fields()[line.field];
    add("field " + field.key, line.box);
    for (std::size_t i = 0; i < line.choices.size(); ++i)
      add("choice " + field.key + " " + field.choices[i], line.choices[i]);
  }
  return all;
}

ScreenRect FormPanel::content() const {
  const double top = kTitleHeight + (is_message() ? 0 : intro_height_);
  const double bottom = height() - footer_height();
  return {0, top, static_cast<double>(width()), std::max(0.0, bottom - top)};
}
ScreenRect FormPanel::ok_rect() const {
  return {width() - kMargin - kButtonWidth, height() - 44.0, kButtonWidth, 32};
}
ScreenRect FormPanel::cancel_rect() const {
  return {width() - kMargin - 2 * kButtonWidth - 10, height() - 44.0, kButtonWidth, 32};
}

ScreenRect FormPanel::to_panel(ScreenRect rect) const {
  rect.top += content().top - scroll_.offset();
  return rect;
}

bool FormPanel::is_in_view(const ScreenRect& rect) const {
  const ScreenRect shown = to_panel(rect);
  return shown.top >= content().top && shown.bottom() <= content().bottom();
}

bool FormPanel::is_text_field(std::size_t field) const {
  if (field >= model_.fields().size()) return false;
  const FieldKind kind = model_.fields()[field].kind;
  return kind == FieldKind::Text || kind == FieldKind::Number || kind == FieldKind::Integer;
}

std::vector<std::size_t> FormPanel::tab_stops() const {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < model_.fields().size(); ++i)
    if (model_.is_shown(i) && model_.fields()[i].kind != FieldKind::Heading) all.push_back(i);
  if (!is_message()) all.push_back(cancel_tab_stop());
  all.push_back(ok_tab_stop());
  return all;
}

void FormPanel::set_focus_to(std::size_t stop) {
  focus_ = stop;
  choice_ = 0;
  if (stop >= model_.fields().size()) return;
  editor_.set_text(model_.value(stop));
  editor_.select_all();
  const auto& choices = model_.fields()[stop].choices;
  for (std::size_t i = choices.size(); i-- > 0;)
    if (model_.is_chosen(stop, choices[i])) choice_ = i;
  if (const FormLine* line = context_ == nullptr ? nullptr : layout_.line_of(stop))
    scroll_.show(line->top, line->top + line->height);
}

void FormPanel::move_focus_by(int steps) {
  const auto all = tab_stops();
  const int count = static_cast<int>(all.size());
  const int at = static_cast<int>(std::find(all.begin(), all.end(), focus_) - all.begin());
  set_focus_to(all[static_cast<std::size_t>(((at % count) + steps + count) % count)]);
}

void FormPanel::edited() {
  model_.set_value(focus_, editor_.text());
  touched_.insert(focus_);
  message_.clear();
}

void FormPanel::choose(std::size_t field, std::size_t choice) {
  const auto& choices = model_.fields()[field].choices;
  model_.choose(field, choice < choices.size() ? choices[choice] : "");
  choice_ = choice;
  touched_.insert(field);
  message_.clear();
  lay_out();
}

bool FormPanel::press(const Point& at, int modifiers) {
  if (at.y < kTitleHeight) return false;  // dragging the title moves the dialog
  pressed_ = button_at(at);
  if (pressed_ != 0 || scroll_.press(at) || !content().contains(at)) return true;
  for (const FormLine& line : layout_.lines())
    if (to_panel(line.box).contains(at)) {
      press_line(line, at, modifiers);
      break;
    }
  return true;
}

/// A button acts on release: the screen keeps a pointer to the widget that was pressed.
void FormPanel::release(const Point& at) {
  scroll_.release();
  const std::size_t stop = button_at(at), pressed = std::exchange(pressed_, 0);
  if (stop != 0 && stop == pressed) stop == ok_tab_stop() ? accept() : cancel();
}

std::size_t FormPanel::button_at(const Point& at) const {
  if (ok_rect().contains(at)) return ok_tab_stop();
  return !is_message() && cancel_rect().contains(at) ? cancel_tab_stop() : 0;
}

void FormPanel::press_line(const FormLine& line, const Point& at, int modifiers) {
  const std::size_t field = line.field;
  if (is_text_field(field)) {
    if (focus_ == field) {
      editor_.move_to(character_at(to_panel(line.box), at.x), (modifiers & GLFW_MOD_SHIFT) != 0);
    } else {
      set_focus_to(field);
    }
    return;
  }
  if (focus_ != field) set_focus_to(field);
  if (model_.fields()[field].kind == FieldKind::Flag) {
    choose(field, 0);
    return;
  }
  const std::vector<ScreenRect> choices = line.choices;  // a copy: choosing changes the layout
  for (std::size_t i = 0; i < choices.size(); ++i)
    if (to_panel(choices[i]).contains(at)) {
      choose(field, i);
      return;
    }
}

void FormPanel::drag(const Point& at) {
  const FormLine* line = is_text_field(focus_) ? layout_.line_of(focus_) : nullptr;
  if (scroll_.drag(at) || line == nullptr) return;
  const ScreenRect box = to_panel(line->box);
  if (box.contains(at)) editor_.move_to(character_at(box, at.x), true);
}

bool FormPanel::wheel(const Point& /*at*/, double steps) {
  scroll_.wheel(steps);
  return true;
}

bool FormPanel::key(int key, int modifiers) {
  if (key == GLFW_KEY_ESCAPE) {
    cancel();
  } else if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) {
    focus_ == cancel_tab_stop() ? cancel() : accept();
  } else if (!move_focus(key, modifiers)) {
    is_text_field(focus_) ? handle_text_key(key, modifiers) : choose_by_key(key);
  }
  return true;
}

bool FormPanel::move_focus(int key, int modifiers) {
  const double page = content().height - 40;
  if (is_message() && (key == GLFW_KEY_UP || key == GLFW_KEY_DOWN)) {
    scroll_.by(key == GLFW_KEY_UP ? -40 : 40);
    return true;
  }
  const bool back = (modifiers & GLFW_MOD_SHIFT) != 0;
  return run_key(key, {{{GLFW_KEY_TAB}, [&] { move_focus_by(back ? -1 : 1); }},
                       {{GLFW_KEY_DOWN}, [&] { move_focus_by(1); }},
                       {{GLFW_KEY_UP}, [&] { move_focus_by(-1); }},
                       {{GLFW_KEY_PAGE_DOWN}, [&] { scroll_.by(page); }},
                       {{GLFW_KEY_PAGE_UP}, [&] { scroll_.by(-page); }}});
}

void FormPanel::handle_text_key(int key, int modifiers) {
  const bool select = (modifiers & GLFW_MOD_SHIFT) != 0;
  if ((modifiers & GLFW_MOD_CONTROL) != 0) return handle_control_key(key);
  if (key == GLFW_KEY_LEFT || key == GLFW_KEY_RIGHT)
    editor_.move(key == GLFW_KEY_LEFT ? -1 : 1, select);
  if (key == GLFW_KEY_HOME) editor_.move_to_begin(select);
  if (key == GLFW_KEY_END) editor_.move_to_end(select);
  if (key == GLFW_KEY_BACKSPACE) editor_.erase_backward();
  if (key == GLFW_KEY_DELETE) editor_.erase_forward();
  if (key == GLFW_KEY_BACKSPACE || key == GLFW_KEY_DELETE) edited();
}

void FormPanel::handle_control_key(int key) {
  GLFWwindow* const window = screen()->glfwWindow();
  if (key == GLFW_KEY_A) editor_.select_all();
  if ((key == GLFW_KEY_C || key == GLFW_KEY_X) && !editor_.selected().empty())
    glfwSetClipboardString(window, editor_.selected().c_str());
  if (key == GLFW_KEY_X && !editor_.selected().empty()) {
    editor_.erase_backward();
    edited();
  }
  if (key == GLFW_KEY_V) {
    const char* const text = glfwGetClipboardString(window);
    if (text != nullptr) editor_.insert(text);
    edited();
  }
}

void FormPanel::choose_by_key(int key) {
  if (focus_ >= model_.fields().size()) {
    if (key == GLFW_KEY_SPACE) focus_ == ok_tab_stop() ? accept() : cancel();
    if (!is_message() && (key == GLFW_KEY_LEFT || key == GLFW_KEY_RIGHT))
      focus_ = focus_ == ok_tab_stop() ? cancel_tab_stop() : ok_tab_stop();
    return;
  }
  const FormField& field = model_.fields()[focus_];
  const std::size_t count = std::max<std::size_t>(1, field.choices.size());
  if (key == GLFW_KEY_SPACE) {
    choose(focus_, choice_);
  } else if (key == GLFW_KEY_RIGHT || key == GLFW_KEY_LEFT) {
    choice_ = (choice_ + (key == GLFW_KEY_RIGHT ? 1 : count - 1)) % count;
    if (field.kind == FieldKind::Choice) choose(focus_, choice_);
  }
}

bool FormPanel::keyboardCharacterEvent(unsigned int code_point) {
  if (!is_text_field(focus_)) return true;
  editor_.insert(utf8_of(code_point));
  edited();
  return true;
}

namespace {

/// A modal window that contains a form.
class FormDialog : public nanogui::Window {
 public:
  FormDialog(nanogui::Screen& screen, FormDescription description)
      : Window(&screen, ""),
        panel_(new FormPanel(this, std::move(description), [this] { dispose(); })) {
    setModal(true);
    setId("form");
  }

  void draw(NVGcontext* ctx) override {
    performLayout(ctx);
    Widget::draw(ctx);  // NOLINT(bugprone-parent-virtual-call): without the frame of a Window
  }
  nanogui::Vector2i preferredSize(NVGcontext*) const override { return panel_->size(); }
  void performLayout(NVGcontext* ctx) override {
    const nanogui::Vector2i available = screen()->size();
    const nanogui::Vector2i old_size = panel_->size();
    panel_->fit(ctx, {available.x() - 40, available.y() - 60});
    panel_->setPosition({0, 0});
    if (panel_->size() == old_size) return;
    setSize(panel_->size());
    setPosition((available - size()) / 2);
  }
  bool keyboardEvent(int key, int scancode, int action, int modifiers) override {
    const nanogui::ref<FormDialog> self = this;  // the panel may close the dialog
    return panel_->keyboardEvent(key, scancode, action, modifiers);
  }
  bool keyboardCharacterEvent(unsigned int code_point) override {
    return panel_->keyboardCharacterEvent(code_point);
  }

 private:
  FormPanel* panel_;
};

}  // namespace

void open_form(nanogui::Screen& screen, FormDescription description) {
  auto* dialog = new FormDialog(screen, std::move(description));
  dialog->performLayout(screen.nvgContext());
  dialog->requestFocus();
}

}  // namespace slalom
