#include "views/descriptor_table.h"
#include "widgets/drawing.h"

#include <algorithm>

namespace slalom {
namespace {

constexpr double kHeaderHeight = 19, kRowHeight = 17, kFooterHeight = 20;  ///< pixels
constexpr double kTwoColumnWidth = 760;  ///< min. width for two columns, pixels
constexpr double kValueWidth = 102;      ///< pixels, of "0.1234 +- 0.1234"
constexpr float kTextSize = 14;

/// The cells of a row: name, value, unit or reason of NA.
struct RowCells {
  ScreenRect name, value, rest;

  explicit RowCells(const ScreenRect& row) {
    const double left = row.left + 8, wide = row.width - 16;
    const double value_wide = std::max(0.26 * wide, std::min(kValueWidth, 0.5 * wide));
    name = {left, row.top, 0.5 * wide - 6, row.height};
    value = {left + 0.5 * wide, row.top, value_wide, row.height};
    const double behind = left + 0.5 * wide + value_wide + 6;
    rest = {behind, row.top, left + wide - behind, row.height};
  }
};

}  // namespace

DescriptorTable::DescriptorTable(nanogui::Widget* parent, const DescriptorModel& model,
                                 Select select)
    : Table(parent, "descriptor_values", {kHeaderHeight, kRowHeight, kFooterHeight}),
      model_(model),
      select_(std::move(select)) {}

std::size_t DescriptorTable::columns() const {
  return width() >= kTwoColumnWidth ? 2 : 1;
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
  return text + "selected " + model_.selected_row().info.id;
}

std::optional<ScreenRect> DescriptorTable::rect_of(const std::string& part) const {
  for (std::size_t row = 0; row < model_.rows().size(); ++row)
    if (part == "row " + model_.rows()[row].info.id) return bring_into_view(row);
  return Table::rect_of(part);
}

void DescriptorTable::paint_row(NVGcontext* ctx, std::size_t row, const ScreenRect& rect) const {
  const Palette& colors = palette();
  const DescriptorModel::Row& what = model_.rows()[row];
  const bool selected = row == model_.selected();
  draw::row(ctx, rect, row, selected, hovered() == row);
  const RowCells cells(rect);
  const bool number = what.state == DescriptorModel::State::Known && !what.described.value.is_na();
  const bool failed = what.state == DescriptorModel::State::Failed;
  const Color& faint = selected ? colors.text : colors.faint_text;
  draw::text(ctx, cells.name, what.info.name, colors.text, kTextSize);
  draw::text(ctx, cells.value, DescriptorModel::value_text(what),
             failed   ? colors.error_text
             : number ? colors.text
                      : faint,
             kTextSize, draw::Align::Right);
  const std::string unit = what.info.unit == "-" ? "" : what.info.unit;
  const std::string reason = failed ? "" : model_.reason(what);
  draw::text(ctx, cells.rest, reason.empty() ? unit : reason, faint, draw::kSmallTextSize);
}

void DescriptorTable::paint_frame(NVGcontext* ctx) const {
  const Palette& colors = palette();
  const double wide = area().width / static_cast<double>(columns());
  for (std::size_t column = 0; column < columns(); ++column) {
    const RowCells cells({static_cast<double>(column) * wide, 0, wide, kHeaderHeight});
    draw::text(ctx, cells.name, "descriptor", colors.faint_text, draw::kSmallTextSize);
    draw::text(ctx, cells.value, "value", colors.faint_text, draw::kSmallTextSize,
               draw::Align::Right);
    draw::text(ctx, cells.rest, "unit", colors.faint_text, draw::kSmallTextSize);
  }
  const double top = height() - kFooterHeight;
  draw::line(ctx, 0, kHeaderHeight - 0.5, width(), kHeaderHeight - 0.5, colors.border);
  draw::line(ctx, 0, top + 0.5, width(), top + 0.5, colors.border);
  draw::text(ctx, {8, top + 1, width() - 16.0, kFooterHeight - 1},
             model_.describe(model_.rows()[hovered().value_or(model_.selected())]),
             colors.faint_text, draw::kSmallTextSize);
}

void DescriptorTable::hover(const std::optional<Point>& at) {
  Table::hover(at);
  const std::string reason = hovered() ? model_.reason(model_.rows()[*hovered()]) : "";
  setTooltip(reason.empty() ? "" : "NA: " + reason);
}

}  // namespace slalom
