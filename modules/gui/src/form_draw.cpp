#include "form_frame.h"

#include <slalom/gui/form_panel.h>
#include <slalom/gui/palette.h>

#include <algorithm>

namespace slalom {

// How the panel of a form looks.

using namespace form_frame;

namespace {

constexpr double kInset = 6;
constexpr float kHelpSize = 14;

float pixels(double value) {
  return static_cast<float>(value);
}

/// At most two lines in the middle of `rect`.
void two_lines(NVGcontext* ctx, const ScreenRect& rect, const std::string& text,
               const nanogui::Color& color) {
  draw::text_width(ctx, text, kHelpSize);  // sets the font
  NVGtextRow rows[2];
  const int count = nvgTextBreakLines(ctx, text.c_str(), nullptr, pixels(rect.width), rows, 2);
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

void FormPanel::draw(NVGcontext* ctx) {
  nvgSave(ctx);
  nvgTranslate(ctx, pixels(mPos.x()), pixels(mPos.y()));
  const ScreenRect all = *Element::rect_of("");
  const FormDescription& form = model_.description();
  draw::fill(ctx, all, palette().panel, 5);
  draw::frame(ctx, all, palette().border);
  draw::text(ctx, {kMargin, 4, all.width - 2 * kMargin, kTitleHeight - 8}, form.title,
             palette().text, 18, draw::Align::Left, true);
  if (!form.intro.empty() && !is_message())
    draw::wrapped_text(ctx, {kMargin, kTitleHeight, all.width - 2 * kMargin, intro_height_},
                       form.intro, palette().faint_text);
  draw_lines(ctx);
  draw_scroll_bar(ctx);
  draw_foot(ctx);
  nvgRestore(ctx);
}

void FormPanel::draw_lines(NVGcontext* ctx) const {
  const ScreenRect seen = content();
  nvgSave(ctx);
  nvgIntersectScissor(ctx, pixels(seen.left), pixels(seen.top), pixels(seen.width),
                      pixels(seen.height));
  if (is_message())
    draw::wrapped_text(ctx, on_panel({kMargin, 0, seen.width - 2 * kMargin, intro_height_}),
                       model_.description().intro, palette().text);
  for (const FormLine& line : layout_.lines())
    if (line.top + line.height > scroll_ && line.top < scroll_ + seen.height) draw_line(ctx, line);
  nvgRestore(ctx);
}

void FormPanel::draw_line(NVGcontext* ctx, const FormLine& line) const {
  const FormField& field = model_.fields()[line.field];
  const bool heading = field.kind == FieldKind::Heading;
  draw::text(ctx, on_panel(line.label), field.label, palette().text, draw::kTextSize,
             draw::Align::Left, heading);
  if (heading) return;
  const std::string error = touched_.count(line.field) > 0 ? model_.error_of(line.field) : "";
  if (field.kind == FieldKind::Flag) {
    draw_flag(ctx, line);
  } else if (is_typed(line.field)) {
    draw_box(ctx, line, !error.empty());
  } else {
    draw_choices(ctx, line);
  }
  draw::text(ctx, on_panel(line.unit), field.unit, palette().faint_text);
  if (line.help.width <= 0) return;  // the foot tells what is wrong
  two_lines(ctx, on_panel(line.help), error.empty() ? field.help : error,
            error.empty() ? palette().faint_text : palette().error_text);
}

void FormPanel::draw_box(NVGcontext* ctx, const FormLine& line, bool wrong) const {
  const ScreenRect box = on_panel(line.box);
  const bool focused = focus_ == line.field;
  draw::fill(ctx, box, palette().window, 3);
  draw::frame(ctx, box,
              wrong     ? palette().error_text
              : focused ? palette().accent
                        : palette().border);
  if (focused) {
    draw_typed(ctx, box);
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

std::size_t FormPanel::letter_at(const ScreenRect& box, double x) const {
  if (context_ == nullptr) return 0;
  const std::string& text = editor_.text();
  const double wanted = x - box.left - kInset + text_offset(box);
  LineEditor walk(text);
  walk.move_to_begin(false);
  double left = 0;
  while (walk.cursor() < text.size()) {
    const std::size_t place = walk.cursor();
    walk.move(1, false);
    const double right = draw::text_width(context_, text.substr(0, walk.cursor()));
    if (wanted < 0.5 * (left + right)) return place;
    left = right;
  }
  return text.size();
}

void FormPanel::draw_typed(NVGcontext* ctx, const ScreenRect& box) const {
  const std::string& text = editor_.text();
  const auto place_of = [&](std::size_t letter) {
    return box.left + kInset + draw::text_width(ctx, text.substr(0, letter)) - text_offset(box);
  };
  nvgSave(ctx);
  nvgIntersectScissor(ctx, pixels(box.left + 2), pixels(box.top), pixels(box.width - 4),
                      pixels(box.height));
  const double begin = place_of(editor_.selection_begin()), end = place_of(editor_.selection_end());
  if (end > begin)
    draw::fill(ctx, {begin, box.top + 3, end - begin, box.height - 6}, palette().selected);
  draw::text(ctx, {place_of(0), box.top, draw::text_width(ctx, text) + 2, box.height}, text,
             palette().text);
  const double cursor = place_of(editor_.cursor());
  draw::line(ctx, cursor, box.top + 4, cursor, box.top + box.height - 4, palette().accent, 1.5F);
  nvgRestore(ctx);
}

void FormPanel::draw_flag(NVGcontext* ctx, const FormLine& line) const {
  const ScreenRect place = on_panel(line.box);
  const ScreenRect box = {place.left, place.top + 3, 20, 20};
  draw::fill(ctx, box, palette().window, 3);
  draw::frame(ctx, box, focus_ == line.field ? palette().accent : palette().border);
  const bool set = model_.value(line.field) == "true";
  if (set) draw::fill(ctx, {box.left + 5, box.top + 5, 10, 10}, palette().accent, 2);
  draw::text(ctx, {box.left + 28, place.top, 100, place.height}, set ? "yes" : "no",
             palette().text);
}

void FormPanel::draw_choices(NVGcontext* ctx, const FormLine& line) const {
  const FormField& field = model_.fields()[line.field];
  for (std::size_t i = 0; i < line.choices.size(); ++i) {
    const ScreenRect rect = on_panel(line.choices[i]);
    const bool chosen = model_.is_chosen(line.field, field.choices[i]);
    draw::fill(ctx, rect, chosen ? palette().selected : palette().window, 4);
    const bool marked = focus_ == line.field && choice_ == i;
    draw::frame(ctx, rect, marked ? palette().accent : palette().border);
    draw::text(ctx, {rect.left + 8, rect.top, rect.width - 16, rect.height}, field.choices[i],
               chosen ? palette().text : palette().faint_text, draw::kTextSize,
               draw::Align::Center);
  }
}

void FormPanel::draw_scroll_bar(NVGcontext* ctx) const {
  const ScreenRect seen = content();
  if (content_height() <= seen.height) return;
  const double length = seen.height * seen.height / content_height();
  const double top = seen.top + scroll_ * seen.height / content_height();
  draw::fill(ctx, {seen.width - 9, top, 5, length}, palette().faint_text, 2);
}

void FormPanel::draw_foot(NVGcontext* ctx) const {
  const double top = height() - foot_height(is_message());
  draw::line(ctx, 1, top + 0.5, width() - 1, top + 0.5, palette().border);
  two_lines(ctx, {kMargin, top + 6, width() - 2 * kMargin, 38}, message_, palette().error_text);
  if (!is_message()) draw_button(ctx, cancel_rect(), "Cancel", focus_ == cancel_stop(), false);
  draw_button(ctx, ok_rect(), model_.description().accept, focus_ == ok_stop(), true);
}

void FormPanel::draw_button(NVGcontext* ctx, const ScreenRect& rect, const std::string& label,
                            bool focused, bool main) const {
  draw::fill(ctx, rect, main ? palette().selected : palette().hover, 4);
  draw::frame(ctx, rect, focused ? palette().accent : palette().border);
  draw::text(ctx, {rect.left + 6, rect.top, rect.width - 12, rect.height}, label, palette().text,
             draw::kTextSize, draw::Align::Center);
}

}  // namespace slalom
