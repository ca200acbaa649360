#pragma once

#include "widgets/element.h"
#include "widgets/line_editor.h"
#include "widgets/scroll.h"

#include <slalom/studio/form.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace slalom {

/// Position of a field of a form, in pixels from the top of the fields.
struct FormLine {
  std::size_t field = 0;
  double top = 0, height = 0;
  ScreenRect label, box, unit;
  ScreenRect help;                  ///< of zero width where there is no space for it
  std::vector<ScreenRect> choices;  ///< one per choice of the field
};

/// Layout of the visible fields, one below the other: label, box, unit and help in one row; choices
/// and wide boxes use the full width, with their help below.
class FormLayout {
 public:
  static constexpr double kMargin = 16;  ///< pixels, at the left and right
  using Measure = std::function<double(const std::string& text, float size)>;
  FormLayout(const FormModel& form, double width, const Measure& measure);

  const std::vector<FormLine>& lines() const { return lines_; }
  const FormLine* line_of(std::size_t field) const;  ///< null when the field is hidden
  double height() const { return height_; }

  /// The width (pixels) that the fields of the form need.
  static double preferred_width(const FormDescription& form);

 private:
  void lay_out_row(FormLine& line) const;
  void lay_out_wide(const FormField& field, FormLine& line) const;
  void lay_out_choices(const FormField& field, const Measure& measure, FormLine& line) const;

  double width_ = 0, height_ = 0;
  std::vector<FormLine> lines_;
};

/// Draws a form and handles its input; id "dialog". Parts: "field KEY", "choice KEY VALUE", "ok"
/// and "cancel"; parts that are scrolled out of view have no rectangle.
///
/// Keys: Tab and Shift+Tab, Up and Down move between fields, Enter accepts, Escape cancels, Left,
/// Right and Space choose, Page Up and Page Down (Up and Down in a message) scroll.
class FormPanel : public Element {
 public:
  /// `close` is called once, after the form was accepted or canceled; the panel is not used
  /// afterwards.
  FormPanel(nanogui::Widget* parent, FormDescription description, std::function<void()> close);

  /// Resizes the panel to its fields, at most to `max_size`.
  void fit(NVGcontext* ctx, const nanogui::Vector2i& max_size);
  void accept();  ///< or shows the first error
  void cancel();

  std::string text() const override;
  bool keyboardCharacterEvent(unsigned int code_point) override;

 protected:
  std::vector<Part> parts() const override;
  void paint(NVGcontext* ctx) override;
  bool press(const Point& at, int modifiers) override;
  void release(const Point& at) override;
  void drag(const Point& at) override;
  bool wheel(const Point& at, double steps) override;
  bool key(int key, int modifiers) override;

 private:
  static constexpr double kMargin = FormLayout::kMargin, kTitleHeight = 44;  ///< pixels
  /// With space for an error message above the buttons.
  double footer_height() const { return is_message() ? 56 : 96; }
  ScreenRect content() const;  ///< the visible area of the fields
  ScreenRect ok_rect() const;
  ScreenRect cancel_rect() const;
  ScreenRect to_panel(ScreenRect rect) const;  ///< from layout to panel coordinates
  bool is_in_view(const ScreenRect& rect) const;
  bool is_text_field(std::size_t field) const;
  bool is_message() const { return model_.fields().empty(); }
  void lay_out();  ///< after fields were shown or hidden

  std::vector<std::size_t> tab_stops() const;  ///< the fields in order, "cancel" and "ok"
  std::size_t cancel_tab_stop() const { return model_.fields().size() + 1; }
  std::size_t ok_tab_stop() const { return model_.fields().size() + 2; }
  void set_focus_to(std::size_t stop);
  void move_focus_by(int steps);
  void edited();
  void choose(std::size_t field, std::size_t choice);
  bool move_focus(int key, int modifiers);
  void handle_text_key(int key, int modifiers);
  void handle_control_key(int key);
  void choose_by_key(int key);
  std::size_t button_at(const Point& at) const;  ///< its tab stop, or 0
  void press_line(const FormLine& line, const Point& at, int modifiers);
  std::size_t character_at(const ScreenRect& box, double x) const;
  double text_offset(const ScreenRect& box) const;
  std::string error_of(std::size_t field) const;  ///< empty before the field was touched

  void draw_line(NVGcontext* ctx, const FormLine& line) const;
  void draw_box(NVGcontext* ctx, const FormLine& line, bool invalid) const;
  void draw_edited_text(NVGcontext* ctx, const ScreenRect& box) const;
  void draw_footer(NVGcontext* ctx) const;

  FormModel model_;
  std::function<void()> close_;
  NVGcontext* context_ = nullptr;  ///< to measure texts
  FormLayout layout_;
  std::size_t focus_ = 0;
  std::size_t pressed_ = 0;  ///< tab stop of the button that is held down
  std::size_t choice_ = 0;   ///< of the focused field, for the keyboard
  LineEditor editor_;        ///< of the focused field
  std::set<std::size_t> touched_;
  std::string message_;
  Scroll scroll_;
  double intro_height_ = 0;
};

/// Shows a modal form in the center of the screen, with the focus on its first field. The form
/// closes itself.
void open_form(nanogui::Screen& screen, FormDescription description);

}  // namespace slalom
