#pragma once

#include <slalom/gui/element.h>
#include <slalom/gui/list_choices.h>
#include <slalom/gui/list_rows.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

class Jobs;

/// The open lists: a tab for each, and of the one before the others what is shown of it: filter,
/// sorting, groups, rows, and how many are selected and shown.
///
/// Keys besides those of ListRows: F (filter), S (sort by), D (direction), G (groups), Ctrl+Page
/// Up, Ctrl+Page Down (the tab beside).
///
/// Parts: "tab 0", "close 0", "sort", "direction", "group_by", and those of ListRows. Its elements
/// have the ids "filter", "rows" and, while one chooses, "choices".
class ListPanel : public Element {
 public:
  /// Thumbnails are made by `jobs`.
  ListPanel(nanogui::Widget* parent, Jobs& jobs);

  std::function<void(std::size_t tab)> on_tab, on_close_tab;
  std::function<void()> on_show;  ///< the current scenario is to be looked at

  /// The open lists and which of them is before the others.
  void set_documents(std::vector<ListDocument*> documents, std::size_t active);
  ListRows& rows() { return *rows_; }
  void edit_filter();  ///< gives it the keyboard
  void choose_sort();  ///< by which field: opens the choices
  void choose_group();

  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;
  void performLayout(NVGcontext* ctx) override;
  void draw(NVGcontext* ctx) override;
  bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override;
  bool mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                        int modifiers) override;
  bool keyboardEvent(int key, int scancode, int action, int modifiers) override;

 private:
  ListDocument* document() const;
  std::string message() const;  ///< under the filter; empty for none
  std::string foot() const;
  std::string sort_text() const;
  std::string group_text() const;
  void turn_direction();
  void arrange();
  std::size_t tabs_seen() const;
  std::optional<ScreenRect> tab_rect(std::size_t tab) const;
  bool press(const std::string& part);
  std::vector<std::string> shown_parts() const;
  double draw_message(NVGcontext* ctx);  ///< returns its height
  ScreenRect message_rect() const;
  void draw_tab(NVGcontext* ctx, std::size_t tab) const;
  void draw_control(NVGcontext* ctx, const std::string& part, const std::string& text) const;
  void draw_direction(NVGcontext* ctx) const;

  std::vector<ListDocument*> documents_;
  std::size_t active_ = 0;
  mutable std::size_t first_tab_ = 0;
  std::string hovered_;  ///< part below the mouse
  double message_height_ = 0, message_width_ = 0;
  std::string message_, message_shown_;  ///< whole and as it fits
  std::string filter_shown_;  ///< what the filter of the document was when it was last looked at
  ThumbnailMaker thumbnails_;
  nanogui::TextBox* filter_;
  ListRows* rows_;
  ListChoices* choices_;
};

}  // namespace slalom
