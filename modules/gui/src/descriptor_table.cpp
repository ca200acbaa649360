#include <slalom/gui/descriptor_table.h>
#include <slalom/gui/drawing.h>
#include <slalom/gui/palette.h>

#include <GLFW/glfw3.h>
#include <algorithm>

namespace slalom {
namespace {

constexpr double kHead = 19, kRow = 17, kFoot = 20;  ///< pixels
constexpr double kTwoColumns = 760;                  ///< pixels that two columns need
constexpr float kSize = 14;

/// The cells of a row: name, value, unit or why there is no value.
struct RowCells {
  ScreenRect name, value, rest;

  explicit RowCells(const ScreenRect& row) {
    const double left = row.left + 8, wide = row.width - 16;
    name = {left, row.top, 0.5 * wide - 6, row.height};
    value = {left + 0.5 * wide, row.top, 0.26 * wide, row.height};
    rest = {left + 0.76 * wide + 6, row.top, 0.24 * wide - 6, row.height};
  }
};

}  // namespace

DescriptorTable::DescriptorTable(nanogui::Widget* parent, DescriptorModel& model)
    : Element(parent, "descriptor_values"), model_(model) {}

std::size_t DescriptorTable::columns() const {
  return width() >= kTwoColumns ? 2 : 1;
}

std::size_t DescriptorTable::rows_per_column() const {
  const auto room = static_cast<std::size_t>(std::max(1.0, (height() - kHead - kFoot) / kRow));
  return std::min(room, (model_.rows().size() + columns() - 1) / columns());
}

std::size_t DescriptorTable::last_first() const {
  const std::size_t shown = rows_per_column() * columns(), all = model_.rows().size();
  return all > shown ? all - shown : 0;
}

void DescriptorTable::scroll_to(std::size_t row) const {
  const std::size_t shown = rows_per_column() * columns();
  if (row < first_) first_ = row;
  if (row >= first_ + shown) first_ = row + 1 - shown;
  first_ = std::min(first_, last_first());
}

void DescriptorTable::show_chosen() const {
  scroll_to(model_.chosen());
}

std::optional<ScreenRect> DescriptorTable::row_rect(std::size_t row) const {
  const std::size_t per_column = rows_per_column();
  if (row < first_ || row >= first_ + per_column * columns()) return std::nullopt;
  const double wide = static_cast<double>(width()) / static_cast<double>(columns());
  const auto column = static_cast<double>((row - first_) / per_column);
  const auto down = static_cast<double>((row - first_) % per_column);
  return ScreenRect{column * wide, kHead + down * kRow, wide, kRow};
}

std::optional<std::size_t> DescriptorTable::row_below(const nanogui::Vector2i& p) const {
  for (std::size_t row = first_; row < model_.rows().size(); ++row) {
    const auto rect = row_rect(row);
    if (rect && rect->contains(p.x() - mPos.x(), p.y() - mPos.y())) return row;
  }
  return std::nullopt;
}

std::string DescriptorTable::text() const {
  std::string text;
  for (const DescriptorModel::Row& row : model_.rows()) {
    text += row.info.id + " = " + DescriptorModel::value_text(row);
    const std::string reason = model_.reason(row);
    if (!reason.empty())
      text += " (" + reason + ")";
    else if (row.state == DescriptorModel::State::Known && row.info.unit != "-")
      text += " " + row.info.unit;
    text += "\n";
  }
  return text + "chosen " + model_.chosen_row().info.id;
}

std::optional<ScreenRect> DescriptorTable::rect_of(const std::string& part) const {
  constexpr std::size_t kPrefix = 4;  // of "row "
  if (part.compare(0, kPrefix, "row ") != 0) return Element::rect_of(part);
  const DescriptorModel::Row* row = model_.find(part.substr(kPrefix));
  if (row == nullptr) return std::nullopt;
  const auto number = static_cast<std::size_t>(row - model_.rows().data());
  scroll_to(number);
  return row_rect(number);
}

void DescriptorTable::draw(NVGcontext* ctx) {
  first_ = std::min(first_, last_first());
  nvgSave(ctx);
  nvgTranslate(ctx, static_cast<float>(mPos.x()), static_cast<float>(mPos.y()));
  nvgIntersectScissor(ctx, 0, 0, static_cast<float>(width()), static_cast<float>(height()));
  draw::fill(ctx, *Element::rect_of(""), palette().panel);
  draw_heads(ctx);
  for (std::size_t row = first_; row < model_.rows().size(); ++row)
    if (const auto rect = row_rect(row)) draw_row(ctx, row, *rect);
  draw_scroll_mark(ctx);
  draw_foot(ctx);
  nvgRestore(ctx);
}

void DescriptorTable::draw_heads(NVGcontext* ctx) const {
  const double wide = static_cast<double>(width()) / static_cast<double>(columns());
  for (std::size_t column = 0; column < columns(); ++column) {
    const RowCells cells({static_cast<double>(column) * wide, 0, wide, kHead});
    const nanogui::Color& color = palette().faint_text;
    draw::text(ctx, cells.name, "descriptor", color, draw::kSmallTextSize);
    draw::text(ctx, cells.value, "value", color, draw::kSmallTextSize, draw::Align::Right);
    draw::text(ctx, cells.rest, "unit", color, draw::kSmallTextSize);
  }
  draw::line(ctx, 0, kHead - 0.5, width(), kHead - 0.5, palette().border);
}

void DescriptorTable::draw_row(NVGcontext* ctx, std::size_t row, const ScreenRect& rect) const {
  const Palette& colors = palette();
  const DescriptorModel::Row& what = model_.rows()[row];
  const bool chosen = row == model_.chosen();
  if (chosen || hovered_ == row || row % 2 == 1)
    draw::fill(ctx, rect, chosen ? colors.selected : hovered_ == row ? colors.hover : colors.row);
  const RowCells cells(rect);
  const bool number = what.state == DescriptorModel::State::Known && !what.described.value.is_na();
  const bool failed = what.state == DescriptorModel::State::Failed;
  const nanogui::Color& faint = chosen ? colors.text : colors.faint_text;
  draw::text(ctx, cells.name, what.info.name, colors.text, kSize);
  draw::text(ctx, cells.value, DescriptorModel::value_text(what),
             failed   ? colors.error_text
             : number ? colors.text
                      : faint,
             kSize, draw::Align::Right);
  const std::string unit = what.info.unit == "-" ? "" : what.info.unit;
  const std::string reason = failed ? "" : model_.reason(what);
  draw::text(ctx, cells.rest, reason.empty() ? unit : reason, faint, draw::kSmallTextSize);
}

/// Shows that there is more, and where this is.
void DescriptorTable::draw_scroll_mark(NVGcontext* ctx) const {
  if (last_first() == 0) return;
  const double room = height() - kHead - kFoot, all = static_cast<double>(model_.rows().size());
  const auto shown = static_cast<double>(rows_per_column() * columns());
  const double top = kHead + room * static_cast<double>(first_) / all;
  draw::fill(ctx, {width() - 5.0, top, 4, room * shown / all}, palette().border, 2);
}

void DescriptorTable::draw_foot(NVGcontext* ctx) const {
  const double top = height() - kFoot;
  const DescriptorModel::Row& row = hovered_ ? model_.rows()[*hovered_] : model_.chosen_row();
  draw::line(ctx, 0, top + 0.5, width(), top + 0.5, palette().border);
  draw::text(ctx, {8, top + 1, width() - 16.0, kFoot - 1}, model_.describe(row),
             palette().faint_text, draw::kSmallTextSize);
}

bool DescriptorTable::mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down,
                                       int /*modifiers*/) {
  if (button != GLFW_MOUSE_BUTTON_LEFT) return false;
  const auto row = row_below(p);
  if (down && row && on_choose) on_choose(*row);
  return true;
}

bool DescriptorTable::mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& /*rel*/,
                                       int /*button*/, int /*modifiers*/) {
  hovered_ = row_below(p);
  const std::string reason = hovered_ ? model_.reason(model_.rows()[*hovered_]) : "";
  setTooltip(reason.empty() ? "" : "NA: " + reason);
  return true;
}

bool DescriptorTable::mouseEnterEvent(const nanogui::Vector2i& /*p*/, bool enter) {
  if (!enter) hovered_.reset();
  return true;
}

bool DescriptorTable::scrollEvent(const nanogui::Vector2i& /*p*/, const nanogui::Vector2f& rel) {
  constexpr double kRowsAStep = 3;
  const double wanted = static_cast<double>(first_) - kRowsAStep * static_cast<double>(rel.y());
  first_ = static_cast<std::size_t>(std::clamp(wanted, 0.0, static_cast<double>(last_first())));
  return true;
}

}  // namespace slalom
