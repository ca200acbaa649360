#include "views/list_rows.h"
#include "widgets/drawing.h"

#include <slalom/core/text.h>

namespace slalom {

void ListRows::upload_thumbnails(NVGcontext* ctx) {
  context_ = ctx;
  for (const auto& [hash, thumbnail] : pending_thumbnails_) {
    Texture texture;
    if (thumbnail.size > 0)
      texture = nvgCreateImageRGBA(ctx, thumbnail.size, thumbnail.size, 0, thumbnail.rgba.data());
    textures_.put(hash, texture);
  }
  pending_thumbnails_.clear();
}

void ListRows::paint(NVGcontext* ctx) {
  upload_thumbnails(ctx);
  missing_thumbnails_.clear();
  if (!has_lines()) return;
  update_scroll();
  if (scrolled_to_ != document()->current()) scroll_to_current();
  for (std::size_t line = lines().line_at(scroll_.offset(), kLineHeights);
       line < lines().size() && line_rect(line).top < height(); ++line) {
    const ListLines::Line item = lines().at(line);
    if (item.group)
      draw_group_header(ctx, line, *item.group);
    else
      draw_row(ctx, line, item.index);
  }
  scroll_.draw(ctx);
  thumbnails_.request(document()->path(), missing_thumbnails_);
}

void ListRows::draw_group_header(NVGcontext* ctx, std::size_t line, std::size_t group) const {
  const Palette& colors = palette();
  const ScreenRect rect = line_rect(line);
  const ListGroup& shown = document()->view().groups[group];
  draw::fill(ctx, rect, hovered_ == line ? colors.hover : colors.window);
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

void ListRows::draw_row(NVGcontext* ctx, std::size_t line, std::size_t index) {
  const Palette& colors = palette();
  const ScreenRect rect = line_rect(line);
  const std::string& hash = document()->view().hashes[index];
  const bool selected = document()->is_selected(index), current = hash == document()->current();
  draw::row(ctx, rect, index, selected, hovered_ == line);
  if (current) draw::fill(ctx, {rect.left, rect.top, 3, rect.height}, colors.accent);
  if (current && focused() && !focused_group_) draw::frame(ctx, rect, colors.accent);
  draw_thumbnail(ctx, {rect.left + kRowMargin, rect.top + 5, kThumbnailSize, kThumbnailSize}, hash);
  const ListRow* row = document()->row(hash);
  if (row == nullptr) return;
  const Color ink = selected ? colors.text : colors.faint_text;
  const double left = kRowMargin + kThumbnailSize + 8, right = rect.width - kRowMargin;
  const ScreenRect upper{left, rect.top + 6, right - left, 22};
  draw::text(ctx, upper, row->entry.name, colors.text, draw::kTextSize, draw::Align::Left, current);
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

void ListRows::draw_thumbnail(NVGcontext* ctx, const ScreenRect& rect, const std::string& hash) {
  const Texture* texture = textures_.find(hash);
  if (texture == nullptr) missing_thumbnails_.push_back(hash);
  if (texture == nullptr || !*texture) {
    draw::frame(ctx, rect, palette().border);
    return;
  }
  draw::image(ctx, rect, **texture);
}

}  // namespace slalom
