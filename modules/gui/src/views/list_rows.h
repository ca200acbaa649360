#pragma once

#include "widgets/scroll.h"

#include <slalom/studio/studio.h>
#include <slalom/studio/thumbnails.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

// Sizes of list rows, in pixels.
constexpr ListLines::Heights kLineHeights{56, 28};
constexpr double kRowMargin = 6;
constexpr int kThumbnailSize = 46;

/// The sort value of a row as text.
std::string value_text(const ListRow& row, const std::string& unit);

/// The rows of the active list: thumbnail, name, id, tags and sort value of each scenario, and
/// group headers. Draws only the visible rows.
///
/// Mouse: click, Ctrl+click and Shift+click select, wheel and scroll bar scroll; a click on a
/// header opens or closes the group. Keys: Up, Down, Page Up, Page Down, Home, End move to a
/// scenario and select it, with Shift the range up to it, with Ctrl without selecting; Space
/// toggles the selection (on a header: the group), Left and Right close and open the group, Ctrl+A
/// selects all, Escape none.
///
/// Parts: "row 3" (index in the view, from 0) and "group 2", which scroll into view when queried;
/// "bar".
class ListRows : public Element {
 public:
  ListRows(nanogui::Widget* parent, Studio& studio);
  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;

 protected:
  void paint(NVGcontext* ctx) override;
  bool press(const Point& at, int modifiers) override;
  void drag(const Point& at) override { scroll_.drag(at); }
  void release(const Point&) override { scroll_.release(); }
  void hover(const std::optional<Point>& at) override;
  bool wheel(const Point& at, double steps) override;
  bool key(int key, int modifiers) override;

 private:
  using Texture = std::optional<int>;  ///< NanoVG handle; none if it cannot be drawn
  ListDocument* document() const { return studio_.active(); }
  const ListLines& lines() const { return document()->lines(); }
  bool has_lines() const { return document() != nullptr && lines().size() > 0; }
  void documents_changed();
  void update_scroll() const;
  void bring_into_view(std::size_t line) const;
  void scroll_to_current();
  std::optional<std::size_t> line_at(const Point& at) const;
  ScreenRect line_rect(std::size_t line) const;
  std::size_t cursor_line() const;
  void go_to_line(std::size_t line, int modifiers);
  void select(std::size_t index, int modifiers);
  bool set_group_closed(bool closed);
  std::string row_text(std::size_t index) const;
  void upload_thumbnails(NVGcontext* ctx);
  void draw_group_header(NVGcontext* ctx, std::size_t line, std::size_t group) const;
  void draw_row(NVGcontext* ctx, std::size_t line, std::size_t index);
  void draw_thumbnail(NVGcontext* ctx, const ScreenRect& rect, const std::string& hash);

  Studio& studio_;
  ThumbnailMaker thumbnails_;
  mutable Scroll scroll_;
  std::optional<std::size_t> focused_group_;  ///< the group header with the cursor, if any
  std::optional<std::size_t> hovered_;
  std::string scrolled_to_;  ///< the scenario last scrolled to
  NVGcontext* context_ = nullptr;
  LruCache<Texture> textures_;
  std::vector<std::pair<std::string, Thumbnail>> pending_thumbnails_;  ///< not yet textures
  std::vector<std::string> missing_thumbnails_;
};

}  // namespace slalom
