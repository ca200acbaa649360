#include <slalom/gui/drawing.h>
#include <slalom/gui/form_layout.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr double kMargin = 16, kLabelWidth = 176, kBoxLeft = kMargin + kLabelWidth + 8;
constexpr double kBoxWidth = 176, kUnitWidth = 44, kBoxHeight = 26, kPitch = 38;
constexpr double kChoiceHeight = 24, kChoiceGap = 6, kHelpHeight = 18;

bool is_chosen_from(const FormField& field) {
  return field.kind == FieldKind::Choice || field.kind == FieldKind::Choices;
}

}  // namespace

FormLayout::FormLayout(const FormModel& form, double width, const Measure& measure)
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
    } else if (is_chosen_from(field)) {
      place_choices(field, measure, line);
    } else if (field.wide) {
      place_wide(field, line);
    } else {
      place_beside(line);
    }
    height_ += line.height;
    lines_.push_back(line);
  }
}

void FormLayout::place_beside(FormLine& line) const {
  line.box = {kBoxLeft, line.top + 4, kBoxWidth, kBoxHeight};
  line.unit = {kBoxLeft + kBoxWidth + 6, line.top + 4, kUnitWidth, kBoxHeight};
  const double help_left = kBoxLeft + kBoxWidth + kUnitWidth + 12;
  line.help = {help_left, line.top, std::max(0.0, width_ - kMargin - help_left), kPitch - 2};
  line.height = kPitch;
}

void FormLayout::place_wide(const FormField& field, FormLine& line) const {
  line.box = {kBoxLeft, line.top + 4, width_ - kMargin - kBoxLeft, kBoxHeight};
  line.height = kBoxHeight + 12;
  if (field.help.empty()) return;
  line.help = {kBoxLeft, line.top + kBoxHeight + 5, line.box.width, kHelpHeight};
  line.height += kHelpHeight;
}

void FormLayout::place_choices(const FormField& field, const Measure& measure,
                               FormLine& line) const {
  double left = kBoxLeft, top = line.top + 5;
  const double right = width_ - kMargin;
  for (const std::string& choice : field.choices) {
    const double wanted = measure(choice, draw::kTextSize) + 20;
    const double width = std::min(wanted, right - kBoxLeft);
    if (left > kBoxLeft && left + width > right) {
      left = kBoxLeft;
      top += kChoiceHeight + kChoiceGap;
    }
    line.choices.push_back({left, top, width, kChoiceHeight});
    left += width + kChoiceGap;
  }
  const double bottom = top + kChoiceHeight;
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

double FormLayout::wanted_width(const FormDescription& form) {
  const bool explains = std::any_of(form.fields.begin(), form.fields.end(), [](const auto& field) {
    return !field.wide && !field.help.empty() && !is_chosen_from(field) &&
           field.kind != FieldKind::Heading;
  });
  return explains ? 900 : 640;
}

}  // namespace slalom
