#include "list_row_sizes.h"

#include <slalom/core/text.h>
#include <slalom/gui/list_rows.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr std::size_t kMostPictures = 400;  // 6.5 MB of textures

/// The number behind a word, "row 12".
std::optional<std::size_t> number_after(const std::string& word, const std::string& part) {
  long long number = 0;
  if (part.rfind(word, 0) != 0 || !parse_integer(part.substr(word.size()), number) || number < 0)
    return std::nullopt;
  return static_cast<std::size_t>(number);
}

}  // namespace

ListRows::ListRows(nanogui::Widget* parent)
    // What is left of them at the end goes with NanoVG's context, which does not outlive the
    // window.
    : Element(parent, "rows"), pictures_(kMostPictures, [this](Picture& picture) {
        if (picture && context_ != nullptr) nvgDeleteImage(context_, *picture);
      }) {}

void ListRows::set_document(ListDocument* document) {
  if (document == document_) return;
  document_ = document;
  scroll_ = 0;
  head_.reset();
  hovered_.reset();
  followed_.clear();
}

double ListRows::content_height() const {
  return document_ == nullptr ? 0 : lines().top_of(lines().size(), kLineHeights);
}

double ListRows::most_scroll() const {
  return std::max(content_height() - height(), 0.0);
}

double ListRows::scroll() const {
  return std::clamp(scroll_, 0.0, most_scroll());
}

void ListRows::scroll_by(double pixels) {
  scroll_ = std::clamp(scroll() + pixels, 0.0, most_scroll());
}

void ListRows::bring_into_view(std::size_t line) const {
  const double top = lines().top_of(line, kLineHeights);
  const double bottom = lines().top_of(line + 1, kLineHeights);
  scroll_ = std::min(std::max(scroll(), bottom - height()), top);
}

void ListRows::scroll_to_current() {
  if (document_ == nullptr) return;
  followed_ = document_->current();
  const auto place = document_->view().place_of(followed_);
  const auto line = place ? lines().line_of(*place) : std::nullopt;
  if (line) bring_into_view(*line);
}

ScreenRect ListRows::line_rect(std::size_t line) const {
  const double top = lines().top_of(line, kLineHeights);
  const double bottom = lines().top_of(line + 1, kLineHeights);
  const double across = width() - (most_scroll() > 0 ? kBarWidth : 0);
  return {0, std::round(top - scroll()), across, bottom - top};
}

std::optional<std::size_t> ListRows::line_below(const nanogui::Vector2i& p) const {
  if (document_ == nullptr || lines().size() == 0) return std::nullopt;
  const double y = p.y() - mPos.y() + scroll();
  if (y < 0 || y >= content_height() || p.x() - mPos.x() >= line_rect(0).width) return std::nullopt;
  return lines().line_at(y, kLineHeights);
}

std::optional<ScreenRect> ListRows::bar() const {
  constexpr double kLeast = 28;
  if (most_scroll() <= 0) return std::nullopt;
  const double tall = std::max(height() * height() / content_height(), kLeast);
  const double top = (height() - tall) * scroll() / most_scroll();
  return ScreenRect{width() - kBarWidth, top, kBarWidth, tall};
}

std::optional<ScreenRect> ListRows::rect_of(const std::string& part) const {
  if (part == "bar") return bar();
  if (document_ == nullptr || part.empty()) return Element::rect_of(part);
  std::optional<std::size_t> line;
  if (const auto place = number_after("row ", part))
    line = *place < document_->view().hashes.size() ? lines().line_of(*place) : std::nullopt;
  else if (const auto group = number_after("group ", part))
    if (*group < document_->view().groups.size()) line = lines().line_of_group(*group);
  if (!line) return std::nullopt;
  bring_into_view(*line);
  return line_rect(*line);
}

std::string value_text(const ListRow& row, const std::string& unit) {
  if (!row.value) return "not computed";
  if (row.value->is_na()) return "NA";
  const std::string number = format_fixed(row.value->number(), 3);
  return unit == "-" ? number : number + " " + unit;
}

std::string ListRows::row_text(std::size_t place) const {
  const ListRow* row = document_->row(document_->view().hashes[place]);
  if (row == nullptr) return "";
  std::string text = "row " + std::to_string(place) + ": " + row->entry.name + ", " + row->entry.id;
  if (!row->entry.tags.empty()) text += ", tags " + join(row->entry.tags, " ");
  const std::string& sort = document_->request().sort;
  if (!sort.empty() && sort != "name") {
    text += ", " + sort + " " + value_text(*row, document_->sort_unit());
    if (row->value && row->value->is_na()) text += " (" + row->value->reason() + ")";
  }
  if (document_->view().hashes[place] == document_->current()) text += ", current";
  if (document_->is_selected(place)) text += ", selected";
  return text;
}

std::string ListRows::text() const {
  if (document_ == nullptr) return "";
  std::string text;
  if (lines().size() == 0) return text;
  for (std::size_t line = lines().line_at(scroll(), kLineHeights);
       line < lines().size() && line_rect(line).top < height(); ++line) {
    const ListLines::Line what = lines().at(line);
    if (!text.empty()) text += "\n";
    if (what.group)
      text += "group " + std::to_string(*what.group) + ": " +
              document_->view().groups[*what.group].title + ", " +
              std::to_string(document_->view().groups[*what.group].count) +
              (lines().is_closed(*what.group) ? ", closed" : "");
    else
      text += row_text(what.place);
  }
  return text;
}

void ListRows::take_picture(const std::string& hash, const Thumbnail& picture) {
  arrived_.emplace_back(hash, picture);
}

}  // namespace slalom
