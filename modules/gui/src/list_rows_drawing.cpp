#include "list_row_sizes.h"

#include <slalom/core/text.h>
#include <slalom/gui/drawing.h>
#include <slalom/gui/list_rows.h>
#include <slalom/gui/palette.h>

#include <algorithm>

namespace slalom {

void ListRows::upload_pictures(NVGcontext* ctx) {
  context_ = ctx;
  for (const auto& [hash, picture] : arrived_) {
    Picture image;
    if (picture.size > 0)
      image = nvgCreateImageRGBA(ctx, picture.size, picture.size, 0, picture.rgba.data());
    pictures_.put(hash, image);
  }
  arrived_.clear();
}

void ListRows::draw(NVGcontext* ctx) {
  upload_pictures(ctx);
  nvgSave(ctx);
  nvgTranslate(ctx, static_cast<float>(mPos.x()), static_cast<float>(mPos.y()));
  nvgIntersectScissor(ctx, 0, 0, static_cast<float>(width()), static_cast<float>(height()));
  lacking_.clear();
  if (document_ != nullptr && lines().size() > 0) {
    if (followed_ != document_->current()) scroll_to_current();
    for (std::size_t line = lines().line_at(scroll(), kLineHeights);
         line < lines().size() && line_rect(line).top < height(); ++line) {
      const ListLines::Line what = lines().at(line);
      if (what.group)
        draw_head(ctx, line, *what.group);
      else
        draw_row(ctx, line, what.place);
    }
    draw_bar(ctx);
  }
  nvgRestore(ctx);
  if (document_ != nullptr && on_pictures) on_pictures(document_->path(), lacking_);
}

void ListRows::draw_head(NVGcontext* ctx, std::size_t line, std::size_t group) const {
  const Palette& colors = palette();
  const ScreenRect rect = line_rect(line);
  const ListGroup& shown = document_->view().groups[group];
  draw::fill(ctx, rect, hovered_ == line ? colors.hover : colors.window);
  if (focused() && head_ == group) draw::frame(ctx, rect, colors.accent);
  // A triangle that points down where the group is open.
  const auto x = static_cast<float>(rect.left + 12), y = static_cast<float>(rect.top + 14);
  nvgBeginPath(ctx);
  if (lines().is_closed(group)) {
    nvgMoveTo(ctx, x - 3, y - 6);
    nvgLineTo(ctx, x - 3, y + 6);
    nvgLineTo(ctx, x + 5, y);
  } else {
    nvgMoveTo(ctx, x - 6, y - 3);
    nvgLineTo(ctx, x + 6, y - 3);
    nvgLineTo(ctx, x, y + 5);
  }
  nvgFillColor(ctx, colors.faint_text);
  nvgFill(ctx);
  const std::string count = std::to_string(shown.count);
  const double wide = draw::text_width(ctx, count, draw::kTextSize, true);
  draw::text(ctx, {24, rect.top, rect.width - wide - 40, rect.height}, shown.title, colors.text,
             draw::kTextSize, draw::Align::Left, true);
  draw::text(ctx, {rect.width - wide - 10, rect.top, wide + 1, rect.height}, count,
             colors.faint_text, draw::kTextSize, draw::Align::Right, true);
}

void ListRows::draw_row(NVGcontext* ctx, std::size_t line, std::size_t place) {
  const Palette& colors = palette();
  const ScreenRect rect = line_rect(line);
  const std::string& hash = document_->view().hashes[place];
  const bool selected = document_->is_selected(place), current = hash == document_->current();
  draw::fill(ctx, rect,
             selected           ? colors.selected
             : hovered_ == line ? colors.hover
             : place % 2 == 0   ? colors.panel
                                : colors.row);
  if (current) draw::fill(ctx, {rect.left, rect.top, 3, rect.height}, colors.accent);
  if (current && focused() && !head_) draw::frame(ctx, rect, colors.accent);
  draw_picture(ctx, {rect.left + kRowMargin, rect.top + 5, kPictureSize, kPictureSize}, hash);
  const ListRow* row = document_->row(hash);
  if (row == nullptr) return;
  const nanogui::Color ink = selected ? colors.text : colors.faint_text;
  const double left = kRowMargin + kPictureSize + 8, right = rect.width - kRowMargin;
  const ScreenRect upper{left, rect.top + 6, right - left, 22};
  draw::text(ctx, upper, row->entry.name, colors.text, draw::kTextSize, draw::Align::Left, current);
  std::string more = row->entry.id;
  double room = right - left;
  const std::string& sort = document_->request().sort;
  if (!sort.empty() && sort != "name") {
    const std::string value = value_text(*row, document_->sort_unit());
    const double wide = draw::text_width(ctx, value, draw::kSmallTextSize + 1) + 1;
    draw::text(ctx, {right - wide, rect.top + 29, wide, 20}, value, colors.text,
               draw::kSmallTextSize + 1, draw::Align::Right);
    room -= wide + 8;
  }
  if (!row->entry.tags.empty()) more += "  " + join(row->entry.tags, ", ");
  draw::text(ctx, {left, rect.top + 29, room, 20}, more, ink, draw::kSmallTextSize);
}

void ListRows::draw_picture(NVGcontext* ctx, const ScreenRect& place, const std::string& hash) {
  const Picture* picture = pictures_.find(hash);
  if (picture == nullptr) lacking_.push_back(hash);
  if (picture == nullptr || !*picture) {
    draw::frame(ctx, place, palette().border);
    return;
  }
  const auto x = static_cast<float>(place.left), y = static_cast<float>(place.top),
             size = static_cast<float>(place.width);
  nvgBeginPath(ctx);
  nvgRect(ctx, x, y, size, size);
  nvgFillPaint(ctx, nvgImagePattern(ctx, x, y, size, size, 0, **picture, 1));
  nvgFill(ctx);
}

void ListRows::draw_bar(NVGcontext* ctx) const {
  const auto shown = bar();
  if (!shown) return;
  draw::fill(ctx, {width() - kBarWidth, 0, kBarWidth, static_cast<double>(height())},
             palette().window);
  draw::fill(ctx, {shown->left + 2, shown->top + 1, shown->width - 4, shown->height - 2},
             grip_ ? palette().accent : palette().faint_text, 4);
}

}  // namespace slalom
