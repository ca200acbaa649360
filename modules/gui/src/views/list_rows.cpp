#include "views/list_rows.h"

#include <slalom/core/text.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr std::size_t kMaxTextures = 400;  // 6.5 MB of textures

/// Parses the number after a prefix, as in "row 12".
std::optional<std::size_t> number_after(const std::string& prefix, const std::string& part) {
  long long number = 0;
  if (part.rfind(prefix, 0) != 0 || !parse_integer(part.substr(prefix.size()), number) ||
      number < 0)
    return std::nullopt;
  return static_cast<std::size_t>(number);
}

}  // namespace

ListRows::ListRows(nanogui::Widget* parent, Studio& studio)
    : Element(parent, "rows", Focus::OnPress),
      studio_(studio),
      thumbnails_(studio.jobs(),
                  [this](const std::string& hash, const Thumbnail& thumbnail) {
                    pending_thumbnails_.emplace_back(hash, thumbnail);
                  }),
      // Remaining textures are deleted with NanoVG's context, which the window destroys.
      textures_(kMaxTextures, [this](Texture& texture) {
        if (texture && context_ != nullptr) nvgDeleteImage(context_, *texture);
      }) {
  studio.notices().observe([this](Change change) {
    if (change == Change::Documents) documents_changed();
  });
}

void ListRows::documents_changed() {
  scroll_ = {};
  focused_group_.reset();
  hovered_.reset();
  scrolled_to_.clear();
}

void ListRows::update_scroll() const {
  scroll_.set(has_lines() ? lines().top_of(lines().size(), kLineHeights) : 0, area());
}

void ListRows::bring_into_view(std::size_t line) const {
  update_scroll();
  scroll_.show(lines().top_of(line, kLineHeights), lines().top_of(line + 1, kLineHeights));
}

void ListRows::scroll_to_current() {
  scrolled_to_ = document()->current();
  const auto index = document()->view().index_of(scrolled_to_);
  const auto line = index ? lines().line_of(*index) : std::nullopt;
  if (line) bring_into_view(*line);
}

ScreenRect ListRows::line_rect(std::size_t line) const {
  const double top = lines().top_of(line, kLineHeights);
  const double bottom = lines().top_of(line + 1, kLineHeights);
  const double line_width = width() - (scroll_.thumb() ? Scroll::kBarWidth : 0);
  return {0, std::round(top - scroll_.offset()), line_width, bottom - top};
}

std::optional<std::size_t> ListRows::line_at(const Point& at) const {
  if (!has_lines()) return std::nullopt;
  update_scroll();
  const std::size_t line = lines().line_at(at.y + scroll_.offset(), kLineHeights);
  return line_rect(line).contains(at) ? std::optional(line) : std::nullopt;
}

std::optional<ScreenRect> ListRows::rect_of(const std::string& part) const {
  update_scroll();
  if (part == "bar") return scroll_.thumb();
  if (document() == nullptr || part.empty()) return Element::rect_of(part);
  std::optional<std::size_t> line;
  if (const auto index = number_after("row ", part))
    line = *index < document()->view().hashes.size() ? lines().line_of(*index) : std::nullopt;
  else if (const auto group = number_after("group ", part))
    if (*group < document()->view().groups.size()) line = lines().line_of_group(*group);
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

std::string ListRows::row_text(std::size_t index) const {
  const ListRow* row = document()->row(document()->view().hashes[index]);
  if (row == nullptr) return "";
  std::string text = "row " + std::to_string(index) + ": " + row->entry.name + ", " + row->entry.id;
  if (!row->entry.tags.empty()) text += ", tags " + join(row->entry.tags, " ");
  const std::string& sort = document()->request().sort;
  if (!sort.empty() && sort != "name") {
    text += ", " + sort + " " + value_text(*row, document()->sort_unit());
    if (row->value && row->value->is_na()) text += " (" + row->value->reason() + ")";
  }
  if (document()->view().hashes[index] == document()->current()) text += ", current";
  if (document()->is_selected(index)) text += ", selected";
  return text;
}

std::string ListRows::text() const {
  if (!has_lines()) return "";
  update_scroll();
  std::string text;
  for (std::size_t line = lines().line_at(scroll_.offset(), kLineHeights);
       line < lines().size() && line_rect(line).top < height(); ++line) {
    const ListLines::Line item = lines().at(line);
    if (!text.empty()) text += "\n";
    if (item.group)
      text += "group " + std::to_string(*item.group) + ": " +
              document()->view().groups[*item.group].title + ", " +
              std::to_string(document()->view().groups[*item.group].count) +
              (lines().is_closed(*item.group) ? ", closed" : "");
    else
      text += row_text(item.index);
  }
  return text;
}

bool ListRows::press(const Point& at, int modifiers) {
  update_scroll();
  if (scroll_.press(at)) return true;
  const auto line = line_at(at);
  if (!line) return true;
  const ListLines::Line item = lines().at(*line);
  focused_group_ = item.group;
  item.group ? document()->toggle_group(*item.group) : select(item.index, modifiers);
  return true;
}

void ListRows::select(std::size_t index, int modifiers) {
  if ((modifiers & GLFW_MOD_SHIFT) != 0)
    document()->select_to(index);
  else if ((modifiers & GLFW_MOD_CONTROL) != 0)
    document()->toggle(index);
  else
    document()->select_only(index);
}

void ListRows::hover(const std::optional<Point>& at) {
  hovered_ = at ? line_at(*at) : std::nullopt;
  if (!hovered_) return;
  const ListLines::Line item = lines().at(*hovered_);
  const ListRow* row =
      item.group ? nullptr : document()->row(document()->view().hashes[item.index]);
  const bool has_reason = row != nullptr && row->value && row->value->is_na();
  setTooltip(has_reason ? "NA: " + row->value->reason() : "");
}

bool ListRows::wheel(const Point& at, double steps) {
  update_scroll();
  scroll_.wheel(steps);
  hover(at);
  return true;
}

std::size_t ListRows::cursor_line() const {
  if (focused_group_ && *focused_group_ < document()->view().groups.size())
    return lines().line_of_group(*focused_group_);
  const auto index = document()->view().index_of(document()->current());
  if (!index) return 0;
  if (const auto line = lines().line_of(*index)) return *line;
  return lines().line_of_group(lines().group_of(*index).value_or(0));
}

void ListRows::go_to_line(std::size_t line, int modifiers) {
  const ListLines::Line item = lines().at(line);
  bring_into_view(line);
  focused_group_ = item.group;
  if (item.group) return;
  if (modifiers == GLFW_MOD_CONTROL)
    document()->set_current(document()->view().hashes[item.index]);
  else
    select(item.index, modifiers & GLFW_MOD_SHIFT);
  scrolled_to_ = document()->current();
}

bool ListRows::set_group_closed(bool closed) {
  const auto index = document()->view().index_of(document()->current());
  const auto group = focused_group_ ? focused_group_
                     : index        ? lines().group_of(*index)
                                    : std::nullopt;
  if (!group || *group >= document()->view().groups.size()) return false;
  if (lines().is_closed(*group) != closed) document()->toggle_group(*group);
  if (closed) focused_group_ = group;
  return true;
}

bool ListRows::key(int key, int modifiers) {
  if (!has_lines() || (modifiers & GLFW_MOD_ALT) != 0) return false;
  if (focused_group_ && *focused_group_ >= document()->view().groups.size()) focused_group_.reset();
  const std::size_t at = cursor_line(), last = lines().size() - 1;
  const auto page = static_cast<std::size_t>(std::max(height() / kLineHeights.scenario - 1, 1.0));
  const auto index = document()->view().index_of(document()->current());
  switch (key) {
    case GLFW_KEY_UP:
      go_to_line(at > 0 ? at - 1 : 0, modifiers);
      return true;
    case GLFW_KEY_DOWN:
      go_to_line(std::min(at + 1, last), modifiers);
      return true;
    case GLFW_KEY_PAGE_UP:
      go_to_line(at > page ? at - page : 0, modifiers);
      return true;
    case GLFW_KEY_PAGE_DOWN:
      go_to_line(std::min(at + page, last), modifiers);
      return true;
    case GLFW_KEY_HOME:
      go_to_line(0, modifiers);
      return true;
    case GLFW_KEY_END:
      go_to_line(last, modifiers);
      return true;
    case GLFW_KEY_LEFT:
    case GLFW_KEY_RIGHT:
      return set_group_closed(key == GLFW_KEY_LEFT);
    case GLFW_KEY_SPACE:
      if (focused_group_)
        document()->toggle_group(*focused_group_);
      else if (index)
        document()->toggle(*index);
      return true;
    case GLFW_KEY_A:
      if ((modifiers & GLFW_MOD_CONTROL) == 0) return false;
      document()->select_all();
      return true;
    case GLFW_KEY_ESCAPE:
      if (document()->selected_count() == 0) return false;
      document()->select_none();
      return true;
    default:
      return false;
  }
}

}  // namespace slalom
