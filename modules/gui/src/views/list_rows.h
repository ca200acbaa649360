#pragma once

#include "widgets/table.h"

#include <slalom/studio/studio.h>
#include <slalom/studio/thumbnails.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// The rows of the active list: thumbnail, name, id, tags and sort value of each scenario, and
/// group headers.
///
/// Mouse: click, Ctrl+click and Shift+click select, wheel and scroll bar scroll; a click on a
/// header opens or closes the group. Keys: Up, Down, Page Up, Page Down, Home, End move to a
/// scenario and select it, with Shift the range up to it, with Ctrl without selecting; Space
/// toggles the selection (on a header: the group), Left and Right close and open the group, Ctrl+A
/// selects all, Escape none.
///
/// Parts: "row 3" (index in the view, from 0) and "group 2", which scroll into view when queried.
class ListRows : public Table {
 public:
  ListRows(nanogui::Widget* parent, Studio& studio);
  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;

 protected:
  std::size_t row_count() const override { return document() ? lines().size() : 0; }
  std::size_t cursor() const override;
  void set_cursor(std::size_t line, int modifiers) override;
  void choose(std::size_t line, int modifiers) override;
  void paint_row(NVGcontext* ctx, std::size_t line, const ScreenRect& rect) override;
  double top_of(std::size_t line) const override { return lines().top_of(line, kLineHeights); }
  std::size_t row_at_offset(double y) const override { return lines().line_at(y, kLineHeights); }
  void paint(NVGcontext* ctx) override;
  void hover(const std::optional<Point>& at) override;
  bool key(int key, int modifiers) override;

 private:
  static constexpr ListLines::Heights kLineHeights{56, 28};  ///< pixels
  using Texture = std::optional<int>;  ///< NanoVG handle; none if it cannot be drawn
  ListDocument* document() const { return studio_.active(); }
  const ListLines& lines() const { return document()->lines(); }
  void documents_changed();
  void scroll_to_current();
  void select(std::size_t index, int modifiers);
  bool set_group_closed(bool closed);
  std::string row_text(std::size_t index) const;
  void upload_thumbnails(NVGcontext* ctx);
  void draw_group_header(NVGcontext* ctx, const ScreenRect& rect, std::size_t group) const;
  void draw_thumbnail(NVGcontext* ctx, const ScreenRect& rect, const std::string& hash);

  Studio& studio_;
  ThumbnailMaker thumbnails_;
  std::optional<std::size_t> focused_group_;  ///< the group header with the cursor, if any
  std::string scrolled_to_;                   ///< the scenario last scrolled to
  NVGcontext* context_ = nullptr;
  LruCache<Texture> textures_;
  std::vector<std::pair<std::string, Thumbnail>> pending_thumbnails_;  ///< not yet textures
  std::vector<std::string> missing_thumbnails_;
};

}  // namespace slalom
