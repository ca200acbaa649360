// SPDX-License-Identifier: BSD-3-Clause
#include "views/folder_table.h"
#include "views/form_layout.h"
#include "widgets/drawing.h"

#include <algorithm>

namespace slalom {
namespace {

constexpr double kLabelWidth = 176, kBoxLeft = FormLayout::kMargin + kLabelWidth + 8;
constexpr double kBoxWidth = 176, kUnitWidth = 44, kBoxHeight = 26, kPitch = 38;
constexpr double kFormChoiceHeight = 24, kChoiceGap = 6, kHelpHeight = 18;

bool has_choices(const FormField& field) {
  return field.kind == FieldKind::Choice || field.kind == FieldKind::Choices;
}

}  // namespace

FormLayout::FormLayout(const FormModel& form, double width, const Measure& measure,
                       std::optional<std::size_t> browsed)
    : width_(width) {
  for (std::size_t i = 0; i < form.fields().size(); ++i) {
    if (!form.is_shown(i)) continue;
    const FormField& field = form.fields()[i];
    FormLine line;
    line.field = i;
    line.top = height_;
    line.label = {kMargin, height_ + 4, kLabelWidth, kBoxHeight};
    if (field.kind == FieldKind::Heading) {
      line.height = 30;
      line.label.width = width_ - 2 * kMargin;
    } else if (has_choices(field)) {
      lay_out_choices(field, measure, line);
    } else if (field.wide) {
      lay_out_wide(field, line);
    } else {
      lay_out_row(line);
    }
    if (browsed == i) {
      line.folder = {kBoxLeft, line.top + line.height, width_ - kMargin - kBoxLeft,
                     FolderTable::kHeight};
      line.height += FolderTable::kHeight + 10;
    }
    height_ += line.height;
    lines_.push_back(line);
  }
}

void FormLayout::lay_out_row(FormLine& line) const {
  line.box = {kBoxLeft, line.top + 4, kBoxWidth, kBoxHeight};
  line.unit = {kBoxLeft + kBoxWidth + 6, line.top + 4, kUnitWidth, kBoxHeight};
  const double help_left = kBoxLeft + kBoxWidth + kUnitWidth + 12;
  line.help = {help_left, line.top, std::max(0.0, width_ - kMargin - help_left), kPitch - 2};
  line.height = kPitch;
}

void FormLayout::lay_out_wide(const FormField& field, FormLine& line) const {
  line.box = {kBoxLeft, line.top + 4, width_ - kMargin - kBoxLeft, kBoxHeight};
  line.height = kBoxHeight + 12;
  if (field.help.empty()) return;
  line.help = {kBoxLeft, line.top + kBoxHeight + 5, line.box.width, kHelpHeight};
  line.height += kHelpHeight;
}

void FormLayout::lay_out_choices(const FormField& field, const Measure& measure,
                                 FormLine& line) const {
  double left = kBoxLeft, top = line.top + 5;
  const double right = width_ - kMargin;
  for (const std::string& choice : field.choices) {
    const double preferred = measure(choice, draw::kTextSize) + 20;
    const double width = std::min(preferred, right - kBoxLeft);
    if (left > kBoxLeft && left + width > right) {
      left = kBoxLeft;
      top += kFormChoiceHeight + kChoiceGap;
    }
    line.choices.push_back({left, top, width, kFormChoiceHeight});
    left += width + kChoiceGap;
  }
  const double bottom = top + kFormChoiceHeight;
  line.box = {kBoxLeft - 3, line.top + 2, right - kBoxLeft + 6, bottom - line.top + 1};
  line.height = bottom + 12 - line.top;
  if (field.help.empty()) return;
  line.help = {kBoxLeft, bottom + 4, right - kBoxLeft, kHelpHeight};
  line.height += kHelpHeight - 4;
}

const FormLine* FormLayout::line_of(std::size_t field) const {
  for (const FormLine& line : lines_)
    if (line.field == field) return &line;
  return nullptr;
}

double FormLayout::preferred_width(const FormDescription& form) {
  const bool has_help = std::any_of(form.fields.begin(), form.fields.end(), [](const auto& field) {
    return !field.wide && !field.help.empty() && !has_choices(field) &&
           field.kind != FieldKind::Heading;
  });
  return has_help ? 900 : 640;
}

}  // namespace slalom
