// SPDX-License-Identifier: BSD-3-Clause
#include "views/folder_table.h"
#include "views/form_layout.h"
#include "views/form_panel.h"
#include "widgets/drawing.h"
#include "widgets/line_editor.h"
#include "widgets/table.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace slalom {
namespace {

constexpr double kButtonWidth = 120;  // pixels
constexpr float kHelpSize = 14;

/// Draws at most two lines, vertically centered in `rect`.
void draw_two_lines(NVGcontext* ctx, const ScreenRect& rect, const std::string& text,
                    const Color& color) {
  draw::text_width(ctx, text, kHelpSize);  // sets the font
  NVGtextRow rows[2];
  const int count =
      nvgTextBreakLines(ctx, text.c_str(), nullptr, static_cast<float>(rect.width), rows, 2);
  const double height = 18;
  double top = rect.top + 0.5 * (rect.height - count * height);
  for (int i = 0; i < count; ++i, top += height) {
    const bool last = i == 1;
    draw::text(ctx, {rect.left, top, rect.width, height},
               last ? std::string(rows[i].start) : std::string(rows[i].start, rows[i].end), color,
               kHelpSize);
  }
}

/// Draws a form and handles its input; id "dialog". Parts: "field KEY", "choice KEY VALUE", "ok"
/// and "cancel"; parts that are scrolled out of view have no rectangle. The table of a folder is
/// below the path field that had the focus last, or below the only one.
///
/// Keys: those of FolderTable in its field; Tab and Shift+Tab, Up and Down move between fields,
/// Enter accepts, Escape cancels, Left, Right and Space choose, Page Up and Page Down (Up and Down
/// in a message) scroll.
class FormPanel : public Element {
 public:
  FormPanel(nanogui::Widget* parent, FormDescription description, std::function<void()> close)
      : Element(parent, "dialog"),
        model_(std::move(description)),
        close_(std::move(close)),
        layout_(model_, 0, [](const std::string&, float) { return 0; }),
        folder_(new FolderTable(this, [this](const FolderEntry& entry) { choose_entry(entry); })) {
    set_focus_to(tab_stops().front());
  }

  /// Resizes the panel to its fields, at most to `max_size`.
  void fit(NVGcontext* ctx, const nanogui::Vector2i& max_size) {
    context_ = ctx;
    const FormDescription& form = model_.description();
    const double width = std::min<double>(FormLayout::preferred_width(form), max_size.x());
    intro_height_ = form.intro.empty() ? 0
                    : has_columns()    ? draw::two_columns_height(form.intro)
                                       : draw::wrapped_height(ctx, form.intro, width - 2 * kMargin);
    if (intro_height_ > 0) intro_height_ += 10;
    setWidth(static_cast<int>(width));
    lay_out();
    const double preferred = kTitleHeight + intro_height_ + layout_.height() + footer_height();
    // The dialog only grows, so that it does not jump when fields are shown or hidden.
    setHeight(std::max(height(), static_cast<int>(std::min<double>(preferred + 1, max_size.y()))));
    setHeight(std::min(height(), max_size.y()));
    setFixedSize(size());
    scroll_.set(is_message() ? intro_height_ : layout_.height(), content());
    place_folder();
  }
  /// Sorted by name, so that the order of the files has no effect. They replace a folder that is
  /// browsed; a field for several keeps its other paths.
  void drop(std::vector<std::string> files) {
    const auto field = browsed();
    if (!field || files.empty()) return;
    const FormField& into = model_.fields()[*field];
    if (!into.several && files.size() > 1) {
      message_ = into.label + ": " + count_text(files.size(), "file") + " dropped; expected one";
      return;
    }
    std::sort(files.begin(), files.end());
    const std::string path = path_in(*field);
    const bool keeps = into.several && !path.empty() && !ends_with(path, "/");
    put_path(*field, (keeps ? path + ", " : "") + join(files, ", "));
  }
  /// Closes the form, or shows the first error.
  void accept() {
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
  void cancel() {
    const auto close = std::exchange(close_, nullptr);
    if (close) close();
  }

  std::string text() const override {
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
  bool keyboardCharacterEvent(unsigned int code_point) override {
    if (!is_text_field(focus_)) return true;
    editor_.insert(utf8_of(code_point));
    edited();
    return true;
  }

 protected:
  std::vector<Part> parts() const override {
    std::vector<Part> all = {{"ok", ok_rect()}};
    if (has_cancel()) all.push_back({"cancel", cancel_rect()});
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
  void paint(NVGcontext* ctx) override {
    const ScreenRect all = area(), visible = content();
    const FormDescription& form = model_.description();
    draw::fill(ctx, all, palette().panel, 5);
    draw::frame(ctx, all, palette().border);
    draw::text(ctx, {kMargin, 4, all.width - 2 * kMargin, kTitleHeight - 8}, form.title,
               palette().text, 18, draw::Align::Left, true);
    if (!form.intro.empty() && !is_message())
      draw::wrapped_text(ctx, {kMargin, kTitleHeight, all.width - 2 * kMargin, intro_height_},
                         form.intro, palette().faint_text);
    nvgSave(ctx);
    draw::clip(ctx, visible);
    const ScreenRect message = to_panel({kMargin, 0, visible.width - 2 * kMargin, intro_height_});
    if (is_message() && has_columns())
      draw::two_columns(ctx, message, form.intro, palette().text);
    else if (is_message())
      draw::wrapped_text(ctx, message, form.intro, palette().text);
    for (const FormLine& line : layout_.lines()) {
      const double top = line.top - scroll_.offset();
      if (top + line.height > 0 && top < visible.height) draw_line(ctx, line);
    }
    scroll_.draw(ctx);
    nvgRestore(ctx);
    draw_footer(ctx);
  }
  bool press(const Point& at, int modifiers) override {
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
  void release(const Point& at) override {
    scroll_.release();
    const std::size_t stop = button_at(at), pressed = std::exchange(pressed_, 0);
    if (stop != 0 && stop == pressed) stop == ok_tab_stop() ? accept() : cancel();
  }
  void drag(const Point& at) override {
    const FormLine* line = is_text_field(focus_) ? layout_.line_of(focus_) : nullptr;
    if (scroll_.drag(at) || line == nullptr) return;
    const ScreenRect box = to_panel(line->box);
    if (box.contains(at)) editor_.click(context_, box, at.x, true);
  }
  bool wheel(const Point& /*at*/, double steps) override {
    scroll_.wheel(steps);
    return true;
  }
  bool key(int key, int modifiers) override {
    if (focus_ == browsed() && folder_->key(key, modifiers)) return true;
    if (key == GLFW_KEY_ESCAPE) {
      cancel();
    } else if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) {
      focus_ == cancel_tab_stop() ? cancel() : accept();
    } else if (!move_focus(key, modifiers)) {
      if (!is_text_field(focus_)) return choose_by_key(key), true;
      if (editor_.key(key, modifiers, *this)) edited();
    }
    return true;
  }

 private:
  static constexpr double kMargin = FormLayout::kMargin, kTitleHeight = 44;  ///< pixels
  /// With space for an error message above the buttons.
  double footer_height() const { return has_cancel() ? 96 : 56; }
  /// The visible area of the fields.
  ScreenRect content() const {
    const double top = kTitleHeight + (is_message() ? 0 : intro_height_);
    const double bottom = height() - footer_height();
    return {0, top, static_cast<double>(width()), std::max(0.0, bottom - top)};
  }
  ScreenRect ok_rect() const {
    return {width() - kMargin - kButtonWidth, height() - 44.0, kButtonWidth, 32};
  }
  ScreenRect cancel_rect() const {
    return {width() - kMargin - 2 * kButtonWidth - 10, height() - 44.0, kButtonWidth, 32};
  }
  /// From layout to panel coordinates.
  ScreenRect to_panel(ScreenRect rect) const {
    rect.top += content().top - scroll_.offset();
    return rect;
  }
  bool is_in_view(const ScreenRect& rect) const {
    const ScreenRect shown = to_panel(rect);
    return shown.top >= content().top && shown.bottom() <= content().bottom();
  }
  bool is_text_field(std::size_t field) const {
    if (field >= model_.fields().size()) return false;
    const FieldKind kind = model_.fields()[field].kind;
    return kind == FieldKind::Text || kind == FieldKind::Number || kind == FieldKind::Integer;
  }
  bool is_message() const { return model_.fields().empty(); }
  bool has_cancel() const { return !is_message() || model_.description().accepted; }
  bool has_columns() const {
    return is_message() && model_.description().intro.find('\t') != std::string::npos;
  }
  /// After fields were shown or hidden.
  void lay_out() {
    if (context_ == nullptr) return;
    const auto measure = [this](const std::string& text, float size) {
      return draw::text_width(context_, text, size);
    };
    layout_ = FormLayout(model_, width(), measure, browsed());
    scroll_.set(is_message() ? intro_height_ : layout_.height(), content());
  }

  /// The fields in order, "cancel" and "ok".
  std::vector<std::size_t> tab_stops() const {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < model_.fields().size(); ++i)
      if (model_.is_shown(i) && model_.fields()[i].kind != FieldKind::Heading) all.push_back(i);
    if (has_cancel()) all.push_back(cancel_tab_stop());
    all.push_back(ok_tab_stop());
    return all;
  }
  std::size_t cancel_tab_stop() const { return model_.fields().size() + 1; }
  std::size_t ok_tab_stop() const { return model_.fields().size() + 2; }
  void set_focus_to(std::size_t stop) {
    focus_ = stop;
    choice_ = 0;
    if (stop >= model_.fields().size()) return;
    browse();
    editor_.set_text(model_.value(stop));
    editor_.select_all();
    const auto& choices = model_.fields()[stop].choices;
    for (std::size_t i = choices.size(); i-- > 0;)
      if (model_.is_chosen(stop, choices[i])) choice_ = i;
    lay_out();
    if (const FormLine* line = context_ == nullptr ? nullptr : layout_.line_of(stop))
      scroll_.show(line->top, line->top + line->height);
  }
  void move_focus_by(int steps) {
    const auto all = tab_stops();
    const int count = static_cast<int>(all.size());
    const int at = static_cast<int>(std::find(all.begin(), all.end(), focus_) - all.begin());
    set_focus_to(all[static_cast<std::size_t>(((at % count) + steps + count) % count)]);
  }
  void edited() {
    model_.set_value(focus_, editor_.text());
    touched_.insert(focus_);
    message_.clear();
    browse();
  }

  bool is_path(std::size_t field) const {
    return field < model_.fields().size() && !model_.fields()[field].extensions.empty() &&
           model_.is_shown(field);
  }
  /// The field whose folder is shown: the last one that had the focus, or the only one.
  std::optional<std::size_t> browsed() const {
    if (last_path_ && is_path(*last_path_)) return last_path_;
    std::optional<std::size_t> only;
    for (std::size_t i = 0; i < model_.fields().size(); ++i) {
      if (!is_path(i)) continue;
      if (only) return std::nullopt;
      only = i;
    }
    return only;
  }
  /// The beginning in the field's text of the path whose folder is shown.
  std::size_t begin_of_path(std::size_t field) const {
    return model_.fields()[field].several ? begin_of_last_path(model_.value(field)) : 0;
  }
  std::string path_in(std::size_t field) const {
    return model_.value(field).substr(begin_of_path(field));
  }
  void browse() {
    if (is_path(focus_)) last_path_ = focus_;
    const auto field = browsed();
    if (field) folder_->show_folder(folder_of(path_in(*field)), model_.fields()[*field].extensions);
  }
  void choose_entry(const FolderEntry& entry) {
    if (const auto field = browsed()) put_path(*field, path_to_entry(path_in(*field), entry));
  }
  /// Replaces the path that is browsed. The text is not selected, so that typing continues it.
  void put_path(std::size_t field, const std::string& path) {
    const std::string text = model_.value(field).substr(0, begin_of_path(field)) + path;
    set_focus_to(field);
    editor_.set_text(text);
    edited();
  }
  /// Shows as much of the table as is not scrolled out of view.
  void place_folder() {
    const auto field = browsed();
    const FormLine* line = field ? layout_.line_of(*field) : nullptr;
    ScreenRect rect = line == nullptr ? ScreenRect{} : to_panel(line->folder);
    const double bottom = std::min(rect.bottom(), content().bottom());
    rect.top = std::max(rect.top, content().top);
    rect.height = bottom - rect.top;
    folder_->set_bounds(rect);
    folder_->setVisible(rect.height > FolderTable::kMinHeight);
  }
  void choose(std::size_t field, std::size_t choice) {
    const auto& choices = model_.fields()[field].choices;
    model_.choose(field, choice < choices.size() ? choices[choice] : "");
    choice_ = choice;
    touched_.insert(field);
    message_.clear();
    browse();
    lay_out();
  }
  bool move_focus(int key, int modifiers) {
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
  void choose_by_key(int key) {
    if (focus_ >= model_.fields().size()) {
      if (key == GLFW_KEY_SPACE) focus_ == ok_tab_stop() ? accept() : cancel();
      if (has_cancel() && (key == GLFW_KEY_LEFT || key == GLFW_KEY_RIGHT))
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
  /// Its tab stop, or 0.
  std::size_t button_at(const Point& at) const {
    if (ok_rect().contains(at)) return ok_tab_stop();
    return has_cancel() && cancel_rect().contains(at) ? cancel_tab_stop() : 0;
  }
  void press_line(const FormLine& pressed, const Point& at, int modifiers) {
    const FormLine line = pressed;  // a copy: the focus and choices change the layout
    const std::size_t field = line.field;
    if (is_text_field(field)) {
      if (focus_ == field) {
        editor_.click(context_, to_panel(line.box), at.x, (modifiers & GLFW_MOD_SHIFT) != 0);
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
    for (std::size_t i = 0; i < line.choices.size(); ++i)
      if (to_panel(line.choices[i]).contains(at)) {
        choose(field, i);
        return;
      }
  }
  /// Empty before the field was touched.
  std::string error_of(std::size_t field) const {
    return touched_.count(field) > 0 ? model_.error_of(field) : "";
  }

  void draw_line(NVGcontext* ctx, const FormLine& line) const {
    const FormField& field = model_.fields()[line.field];
    const bool heading = field.kind == FieldKind::Heading;
    draw::text(ctx, to_panel(line.label), field.label, palette().text, draw::kTextSize,
               draw::Align::Left, heading);
    if (heading) return;
    const std::string error = error_of(line.field);
    const bool focused = focus_ == line.field;
    if (field.kind == FieldKind::Flag) {
      const ScreenRect box = to_panel(line.box);
      const bool set = model_.value(line.field) == "true";
      draw::check_box(ctx, box, set, focused);
      draw::text(ctx, {box.left + 28, box.top, 100, box.height}, set ? "yes" : "no",
                 palette().text);
    } else if (is_text_field(line.field)) {
      draw_box(ctx, line, !error.empty());
    }
    for (std::size_t i = 0; i < line.choices.size(); ++i)
      draw::button(
          ctx, to_panel(line.choices[i]), field.choices[i],
          {model_.is_chosen(line.field, field.choices[i]), true, false, focused && choice_ == i});
    draw::text(ctx, to_panel(line.unit), field.unit, palette().faint_text);
    if (line.help.width <= 0) return;  // the footer shows the error
    draw_two_lines(ctx, to_panel(line.help), error.empty() ? field.help : error,
                   error.empty() ? palette().faint_text : palette().error_text);
  }
  void draw_box(NVGcontext* ctx, const FormLine& line, bool invalid) const {
    const ScreenRect box = to_panel(line.box);
    const bool focused = focus_ == line.field;
    draw::fill(ctx, box, palette().window, 3);
    draw::frame(ctx, box,
                invalid   ? palette().error_text
                : focused ? palette().accent
                          : palette().border);
    if (focused) return editor_.draw(ctx, box);
    draw::text(ctx, box.inset(LineEditor::kInset), model_.value(line.field), palette().text);
  }
  void draw_footer(NVGcontext* ctx) const {
    const double top = height() - footer_height();
    draw::line(ctx, 1, top + 0.5, width() - 1, top + 0.5, palette().border);
    draw_two_lines(ctx, {kMargin, top + 6, width() - 2 * kMargin, 38}, message_,
                   palette().error_text);
    if (has_cancel())
      draw::button(ctx, cancel_rect(), "Cancel", {false, true, false, focus_ == cancel_tab_stop()});
    draw::button(ctx, ok_rect(), model_.description().accept,
                 {true, true, false, focus_ == ok_tab_stop()});
  }

  FormModel model_;
  std::function<void()> close_;
  NVGcontext* context_ = nullptr;  ///< to measure texts
  FormLayout layout_;
  FolderTable* folder_;
  std::optional<std::size_t> last_path_;  ///< the path field that had the focus last
  std::size_t focus_ = 0;
  std::size_t pressed_ = 0;  ///< tab stop of the button that is held down
  std::size_t choice_ = 0;   ///< of the focused field, for the keyboard
  LineEditor editor_;        ///< of the focused field
  std::set<std::size_t> touched_;
  std::string message_;
  Scroll scroll_;
  double intro_height_ = 0;
};

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
  void drop(const std::vector<std::string>& files) { panel_->drop(files); }
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

Element* make_form_panel(nanogui::Widget* parent, FormDescription description,
                         std::function<void()> close) {
  return new FormPanel(parent, std::move(description), std::move(close));
}

void open_form(nanogui::Screen& screen, FormDescription description) {
  auto* dialog = new FormDialog(screen, std::move(description));
  dialog->performLayout(screen.nvgContext());
  dialog->requestFocus();
}

void drop_into_form(nanogui::Screen& screen, const std::vector<std::string>& files) {
  for (auto child = screen.children().rbegin(); child != screen.children().rend(); ++child)
    if (auto* dialog = dynamic_cast<FormDialog*>(*child)) return dialog->drop(files);
}

}  // namespace slalom
