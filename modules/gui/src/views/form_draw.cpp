#include "views/form_panel.h"
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

constexpr double kInset = 6;
constexpr float kHelpSize = 14;

/// Draws at most two lines, vertically centered in `rect`.
void draw_two_lines(NVGcontext* ctx, const ScreenRect& rect, const std::string& text,
                    const Color& color) {
  draw::text_width(ctx, text, kHelpSize);  // sets the font
  NVGtextRow rows[2];
  const int count =
      nvgTextBreakLines(ctx, text.c_str(), nullptr, static_cast<float>(rect.width), rows, 2);
  const double height = 18;
  double top = rect.top + 0.5 * (rect.height - count * height);
  for (int i = 0; i < count; ++i, top += height) {
    const bool last = i == 1;
    draw::text(ctx, {rect.left, top, rect.width, height},
               last ? std::string(rows[i].start) : std::string(rows[i].start, rows[i].end), color,
               kHelpSize);
  }
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
    } else if (has_choices(field)) {
      lay_out_choices(field, measure, line);
    } else if (field.wide) {
      lay_out_wide(field, line);
    } else {
      lay_out_row(line);
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

void FormPanel::paint(NVGcontext* ctx) {
  const ScreenRect all = area(), visible = content();
  const FormDescription& form = model_.description();
  draw::fill(ctx, all, palette().panel, 5);
  draw::frame(ctx, all, palette().border);
  draw::text(ctx, {kMargin, 4, all.width - 2 * kMargin, kTitleHeight - 8}, form.title,
             palette().text, 18, draw::Align::Left, true);
  if (!form.intro.empty() && !is_message())
    draw::wrapped_text(ctx, {kMargin, kTitleHeight, all.width - 2 * kMargin, intro_height_},
                       form.intro, palette().faint_text);
  nvgSave(ctx);
  draw::clip(ctx, visible);
  if (is_message())
    draw::wrapped_text(ctx, to_panel({kMargin, 0, visible.width - 2 * kMargin, intro_height_}),
                       form.intro, palette().text);
  for (const FormLine& line : layout_.lines()) {
    const double top = line.top - scroll_.offset();
    if (top + line.height > 0 && top < visible.height) draw_line(ctx, line);
  }
  scroll_.draw(ctx);
  nvgRestore(ctx);
  draw_footer(ctx);
}

void FormPanel::draw_line(NVGcontext* ctx, const FormLine& line) const {
  const FormField& field = model_.fields()[line.field];
  const bool heading = field.kind == FieldKind::Heading;
  draw::text(ctx, to_panel(line.label), field.label, palette().text, draw::kTextSize,
             draw::Align::Left, heading);
  if (heading) return;
  const std::string error = error_of(line.field);
  const bool focused = focus_ == line.field;
  if (field.kind == FieldKind::Flag) {
    const ScreenRect box = to_panel(line.box);
    const bool set = model_.value(line.field) == "true";
    draw::check_box(ctx, box, set, focused);
    draw::text(ctx, {box.left + 28, box.top, 100, box.height}, set ? "yes" : "no", palette().text);
  } else if (is_text_field(line.field)) {
    draw_box(ctx, line, !error.empty());
  }
  for (std::size_t i = 0; i < line.choices.size(); ++i)
    draw::button(
        ctx, to_panel(line.choices[i]), field.choices[i],
        {model_.is_chosen(line.field, field.choices[i]), true, false, focused && choice_ == i});
  draw::text(ctx, to_panel(line.unit), field.unit, palette().faint_text);
  if (line.help.width <= 0) return;  // the footer shows the error
  draw_two_lines(ctx, to_panel(line.help), error.empty() ? field.help : error,
                 error.empty() ? palette().faint_text : palette().error_text);
}

void FormPanel::draw_box(NVGcontext* ctx, const FormLine& line, bool invalid) const {
  const ScreenRect box = to_panel(line.box);
  const bool focused = focus_ == line.field;
  draw::fill(ctx, box, palette().window, 3);
  draw::frame(ctx, box,
              invalid   ? palette().error_text
              : focused ? palette().accent
                        : palette().border);
  if (focused) {
    draw_edited_text(ctx, box);
  } else {
    draw::text(ctx, {box.left + kInset, box.top, box.width - 2 * kInset, box.height},
               model_.value(line.field), palette().text);
  }
}

double FormPanel::text_offset(const ScreenRect& box) const {
  if (context_ == nullptr) return 0;
  const double cursor = draw::text_width(context_, editor_.text().substr(0, editor_.cursor()));
  return std::max(0.0, cursor - (box.width - 2 * kInset - 2));
}

std::size_t FormPanel::character_at(const ScreenRect& box, double x) const {
  if (context_ == nullptr) return 0;
  const std::string& text = editor_.text();
  const double target = x - box.left - kInset + text_offset(box);
  LineEditor scan(text);
  scan.move_to_begin(false);
  double left = 0;
  while (scan.cursor() < text.size()) {
    const std::size_t position = scan.cursor();
    scan.move(1, false);
    const double right = draw::text_width(context_, text.substr(0, scan.cursor()));
    if (target < 0.5 * (left + right)) return position;
    left = right;
  }
  return text.size();
}

void FormPanel::draw_edited_text(NVGcontext* ctx, const ScreenRect& box) const {
  const std::string& text = editor_.text();
  const auto x_of = [&](std::size_t position) {
    return box.left + kInset + draw::text_width(ctx, text.substr(0, position)) - text_offset(box);
  };
  nvgSave(ctx);
  draw::clip(ctx, box.inset(2));
  const double begin = x_of(editor_.selection_begin()), end = x_of(editor_.selection_end());
  if (end > begin)
    draw::fill(ctx, {begin, box.top + 3, end - begin, box.height - 6}, palette().selected);
  draw::text(ctx, {x_of(0), box.top, draw::text_width(ctx, text) + 2, box.height}, text,
             palette().text);
  const double cursor = x_of(editor_.cursor());
  draw::line(ctx, cursor, box.top + 4, cursor, box.top + box.height - 4, palette().accent, 1.5F);
  nvgRestore(ctx);
}

void FormPanel::draw_footer(NVGcontext* ctx) const {
  const double top = height() - footer_height();
  draw::line(ctx, 1, top + 0.5, width() - 1, top + 0.5, palette().border);
  draw_two_lines(ctx, {kMargin, top + 6, width() - 2 * kMargin, 38}, message_,
                 palette().error_text);
  if (!is_message())
    draw::button(ctx, cancel_rect(), "Cancel", {false, true, false, focus_ == cancel_tab_stop()});
  draw::button(ctx, ok_rect(), model_.description().accept,
               {true, true, false, focus_ == ok_tab_stop()});
}

}  // namespace slalom
