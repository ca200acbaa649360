#pragma once

#include "views/list_rows.h"
#include "widgets/menu.h"

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The open lists: a tab for each, and filter, sorting, groups, rows and counts of the active list.
///
/// Keys besides those of ListRows: F (filter), S (sort by), D (direction), G (groups), Ctrl+Page
/// Up, Ctrl+Page Down (previous and next tab).
///
/// Parts: "tab 0", "close 0", "sort", "direction", "group_by", and those of ListRows. Its elements
/// have the ids "filter", "rows" and, while a drop-down list is open, "choices".
class ListPanel : public Element {
 public:
  ListPanel(nanogui::Widget* parent, Studio& studio);
  void choose_sort();  ///< opens the sort fields
  void choose_group();
  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;
  void performLayout(NVGcontext* ctx) override;

 protected:
  std::vector<Part> parts() const override;
  void paint(NVGcontext* ctx) override;
  bool press(const Point& at, int modifiers) override;
  void hover(const std::optional<Point>& at) override;
  bool key(int key, int modifiers) override;

 private:
  ListDocument* document() const { return studio_.active(); }
  std::string message() const;  ///< below the filter; empty for none
  std::string footer_text() const;
  std::string sort_text() const;
  std::string group_text() const;
  void open_choices(const std::string& part, const std::vector<std::string>& choices,
                    const std::string& current, Menu::Chosen chosen);
  void documents_changed();
  void arrange();
  std::size_t visible_tab_count() const;
  void show_tab(std::size_t tab) const;
  bool activate(const std::string& part);
  double draw_message(NVGcontext* ctx);  ///< returns its height
  ScreenRect message_rect() const;
  void draw_tab(NVGcontext* ctx, std::size_t tab) const;
  void draw_control(NVGcontext* ctx, const std::string& part, const std::string& text) const;
  void draw_direction(NVGcontext* ctx) const;

  Studio& studio_;
  mutable std::size_t first_tab_ = 0;
  std::string hovered_;  ///< part under the mouse
  double message_height_ = 0, message_width_ = 0;
  std::string message_, elided_message_;
  std::string shown_filter_;  ///< to notice when the filter of the document changes
  nanogui::TextBox* filter_;
  ListRows* rows_;
  Menu* choices_;
};

}  // namespace slalom
