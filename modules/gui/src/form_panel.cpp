#include "form_frame.h"

#include <slalom/core/error.h>
#include <slalom/gui/drawing.h>
#include <slalom/gui/form_panel.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <utility>

namespace slalom {

using namespace form_frame;

FormPanel::FormPanel(nanogui::Widget* parent, FormDescription description,
                     std::function<void()> close)
    : Element(parent, "dialog"),
      model_(std::move(description)),
      close_(std::move(close)),
      layout_(model_, 0, [](const std::string&, float) { return 0; }) {
  go_to(stops().front());
}

void FormPanel::fit(NVGcontext* ctx, const nanogui::Vector2i& most) {
  context_ = ctx;
  const FormDescription& form = model_.description();
  const double width = std::min<double>(FormLayout::wanted_width(form), most.x());
  intro_height_ =
      form.intro.empty() ? 0 : wrapped_height(ctx, form.intro, width - 2 * kMargin) + 10;
  setWidth(static_cast<int>(width));
  lay_out();
  const double wanted = kTitleHeight + intro_height_ + layout_.height() + foot_height(is_message());
  // Fields that come and go do not make the dialog jump: it only grows.
  setHeight(std::max(height(), static_cast<int>(std::min<double>(wanted + 1, most.y()))));
  setHeight(std::min(height(), most.y()));
  setFixedSize(size());
  scroll_to(scroll_);
}

void FormPanel::lay_out() {
  if (context_ == nullptr) return;
  layout_ = FormLayout(model_, width(), [this](const std::string& text, float size) {
    return draw::text_width(context_, text, size);
  });
}

void FormPanel::fill_in(const std::string& key, const std::string& text) {
  const std::size_t field = model_.index_of(key);
  model_.set_value(field, text);
  if (field == focus_) editor_.set_text(text);
  touched_.insert(field);
  lay_out();
}

void FormPanel::accept() {
  if (const auto error = model_.first_error()) {
    for (std::size_t i = 0; i < model_.fields().size(); ++i) touched_.insert(i);
    go_to(error->first);
    message_ = error->second;
    return;
  }
  try {
    if (model_.description().accepted) model_.description().accepted(model_.values());
  } catch (const std::exception& error) {
    message_ = reason_of(error);
    return;
  }
  cancel();
}

void FormPanel::cancel() {
  const auto close = std::exchange(close_, nullptr);
  if (close) close();
}

std::string FormPanel::text() const {
  std::string all = model_.description().title + "\n" + model_.description().intro + "\n";
  for (std::size_t i = 0; i < model_.fields().size(); ++i) {
    if (!model_.is_shown(i)) continue;
    const FormField& field = model_.fields()[i];
    all += field.label;
    if (field.kind != FieldKind::Heading) all += ": " + model_.value(i);
    if (!field.unit.empty()) all += " " + field.unit;
    const std::string error = touched_.count(i) > 0 ? model_.error_of(i) : "";
    all += (error.empty() ? "" : " (" + error + ")") + "\n";
  }
  return all + (message_.empty() ? "" : message_ + "\n");
}

std::optional<ScreenRect> FormPanel::rect_of(const std::string& part) const {
  if (part == "ok") return ok_rect();
  if (part == "cancel" && !is_message()) return cancel_rect();
  for (const FormLine& line : layout_.lines()) {
    const FormField& field = model_.fields()[line.field];
    if (part == "field " + field.key && in_sight(line.box)) return on_panel(line.box);
    for (std::size_t i = 0; i < line.choices.size(); ++i)
      if (part == "choice " + field.key + " " + field.choices[i] && in_sight(line.choices[i]))
        return on_panel(line.choices[i]);
  }
  return Element::rect_of(part);
}

ScreenRect FormPanel::content() const {
  const double top = kTitleHeight + (is_message() ? 0 : intro_height_);
  const double bottom = height() - foot_height(is_message());
  return {0, top, static_cast<double>(width()), std::max(0.0, bottom - top)};
}
ScreenRect FormPanel::ok_rect() const {
  return {width() - kMargin - kButtonWidth, height() - 44.0, kButtonWidth, 32};
}
ScreenRect FormPanel::cancel_rect() const {
  return {width() - kMargin - 2 * kButtonWidth - 10, height() - 44.0, kButtonWidth, 32};
}

ScreenRect FormPanel::on_panel(ScreenRect rect) const {
  rect.top += content().top - scroll_;
  return rect;
}

bool FormPanel::in_sight(const ScreenRect& rect) const {
  return rect.top >= scroll_ && rect.top + rect.height <= scroll_ + content().height;
}

bool FormPanel::is_typed(std::size_t field) const {
  if (field >= model_.fields().size()) return false;
  const FieldKind kind = model_.fields()[field].kind;
  return kind == FieldKind::Text || kind == FieldKind::Number || kind == FieldKind::Integer;
}

std::vector<std::size_t> FormPanel::stops() const {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < model_.fields().size(); ++i)
    if (model_.is_shown(i) && model_.fields()[i].kind != FieldKind::Heading) all.push_back(i);
  if (!is_message()) all.push_back(cancel_stop());
  all.push_back(ok_stop());
  return all;
}

void FormPanel::go_to(std::size_t stop) {
  focus_ = stop;
  choice_ = 0;
  if (stop >= model_.fields().size()) return;
  editor_.set_text(model_.value(stop));
  editor_.select_all();
  const auto& choices = model_.fields()[stop].choices;
  for (std::size_t i = choices.size(); i-- > 0;)
    if (model_.is_chosen(stop, choices[i])) choice_ = i;
  if (const FormLine* line = context_ == nullptr ? nullptr : layout_.line_of(stop)) {
    if (line->top < scroll_) scroll_to(line->top);
    if (line->top + line->height > scroll_ + content().height)
      scroll_to(line->top + line->height - content().height);
  }
}

void FormPanel::go_on(int steps) {
  const auto all = stops();
  const int count = static_cast<int>(all.size());
  const int at = static_cast<int>(std::find(all.begin(), all.end(), focus_) - all.begin());
  go_to(all[static_cast<std::size_t>(((at % count) + steps + count) % count)]);
}

void FormPanel::scroll_to(double top) {
  scroll_ = std::clamp(top, 0.0, std::max(0.0, content_height() - content().height));
}

void FormPanel::edited() {
  model_.set_value(focus_, editor_.text());
  touched_.insert(focus_);
  message_.clear();
}

void FormPanel::choose(std::size_t field, std::size_t choice) {
  const auto& choices = model_.fields()[field].choices;
  model_.choose(field, choice < choices.size() ? choices[choice] : "");
  choice_ = choice;
  touched_.insert(field);
  message_.clear();
  lay_out();
  scroll_to(scroll_);
}

}  // namespace slalom
