// SPDX-License-Identifier: BSD-3-Clause
#include "views/filter_box.h"
#include "views/panels.h"
#include "widgets/drawing.h"
#include "widgets/menu.h"

#include <slalom/commands/describe_list.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>

#include <GLFW/glfw3.h>
#include <algorithm>
#include <cmath>
#include <optional>

namespace slalom {
namespace {

const char* const kListOrder = "list order";
const char* const kNoGroups = "no groups";
const std::string kResultsOf = "results of ";

constexpr double kListMargin = 6, kControlHeight = 28, kTabBarHeight = 32, kListFooterHeight = 26;
constexpr double kMinTabWidth = 90, kMaxTabWidth = 200, kCloseWidth = 22;
constexpr double kMaxMessageHeight = 80;  // pixels
constexpr float kMessageSize = draw::kSmallTextSize + 1;

/// Returns `text`, or its beginning and "…" so that it is at most kMaxMessageHeight high.
std::string elided_message(NVGcontext* ctx, const std::string& text, double width) {
  return draw::elided(text, [&](const std::string& shown) {
    return draw::wrapped_height(ctx, shown, width, kMessageSize) <= kMaxMessageHeight;
  });
}

double controls_top(double message_height) {
  return kTabBarHeight + kListMargin + kControlHeight + kListMargin + message_height;
}

/// The open lists: a tab for each, and filter, sorting, groups, rows and counts of the active list.
///
/// Keys besides those of the rows: F (filter), S (sort by), D (direction), G (groups), Ctrl+Page
/// Up, Ctrl+Page Down (previous and next tab).
///
/// Parts: "tab 0", "close 0", "clear" (of a filter), "sort", "direction", "group_by", and those of
/// the rows. Its elements have the ids "filter", "rows" and, while a drop-down list is open,
/// "choices".
class ListPanel : public Element {
 public:
  ListPanel(nanogui::Widget* parent, Studio& studio)
      : Element(parent, "list", Focus::OnPress),
        studio_(studio),
        filter_(new FilterBox(this, [this] { leave_filter(); })),
        rows_(make_list_rows(this, studio)),
        choices_(new Menu(this, "choices", rows_)) {
    filter_->setFontSize(15);
    filter_->setCallback([this](const std::string& text) {
      if (document() != nullptr) document()->set_filter(text);
      return true;
    });
    documents_changed();
    studio.events().observe({Change::Documents}, [this] { documents_changed(); });
  }
  void click(const std::string& part) override {
    const bool closes = part.rfind("close ", 0) == 0;
    if (closes || part.rfind("tab ", 0) == 0) {
      const std::size_t tab = std::stoul(part.substr(part.find(' ') + 1));
      return closes ? studio_.close_list(tab) : studio_.activate(tab);
    }
    if (document() == nullptr) return;
    if (part == "clear") clear_filter();
    if (part == "sort") choose_sort();
    if (part == "group_by") choose_group();
    if (part == "direction")
      document()->set_sort(document()->request().sort, !document()->request().descending);
  }
  std::string text() const override {
    std::string text;
    for (std::size_t i = 0; i < studio_.documents().size(); ++i)
      text += "tab " + std::to_string(i) + ": " + studio_.documents()[i]->title() +
              (i == studio_.active_index() ? ", active\n" : "\n");
    if (document() != nullptr) {
      text += "sort: " + sort_text() +
              (document()->request().descending ? ", descending\n" : ", ascending\n");
      text += "groups: " + group_text() + "\n";
    }
    if (!message().empty()) text += message() + "\n";
    return text + footer_text();
  }
  /// Scrolls to a tab.
  std::optional<ScreenRect> rect_of(const std::string& part) const override {
    for (std::size_t tab = 0; tab < studio_.documents().size(); ++tab)
      if (part == "tab " + std::to_string(tab) || part == "close " + std::to_string(tab))
        show_tab(tab);
    return Element::rect_of(part);
  }
  void performLayout(NVGcontext* ctx) override {
    Element::performLayout(ctx);
    arrange();
  }

 protected:
  std::vector<Part> parts() const override {
    std::vector<Part> all;
    const std::size_t tabs = studio_.documents().size();
    const std::size_t visible = std::max<std::size_t>(std::min(visible_tab_count(), tabs), 1);
    const double tab_width =
        std::min(std::floor((width() - kListMargin) / static_cast<double>(visible)), kMaxTabWidth);
    double left = kListMargin;
    for (std::size_t tab = first_tab_; tab < std::min(tabs, first_tab_ + visible); ++tab) {
      const ScreenRect rect{left, 4, tab_width - 4, kTabBarHeight - 4};
      all.push_back({"close " + std::to_string(tab),
                     {rect.right() - kCloseWidth, rect.top, kCloseWidth, rect.height}});
      all.push_back({"tab " + std::to_string(tab), rect});
      left += tab_width;
    }
    if (!shown_filter_.empty())
      all.push_back({"clear",
                     {width() - kListMargin - kCloseWidth, kTabBarHeight + kListMargin, kCloseWidth,
                      kControlHeight}});
    const double top = controls_top(message_height_), available = width() - 2 * kListMargin;
    const double sort = std::floor(0.52 * (available - kControlHeight - 8));
    const double direction = kListMargin + sort + 4, group = direction + kControlHeight + 4;
    all.push_back({"sort", {kListMargin, top, sort, kControlHeight}});
    all.push_back({"direction", {direction, top, kControlHeight, kControlHeight}});
    all.push_back({"group_by", {group, top, width() - kListMargin - group, kControlHeight}});
    return all;
  }
  void paint(NVGcontext* ctx) override {
    const Palette& colors = palette();
    if (document() != nullptr && document()->filter_text() != shown_filter_) {
      shown_filter_ = document()->filter_text();
      if (!filter_->focused()) filter_->setValue(shown_filter_);
      arrange();
    }
    draw::fill(ctx, area(), colors.panel);
    draw::fill(ctx, {0, 0, area().width, kTabBarHeight}, colors.window);
    for (std::size_t tab = 0; tab < studio_.documents().size(); ++tab) draw_tab(ctx, tab);
    const double message_height = draw_message(ctx);
    if (message_height != message_height_) {
      message_height_ = message_height;
      arrange();
    }
    if (!shown_filter_.empty()) draw_cross(ctx, "clear");
    draw_control(ctx, "sort", "Sort: " + sort_text());
    draw_direction(ctx);
    draw_control(ctx, "group_by", group_text());
    const double footer_top = height() - kListFooterHeight;
    draw::line(ctx, 0, footer_top + 0.5, width(), footer_top + 0.5, colors.border);
    draw::text(ctx, {kListMargin, footer_top, width() - 2 * kListMargin, kListFooterHeight},
               footer_text(), colors.faint_text, draw::kSmallTextSize + 1);
  }
  /// A click beside an open drop-down list only closes it.
  bool press(const Point& at, int /*modifiers*/) override {
    if (filter_->focused()) rows_->requestFocus();
    choices_->visible() ? choices_->close() : click(part_at(at));
    return true;
  }
  void hover(const std::optional<Point>& at) override {
    hovered_ = at ? part_at(*at) : "";
    if (hovered_.rfind("tab ", 0) == 0)
      setTooltip(studio_.documents()[std::stoul(hovered_.substr(4))]->path());
    else if (hovered_ == "clear")
      setTooltip("Clears the filter.");
    else
      setTooltip(at && message_rect().contains(*at) ? message() : "");
  }
  bool key(int key, int modifiers) override {
    if (document() == nullptr) return false;
    const std::size_t tabs = studio_.documents().size();
    if (modifiers == GLFW_MOD_CONTROL && (key == GLFW_KEY_PAGE_UP || key == GLFW_KEY_PAGE_DOWN)) {
      const std::size_t by = key == GLFW_KEY_PAGE_UP ? tabs - 1 : 1;
      studio_.activate((studio_.active_index() + by) % tabs);
      return true;
    }
    if (modifiers != 0) return false;
    return run_key(key, {{{GLFW_KEY_F}, [&] { filter_->requestFocus(); }},
                         {{GLFW_KEY_S}, [&] { click("sort"); }},
                         {{GLFW_KEY_D}, [&] { click("direction"); }},
                         {{GLFW_KEY_G}, [&] { click("group_by"); }}});
  }

 private:
  ListDocument* document() const { return studio_.active(); }
  /// Below the filter; empty for none.
  std::string message() const {
    if (document() == nullptr) return "";
    const std::string& error = document()->filter_error();
    return !error.empty() ? error : document()->notice();
  }
  std::string footer_text() const {
    if (document() == nullptr) return "no list is open";
    const ListView& view = document()->view();
    std::string text = std::to_string(document()->selected_count()) + " selected, ";
    if (view.hashes.size() < view.total) text += std::to_string(view.hashes.size()) + " of ";
    text += count_text(view.total, "scenario");
    return document()->is_computing() ? text + ", sorting" : text;
  }
  std::string sort_text() const {
    const std::string sort = document() != nullptr ? document()->request().sort : "";
    return sort.empty() ? kListOrder : sort;
  }
  std::string group_text() const {
    const std::string index = document() != nullptr ? document()->request().group_by : "";
    return index.empty() ? kNoGroups : index;
  }
  void open_choices(const std::string& part, const std::vector<std::string>& choices,
                    const std::string& current, Menu::Chosen chosen) {
    std::vector<MenuLine> lines;
    for (const std::string& choice : choices) lines.push_back({"choice " + choice, choice});
    const auto at = std::find(choices.begin(), choices.end(), current);
    const ScreenRect control = *rect_of(part);
    choices_->open({control.left, control.bottom()}, width() - control.left - rect_of("sort")->left,
                   height(), std::move(lines), static_cast<std::size_t>(at - choices.begin()),
                   std::move(chosen));
  }
  void documents_changed() {
    choices_->setVisible(false);
    shown_filter_ = document() != nullptr ? document()->filter_text() : "";
    filter_->set_text(shown_filter_);
    filter_->setEnabled(document() != nullptr);
    arrange();
    show_tab(studio_.active_index());
  }
  void arrange() {
    const int margin = static_cast<int>(kListMargin);
    filter_->setPosition({margin, static_cast<int>(kTabBarHeight + kListMargin)});
    const int cross = shown_filter_.empty() ? 0 : static_cast<int>(kCloseWidth);
    filter_->setSize({std::max(width() - 2 * margin - cross, 1), static_cast<int>(kControlHeight)});
    const double top = controls_top(message_height_) + kControlHeight + kListMargin;
    rows_->set_bounds({0, top, area().width, height() - kListFooterHeight - top});
  }
  void leave_filter() {
    if (document() != nullptr) document()->restore_filter();
    if (document() != nullptr) filter_->set_text(document()->filter_text());
    rows_->requestFocus();  // applies the text
  }
  void clear_filter() {
    filter_->set_text("");
    document()->set_filter("");
    filter_->requestFocus();
  }
  std::size_t visible_tab_count() const {
    return static_cast<std::size_t>(std::max((width() - kListMargin) / kMinTabWidth, 1.0));
  }
  void show_tab(std::size_t tab) const {
    first_tab_ =
        std::min(std::max(first_tab_, tab + 1 - std::min(tab + 1, visible_tab_count())), tab);
  }
  void choose_sort() {
    std::vector<std::string> choices = {kListOrder, "name"};
    for (const std::string& id : descriptor_ids()) choices.push_back(id);
    const std::size_t first_method = choices.size();
    const auto results = document()->request().results;
    if (results)
      for (const std::string& method : results->methods())
        choices.push_back(kResultsOf + method + "...");
    open_choices("sort", choices, sort_text(), [=](std::size_t choice) {
      if (choice >= first_method) return choose_result(results->methods()[choice - first_method]);
      document()->set_sort(choice == 0 ? "" : choices[choice], document()->request().descending);
    });
  }
  void choose_result(const std::string& method) {
    const auto choices = document()->request().results->of_method(method);
    open_choices("sort", choices, sort_text(), [this, choices](std::size_t choice) {
      document()->set_sort(choices[choice], document()->request().descending);
    });
  }
  void choose_group() {
    std::vector<std::string> choices = {kNoGroups};
    for (const ListIndex& index : document()->indexes()) choices.push_back(index.name);
    open_choices("group_by", choices, group_text(), [this, choices](std::size_t choice) {
      document()->set_group_by(choice == 0 ? "" : choices[choice]);
    });
  }
  /// Returns its height.
  double draw_message(NVGcontext* ctx) {
    if (message().empty()) return 0;
    const double text_width = width() - 2 * kListMargin;
    if (message() != message_ || text_width != message_width_) {
      message_ = message();
      message_width_ = text_width;
      elided_message_ = elided_message(ctx, message_, text_width);
    }
    const bool error = !document()->filter_error().empty();
    return std::ceil(draw::wrapped_text(ctx, message_rect(), elided_message_,
                                        error ? palette().error_text : palette().faint_text,
                                        kMessageSize)) +
           4;
  }
  ScreenRect message_rect() const {
    return ScreenRect{kListMargin, kTabBarHeight + kListMargin + kControlHeight + 4,
                      width() - 2 * kListMargin, message_height_};
  }
  void draw_tab(NVGcontext* ctx, std::size_t tab) const {
    const std::string number = std::to_string(tab);
    const auto rect = Element::rect_of("tab " + number);
    if (!rect) return;  // scrolled out of view
    draw::tab(ctx, *rect, {rect->left + 8, rect->top, rect->width - kCloseWidth - 10, rect->height},
              studio_.documents()[tab]->title(), tab == studio_.active_index(),
              hovered_ == "tab " + number);
    draw_cross(ctx, "close " + number);
  }
  /// The cross of a part that closes or clears.
  void draw_cross(NVGcontext* ctx, const std::string& part) const {
    const auto rect = Element::rect_of(part);
    if (!rect) return;
    const double x = rect->left + 0.5 * rect->width, y = rect->top + 0.5 * rect->height;
    const Color& ink = hovered_ == part ? palette().error_text : palette().faint_text;
    draw::line(ctx, x - 4, y - 4, x + 4, y + 4, ink, 1.5F);
    draw::line(ctx, x - 4, y + 4, x + 4, y - 4, ink, 1.5F);
  }
  void draw_control(NVGcontext* ctx, const std::string& part, const std::string& text) const {
    const Palette& colors = palette();
    const ScreenRect rect = *rect_of(part);
    draw::fill(ctx, rect, hovered_ == part ? colors.hover : colors.window, 3);
    draw::frame(ctx, rect, colors.border);
    draw::text(ctx, {rect.left + 8, rect.top, rect.width - 26, rect.height}, text,
               document() != nullptr ? colors.text : colors.disabled_text);
    const double x = rect.right() - 12, y = rect.top + 0.5 * rect.height;
    draw::triangle(ctx, {x - 5, y - 2}, {x + 5, y - 2}, {x, y + 4}, colors.faint_text);
  }
  void draw_direction(NVGcontext* ctx) const {
    const Palette& colors = palette();
    const ScreenRect rect = *rect_of("direction");
    draw::fill(ctx, rect, hovered_ == "direction" ? colors.hover : colors.window, 3);
    draw::frame(ctx, rect, colors.border);
    const bool down = document() != nullptr && document()->request().descending;
    const double x = rect.left + 0.5 * rect.width, y = rect.top + 0.5 * rect.height;
    const double tip = down ? y + 8 : y - 8, back = down ? y + 3 : y - 3;
    draw::line(ctx, x, y - 8, x, y + 8, colors.text, 1.5F);
    draw::line(ctx, x - 5, back, x, tip, colors.text, 1.5F);
    draw::line(ctx, x + 5, back, x, tip, colors.text, 1.5F);
  }

  Studio& studio_;
  mutable std::size_t first_tab_ = 0;
  std::string hovered_;  ///< part under the mouse
  double message_height_ = 0, message_width_ = 0;
  std::string message_, elided_message_;
  std::string shown_filter_;  ///< to notice when the filter of the document changes
  FilterBox* filter_;
  Element* rows_;
  Menu* choices_;
};

}  // namespace

Element* make_list_panel(nanogui::Widget* parent, Studio& studio) {
  return new ListPanel(parent, studio);
}

}  // namespace slalom
