#pragma once

#include <slalom/gui/element.h>
#include <slalom/gui/form_layout.h>
#include <slalom/gui/line_editor.h>

#include <functional>
#include <set>
#include <string>

namespace slalom {

/// Draws a form and lets the user fill it in; id "dialog". Parts: "field KEY", "choice KEY VALUE",
/// "ok" and "cancel"; those that are scrolled out of sight have no place.
///
/// Keys: Tab and Shift+Tab, Up and Down go from field to field, Enter accepts, Escape cancels,
/// Left, Right and Space choose, Page Up and Page Down (Up and Down in a message) scroll.
class FormPanel : public Element {
 public:
  /// `close` is called once, after the form was accepted or given up; nothing of the panel is used
  /// after it.
  FormPanel(nanogui::Widget* parent, FormDescription description, std::function<void()> close);

  FormModel& model() { return model_; }
  /// Takes the size that the fields need, no more than `most`.
  void fit(NVGcontext* ctx, const nanogui::Vector2i& most);
  /// Puts text into a field as if it were typed.
  void fill_in(const std::string& key, const std::string& text);
  void accept();  ///< or shows what is wrong
  void cancel();

  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;
  void draw(NVGcontext* ctx) override;
  bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override;
  bool mouseDragEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                      int modifiers) override;
  bool scrollEvent(const nanogui::Vector2i& p, const nanogui::Vector2f& rel) override;
  bool keyboardEvent(int key, int scancode, int action, int modifiers) override;
  bool keyboardCharacterEvent(unsigned int letter) override;

 private:
  ScreenRect content() const;  ///< where the fields are seen
  ScreenRect ok_rect() const;
  ScreenRect cancel_rect() const;
  ScreenRect on_panel(ScreenRect rect) const;  ///< from the layout's place to the panel's
  bool in_sight(const ScreenRect& rect) const;
  bool is_typed(std::size_t field) const;
  bool is_message() const { return model_.fields().empty(); }
  double content_height() const { return is_message() ? intro_height_ : layout_.height(); }
  void lay_out();  ///< anew, after fields came or went

  std::vector<std::size_t> stops() const;  ///< fields in order, then "cancel" and "ok"
  std::size_t cancel_stop() const { return model_.fields().size() + 1; }
  std::size_t ok_stop() const { return model_.fields().size() + 2; }
  void go_to(std::size_t stop);
  void go_on(int steps);
  void scroll_to(double top);
  void edited();
  void choose(std::size_t field, std::size_t choice);
  bool move_focus(int key, int modifiers);
  bool type(int key, int modifiers);
  bool type_with_clipboard(int key);
  bool choose_by_key(int key);
  std::size_t button_at(const ScreenRect& at) const;  ///< its stop, or 0
  void press(const ScreenRect& at, int modifiers);
  void press_line(const FormLine& line, const ScreenRect& at, int modifiers);
  std::size_t letter_at(const ScreenRect& box, double x) const;
  double text_offset(const ScreenRect& box) const;

  void draw_lines(NVGcontext* ctx) const;
  void draw_line(NVGcontext* ctx, const FormLine& line) const;
  void draw_box(NVGcontext* ctx, const FormLine& line, bool wrong) const;
  void draw_typed(NVGcontext* ctx, const ScreenRect& box) const;
  void draw_flag(NVGcontext* ctx, const FormLine& line) const;
  void draw_choices(NVGcontext* ctx, const FormLine& line) const;
  void draw_scroll_bar(NVGcontext* ctx) const;
  void draw_foot(NVGcontext* ctx) const;
  void draw_button(NVGcontext* ctx, const ScreenRect& rect, const std::string& label, bool focused,
                   bool main) const;

  FormModel model_;
  std::function<void()> close_;
  NVGcontext* context_ = nullptr;  ///< measures texts
  FormLayout layout_;
  std::size_t focus_ = 0;
  std::size_t pressed_ = 0;  ///< the button that the mouse holds, as a stop
  std::size_t choice_ = 0;   ///< of the field in focus, for the keyboard
  LineEditor editor_;        ///< of the field in focus
  std::set<std::size_t> touched_;
  std::string message_;
  double scroll_ = 0, intro_height_ = 0;
};

}  // namespace slalom
