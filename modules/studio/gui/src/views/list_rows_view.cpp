// SPDX-License-Identifier: BSD-3-Clause
#include "views/panels.h"
#include "widgets/drawing.h"
#include "widgets/table.h"

#include <slalom/core/text.h>
#include <slalom/studio/thumbnails.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace slalom {
namespace {

constexpr std::size_t kTextureMemory = 32 << 20;         // bytes; more if what is seen needs it
constexpr double kRowMargin = 6, kRowPicture = 46;       // pixels
constexpr double kRowHeight = 56, kHeaderHeight = 28;    // pixels
constexpr double kMinCellWidth = 104, kNameHeight = 20;  // pixels, of the grid
constexpr int kGridPicture = 2 * kThumbnailSize;         // pixels that are drawn

/// Parses the number after a prefix, as in "row 12".
std::optional<std::size_t> number_after(const std::string& prefix, const std::string& part) {
  long long number = 0;
  if (part.rfind(prefix, 0) != 0 || !parse_integer(part.substr(prefix.size()), number) ||
      number < 0)
    return std::nullopt;
  return static_cast<std::size_t>(number);
}

/// The sort value of a row.
std::string value_text(const ListRow& row, const std::string& unit) {
  if (!row.outcomes.empty()) return row.outcomes;
  if (!row.value) return "not computed";
  if (row.value->is_na()) return "NA";
  const std::string number = format_fixed(row.value->number(), 3);
  return unit == "-" ? number : number + " " + unit;
}

/// The rows of the active list: thumbnail, name, id, tags and sort value of each scenario, and
/// group headers; or a grid of larger pictures with names, the rest in their tooltips.
///
/// Mouse: click, Ctrl+click and Shift+click select, wheel and scroll bar scroll; a click on a
/// header opens or closes the group; the right button opens the menu of the scenario. Keys: Up,
/// Down, Page Up, Page Down, Home, End move to a scenario and select it, with Shift the range up to
/// it, with Ctrl without selecting; Space toggles the selection (on a header: the group), Left and
/// Right close and open the group, Ctrl+A selects all, Escape none. In a grid, Left and Right move
/// too, unless they close or open the group on whose header they are.
///
/// Parts: "row 3" (index in the view, from 0) and "group 2", which scroll into view when queried.
class ListRows : public Table {
 public:
  ListRows(nanogui::Widget* parent, Studio& studio)
      : Table(parent, "rows", {0, kRowHeight, 0}, Focus::OnPress),
        studio_(studio),
        thumbnails_(studio.jobs(),
                    [this](const std::string& hash, const Thumbnail& thumbnail) {
                      pending_thumbnails_.emplace_back(hash, thumbnail);
                    }),
        // Remaining textures are deleted with NanoVG's context, which the window destroys.
        textures_(0, [this](Texture& texture) {
          if (texture && context_ != nullptr) nvgDeleteImage(context_, *texture);
        }) {
    studio.events().observe({Change::Documents}, [this] { documents_changed(); });
    studio.events().observe({Change::CurrentRow}, [this] { scrolled_to_.clear(); });
    studio.set_reveal([this](std::size_t index) { return reveal(index); });
  }
  std::string text() const override {
    std::string text;
    for (const std::size_t line : visible_rows()) {
      const ListLines::Line item = lines().at(line);
      if (!text.empty()) text += "\n";
      if (item.group)
        text += "group " + std::to_string(*item.group) + ": " +
                document()->view().groups[*item.group].title + ", " +
                std::to_string(document()->view().groups[*item.group].count) +
                (lines().is_closed(*item.group) ? ", closed" : "");
      else
        text += row_text(item.index);
    }
    return text;
  }
  std::optional<ScreenRect> rect_of(const std::string& part) const override {
    if (document() == nullptr) return Table::rect_of(part);
    std::optional<std::size_t> line;
    if (const auto index = number_after("row ", part))
      line = *index < document()->view().hashes.size() ? lines().line_of(*index) : std::nullopt;
    else if (const auto group = number_after("group ", part))
      if (*group < document()->view().groups.size()) line = lines().line_of_group(*group);
    return line ? bring_into_view(*line) : Table::rect_of(part);
  }

 protected:
  std::size_t row_count() const override { return document() ? lines().size() : 0; }
  std::size_t cursor() const override {
    if (focused_group_ && *focused_group_ < document()->view().groups.size())
      return lines().line_of_group(*focused_group_);
    const auto index = document()->view().index_of(document()->current());
    if (!index) return 0;
    if (const auto line = lines().line_of(*index)) return *line;
    return lines().line_of_group(lines().group_of(*index).value_or(0));
  }
  void set_cursor(std::size_t line, int modifiers) override {
    const std::size_t index = lines().at(line).index;
    focused_group_ = lines().at(line).group;
    if (focused_group_) return;
    if (modifiers == GLFW_MOD_CONTROL)
      document()->set_current(document()->view().hashes[index]);
    else
      select(index, modifiers & GLFW_MOD_SHIFT);
    scrolled_to_ = document()->current();
  }
  void choose(std::size_t line, int modifiers) override {
    const std::size_t index = lines().at(line).index;
    focused_group_ = lines().at(line).group;
    focused_group_ ? document()->toggle_group(*focused_group_) : select(index, modifiers);
  }
  void paint_row(NVGcontext* ctx, std::size_t line, const ScreenRect& rect) override {
    const Palette& colors = palette();
    const auto [group, index] = lines().at(line);
    if (group) return draw_group_header(ctx, rect, *group);
    const std::string& hash = document()->view().hashes[index];
    const bool selected = document()->is_selected(index), current = hash == document()->current();
    draw::row(ctx, rect, studio_.grid() ? 0 : index, selected, hovered() == line);
    if (current) draw::fill(ctx, {rect.left, rect.top, 3, rect.height}, colors.accent);
    if (current && focused() && !focused_group_) draw::frame(ctx, rect, colors.accent);
    const ListRow* row = document()->row(hash);
    if (studio_.grid()) return draw_cell(ctx, rect, hash, row != nullptr ? row->entry.name : "");
    draw_thumbnail(ctx, {rect.left + kRowMargin, rect.top + 5, kRowPicture, kRowPicture}, hash);
    if (row == nullptr) return;
    const Color ink = selected ? colors.text : colors.faint_text;
    const double left = kRowMargin + kRowPicture + 8, right = rect.width - kRowMargin;
    const ScreenRect upper{left, rect.top + 6, right - left, 22};
    draw::text(ctx, upper, row->entry.name, colors.text, draw::kTextSize, draw::Align::Left,
               current);
    std::string more = row->entry.id;
    double text_width = right - left;
    const std::string& sort = document()->request().sort;
    if (!sort.empty() && sort != "name") {
      const std::string value = value_text(*row, document()->sort_unit());
      const double value_width = draw::text_width(ctx, value, draw::kSmallTextSize + 1) + 1;
      draw::text(ctx, {right - value_width, rect.top + 29, value_width, 20}, value, colors.text,
                 draw::kSmallTextSize + 1, draw::Align::Right);
      text_width -= value_width + 8;
    }
    if (!row->entry.tags.empty()) more += "  " + join(row->entry.tags, ", ");
    draw::text(ctx, {left, rect.top + 29, text_width, 20}, more, ink, draw::kSmallTextSize);
  }
  double row_height() const override { return layout().scenario; }
  double content_height() const override { return lines().height(layout()); }
  Place place_of(std::size_t line) const override {
    const ListLines::Place place = lines().place_of(line, layout());
    return {place.top, place.height, place.column, place.columns};
  }
  std::size_t row_at_offset(double y) const override { return lines().line_at(y, layout()); }
  std::size_t row_below(std::size_t line, int rows) const override {
    return lines().line_below(line, rows, layout().across);
  }
  void paint(NVGcontext* ctx) override {
    choose_picture_size();
    upload_thumbnails(ctx);
    missing_thumbnails_.clear();
    keep_place();
    if (row_count() > 0 && scrolled_to_ != document()->current()) scroll_to_current();
    painted_ = visible_rows();
    reserve_textures();
    Table::paint(ctx);
    if (document() != nullptr)
      thumbnails_.request(document()->path(), missing_thumbnails_, picture_size_);
  }
  void hover(const std::optional<Point>& at) override {
    Table::hover(at);
    if (!hovered()) return;
    const ListLines::Line item = lines().at(*hovered());
    const ListRow* row =
        item.group ? nullptr : document()->row(document()->view().hashes[item.index]);
    const bool has_reason =
        row != nullptr && row->outcomes.empty() && row->value && row->value->is_na();
    if (studio_.grid() && row != nullptr)
      setTooltip(describe(*row));
    else
      setTooltip(has_reason ? "NA: " + row->value->reason() : "");
  }
  /// The right button selects the row, unless it is one of several that are selected.
  bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override {
    const bool opens = button == GLFW_MOUSE_BUTTON_RIGHT && down;
    const auto row = opens ? row_at(local(p)) : std::nullopt;
    if (row && !lines().at(*row).group) {
      const std::size_t index = lines().at(*row).index;
      if (!document()->is_selected(index)) document()->select_only(index);
      document()->set_current(document()->view().hashes[index]);
      scrolled_to_ = document()->current();
    }
    return Table::mouseButtonEvent(p, button, down, modifiers);
  }
  bool key(int key, int modifiers) override {
    if (row_count() == 0 || (modifiers & GLFW_MOD_ALT) != 0) return false;
    if (focused_group_ && *focused_group_ >= document()->view().groups.size())
      focused_group_.reset();
    const auto index = document()->view().index_of(document()->current());
    if (key == GLFW_KEY_LEFT || key == GLFW_KEY_RIGHT) {
      const bool left = key == GLFW_KEY_LEFT;
      const std::size_t now = cursor(), last = row_count() - 1;
      const auto header = lines().at(now).group;
      if (layout().across == 1 || (header && lines().is_closed(*header) != left))
        return set_group_closed(left);
      return move_cursor(left ? now - std::min<std::size_t>(now, 1) : std::min(now + 1, last),
                         modifiers),
             true;
    }
    if (key == GLFW_KEY_A && (modifiers & GLFW_MOD_CONTROL) != 0)
      return document()->select_all(), true;
    if (key == GLFW_KEY_ESCAPE && document()->selected_count() > 0)
      return document()->select_none(), true;
    if (key != GLFW_KEY_SPACE) return Table::key(key, modifiers);
    if (focused_group_)
      document()->toggle_group(*focused_group_);
    else if (index)
      document()->toggle(*index);
    return true;
  }

 private:
  using Texture = std::optional<int>;  ///< NanoVG handle; none if it cannot be drawn
  ListDocument* document() const { return studio_.active(); }
  const ListLines& lines() const { return document()->lines(); }
  /// Cells of the grid are as wide as fills the width beside the scroll bar.
  ListLines::Layout layout() const {
    if (!studio_.grid()) return {kRowHeight, kHeaderHeight, 1};
    const double available = width() - Scroll::kBarWidth;
    const double across = std::max(std::floor(available / kMinCellWidth), 1.0);
    const double side = std::floor(std::max(available, kMinCellWidth) / across) - 2 * kRowMargin;
    return {kRowMargin + side + kNameHeight, kHeaderHeight, static_cast<std::size_t>(across)};
  }
  /// Keeps what is seen when the number of columns changes: the first row, and the cursor.
  void keep_place() {
    const ListLines::Layout now = layout();
    if (now.across == painted_layout_.across && now.scenario == painted_layout_.scenario) return;
    painted_layout_ = now;
    if (painted_.empty() || painted_.back() >= row_count()) return;
    put_on_top(painted_.front());
    if (std::find(painted_.begin(), painted_.end(), cursor()) != painted_.end())
      bring_into_view(cursor());
  }
  /// Textures for the grid are larger, and those for screens with more pixels.
  void choose_picture_size() {
    const int size = (studio_.grid() ? kGridPicture : kThumbnailSize) *
                     static_cast<int>(std::ceil(std::max(screen()->pixelRatio(), 1.0F)));
    if (size == picture_size_) return;
    picture_size_ = size;
    textures_.clear();
  }
  /// At least for what is seen, which would otherwise be drawn again and again.
  void reserve_textures() {
    const auto bytes = 4 * static_cast<std::size_t>(picture_size_ * picture_size_);
    textures_.set_capacity(std::max(kTextureMemory / bytes, painted_.size()));
  }
  void documents_changed() {
    painted_.clear();
    scroll_to_top();
    clear_hovered();
    focused_group_.reset();
    scrolled_to_.clear();
  }
  void scroll_to_current() {
    scrolled_to_ = document()->current();
    const auto index = document()->view().index_of(scrolled_to_);
    const auto line = index ? lines().line_of(*index) : std::nullopt;
    if (line) bring_into_view(*line);
  }
  /// Scrolls to a row. Returns whether it was visible before.
  bool reveal(std::size_t index) {
    const auto line = lines().line_of(index);
    if (!line) return false;
    const std::vector<std::size_t> before = visible_rows();
    bring_into_view(*line);
    return std::find(before.begin(), before.end(), *line) != before.end();
  }
  void select(std::size_t index, int modifiers) {
    if ((modifiers & GLFW_MOD_SHIFT) != 0)
      document()->select_to(index);
    else if ((modifiers & GLFW_MOD_CONTROL) != 0)
      document()->toggle(index);
    else
      document()->select_only(index);
  }
  bool set_group_closed(bool closed) {
    const auto index = document()->view().index_of(document()->current());
    const auto group = focused_group_ ? focused_group_
                       : index        ? lines().group_of(*index)
                                      : std::nullopt;
    if (!group || *group >= document()->view().groups.size()) return false;
    if (lines().is_closed(*group) != closed) document()->toggle_group(*group);
    if (closed) focused_group_ = group;
    return true;
  }
  /// Name, id, tags and sort value.
  std::string describe(const ListRow& row) const {
    std::string text = row.entry.name + ", " + row.entry.id;
    if (!row.entry.tags.empty()) text += ", tags " + join(row.entry.tags, " ");
    const std::string& sort = document()->request().sort;
    if (!sort.empty() && sort != "name") {
      text += ", " + sort + " " + value_text(row, document()->sort_unit());
      if (row.outcomes.empty() && row.value && row.value->is_na())
        text += " (" + row.value->reason() + ")";
    }
    return text;
  }
  std::string row_text(std::size_t index) const {
    const ListRow* row = document()->row(document()->view().hashes[index]);
    if (row == nullptr) return "";
    std::string text = "row " + std::to_string(index) + ": " + describe(*row);
    if (document()->view().hashes[index] == document()->current()) text += ", current";
    if (document()->is_selected(index)) text += ", selected";
    return text;
  }
  void upload_thumbnails(NVGcontext* ctx) {
    context_ = ctx;
    for (const auto& [hash, thumbnail] : pending_thumbnails_) {
      if (thumbnail.size > 0 && thumbnail.size != picture_size_) continue;  // requested before
      Texture texture;
      if (thumbnail.size > 0)
        texture = nvgCreateImageRGBA(ctx, thumbnail.size, thumbnail.size, 0, thumbnail.rgba.data());
      textures_.put(hash, texture);
    }
    pending_thumbnails_.clear();
  }
  void draw_group_header(NVGcontext* ctx, const ScreenRect& rect, std::size_t group) const {
    const Palette& colors = palette();
    const ListGroup& shown = document()->view().groups[group];
    const bool under_mouse = hovered() == lines().line_of_group(group);
    draw::fill(ctx, rect, under_mouse ? colors.hover : colors.window);
    if (focused() && focused_group_ == group) draw::frame(ctx, rect, colors.accent);
    // A triangle that points down where the group is open.
    const double x = rect.left + 12, y = rect.top + 14;
    if (lines().is_closed(group))
      draw::triangle(ctx, {x - 3, y - 6}, {x - 3, y + 6}, {x + 5, y}, colors.faint_text);
    else
      draw::triangle(ctx, {x - 6, y - 3}, {x + 6, y - 3}, {x, y + 5}, colors.faint_text);
    const std::string count = std::to_string(shown.count);
    const double count_width = draw::text_width(ctx, count, draw::kTextSize, true);
    draw::text(ctx, {24, rect.top, rect.width - count_width - 40, rect.height}, shown.title,
               colors.text, draw::kTextSize, draw::Align::Left, true);
    draw::text(ctx, {rect.width - count_width - 10, rect.top, count_width + 1, rect.height}, count,
               colors.faint_text, draw::kTextSize, draw::Align::Right, true);
  }
  void draw_cell(NVGcontext* ctx, const ScreenRect& rect, const std::string& hash,
                 const std::string& name) {
    const double side = rect.height - kNameHeight - kRowMargin;
    const double left = std::round(rect.center().x - side / 2);
    draw_thumbnail(ctx, {left, rect.top + kRowMargin, side, side}, hash);
    draw::text(ctx, {rect.left + 4, rect.bottom() - kNameHeight, rect.width - 8, kNameHeight}, name,
               palette().text, draw::kSmallTextSize, draw::Align::Center,
               hash == document()->current());
  }
  void draw_thumbnail(NVGcontext* ctx, const ScreenRect& rect, const std::string& hash) {
    const Texture* texture = textures_.find(hash);
    if (texture == nullptr) missing_thumbnails_.push_back(hash);
    if (texture == nullptr || !*texture) {
      draw::frame(ctx, rect, palette().border);
      return;
    }
    draw::image(ctx, rect, **texture);
  }

  Studio& studio_;
  ThumbnailMaker thumbnails_;
  std::optional<std::size_t> focused_group_;  ///< the group header with the cursor, if any
  std::string scrolled_to_;                   ///< the scenario last scrolled to
  NVGcontext* context_ = nullptr;
  int picture_size_ = kThumbnailSize;  ///< of textures, pixels
  LruCache<Texture> textures_;
  std::vector<std::pair<std::string, Thumbnail>> pending_thumbnails_;  ///< not yet textures
  std::vector<std::string> missing_thumbnails_;
  ListLines::Layout painted_layout_{kRowHeight, kHeaderHeight, 1};
  std::vector<std::size_t> painted_;  ///< lines
};

}  // namespace

Element* make_list_rows(nanogui::Widget* parent, Studio& studio) {
  return new ListRows(parent, studio);
}

}  // namespace slalom
