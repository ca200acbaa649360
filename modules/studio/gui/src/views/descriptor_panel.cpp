// SPDX-License-Identifier: BSD-3-Clause
#include "views/panels.h"
#include "widgets/drawing.h"
#include "widgets/table.h"

#include <GLFW/glfw3.h>
#include <algorithm>
#include <array>
#include <functional>
#include <optional>

namespace slalom {
namespace {

constexpr double kTableHeaderHeight = 19, kTableRowHeight = 17,
                 kTableFooterHeight = 20;  ///< pixels
constexpr double kTwoColumnWidth = 760;    ///< min. width for two columns, pixels
constexpr double kValueWidth = 102;        ///< pixels, of "0.1234 +- 0.1234"
constexpr float kTableTextSize = 14;

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

constexpr double kTabHeight = 27, kChoiceHeight = 25;  ///< heights, pixels
constexpr double kTabWidth = 88, kArrowWidth = 24;     ///< pixels
constexpr int kNarrow = 560;                           ///< pixels in which two choices do not fit
constexpr double kNarrowTabWidth = 72;                 ///< pixels
constexpr double kMaxChoiceWidth = 280, kComputeWidth = 160;  ///< pixels
constexpr std::size_t kInitialY = 2;  ///< index of clearness, the initial y axis

struct TabName {
  const char *part, *title;
};
constexpr std::array<TabName, 3> kTabs = {
    {{"tab values", "Values"}, {"tab histogram", "Histogram"}, {"tab scatter", "Scatter"}}};

/// "3 of 22" for "computing... 3 of 22", for narrow panels.
std::string shortest(const std::string& status) {
  const std::size_t digit = status.find_first_of("0123456789");
  return status.rfind("computing", 0) == 0 && digit != std::string::npos ? status.substr(digit)
                                                                         : status;
}

/// The descriptors of the current scenario as a table, in two columns if it is wide enough. The
/// model must outlive it. Parts: "row density", ... (scrolls to the row).
class DescriptorTable : public Table {
 public:
  using Select = std::function<void(std::size_t row)>;
  DescriptorTable(nanogui::Widget* parent, const DescriptorModel& model, Select select)
      : Table(parent, "descriptor_values",
              {kTableHeaderHeight, kTableRowHeight, kTableFooterHeight}),
        model_(model),
        select_(std::move(select)) {}
  void show_selected() const { bring_into_view(cursor()); }
  std::string text() const override {
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
  std::optional<ScreenRect> rect_of(const std::string& part) const override {
    for (std::size_t row = 0; row < model_.rows().size(); ++row)
      if (part == "row " + model_.rows()[row].info.id) return bring_into_view(row);
    return Table::rect_of(part);
  }

 protected:
  std::size_t row_count() const override { return model_.rows().size(); }
  std::size_t columns() const override { return width() >= kTwoColumnWidth ? 2 : 1; }
  std::size_t cursor() const override { return model_.selected(); }
  void set_cursor(std::size_t row, int /*modifiers*/) override { select_(row); }
  void paint_row(NVGcontext* ctx, std::size_t row, const ScreenRect& rect) override {
    const Palette& colors = palette();
    const DescriptorModel::Row& what = model_.rows()[row];
    const bool selected = row == model_.selected();
    draw::row(ctx, rect, row, selected, hovered() == row);
    const RowCells cells(rect);
    const bool number =
        what.state == DescriptorModel::State::Known && !what.described.value.is_na();
    const bool failed = what.state == DescriptorModel::State::Failed;
    const Color& faint = selected ? colors.text : colors.faint_text;
    draw::text(ctx, cells.name, what.info.name, colors.text, kTableTextSize);
    draw::text(ctx, cells.value, DescriptorModel::value_text(what),
               failed   ? colors.error_text
               : number ? colors.text
                        : faint,
               kTableTextSize, draw::Align::Right);
    const std::string unit = what.info.unit == "-" ? "" : what.info.unit;
    const std::string reason = failed ? "" : model_.reason(what);
    draw::text(ctx, cells.rest, reason.empty() ? unit : reason, faint, draw::kSmallTextSize);
  }
  void paint_frame(NVGcontext* ctx) const override {
    const Palette& colors = palette();
    const double wide = area().width / static_cast<double>(columns());
    for (std::size_t column = 0; column < columns(); ++column) {
      const RowCells cells({static_cast<double>(column) * wide, 0, wide, kTableHeaderHeight});
      draw::text(ctx, cells.name, "descriptor", colors.faint_text, draw::kSmallTextSize);
      draw::text(ctx, cells.value, "value", colors.faint_text, draw::kSmallTextSize,
                 draw::Align::Right);
      draw::text(ctx, cells.rest, "unit", colors.faint_text, draw::kSmallTextSize);
    }
    const double top = height() - kTableFooterHeight;
    draw::line(ctx, 0, kTableHeaderHeight - 0.5, width(), kTableHeaderHeight - 0.5, colors.border);
    draw::line(ctx, 0, top + 0.5, width(), top + 0.5, colors.border);
    draw::text(ctx, {8, top + 1, width() - 16.0, kTableFooterHeight - 1},
               model_.describe(model_.rows()[hovered().value_or(model_.selected())]),
               colors.faint_text, draw::kSmallTextSize);
  }
  void hover(const std::optional<Point>& at) override {
    Table::hover(at);
    const std::string reason = hovered() ? model_.reason(model_.rows()[*hovered()]) : "";
    setTooltip(reason.empty() ? "" : "NA: " + reason);
  }

 private:
  const DescriptorModel& model_;
  Select select_;
};

/// The descriptors of the current scenario and their distribution in the list, in three tabs:
/// values, histogram, scatter plot. Keys: Tab and Shift+Tab switch tabs; Up and Down choose the
/// descriptor (of the scatter plot: x), Left and Right the one of y. Parts: "tab values", "tab
/// histogram", "tab scatter", "descriptor next", "descriptor previous", "x next", "x previous", "y
/// next", "y previous", "compute", and those of the current tab ("row density", "bin 3", "plot").
class DescriptorPanel : public Element {
 public:
  DescriptorPanel(nanogui::Widget* parent, Studio& studio)
      : Element(parent, "descriptors", Focus::OnPress),
        studio_(studio),
        model_(studio.descriptors().model()),
        y_(std::min(kInitialY, model_.rows().size() - 1)),
        table_(new DescriptorTable(this, model_, [this](std::size_t row) { select_row(row); })),
        histogram_(make_histogram(this, studio)),
        scatter_(make_scatter_plot(this, studio)) {
    set_tab(Tab::Values);
    update_plots();
    studio.events().observe({Change::Descriptors, Change::ListValues, Change::Current},
                            [this] { update_plots(); });
  }
  /// The elements of the tabs have a text() of their own.
  std::string text() const override {
    std::string text = model_.status();
    const std::string progress = studio_.describe_progress();
    if (!progress.empty()) text += (text.empty() ? "" : "\n") + progress;
    if (can_compute())
      text += (text.empty() ? "" : "\n") + std::to_string(missing()) +
              " values of the list are missing";
    return text;
  }
  void performLayout(NVGcontext* /*ctx*/) override {
    const auto set_top = [this](Element& element, double top) {
      element.set_bounds({0, top, area().width, height() - top});
    };
    set_top(*table_, kTabHeight);
    set_top(*histogram_, kTabHeight + kChoiceHeight);
    set_top(*scatter_, kTabHeight + (is_narrow() ? 2 : 1) * kChoiceHeight);
  }
  void click(const std::string& part) override {
    for (std::size_t i = 0; i < kTabs.size(); ++i)
      if (part == kTabs[i].part) set_tab(static_cast<Tab>(i));
    for (const std::string& choice : choices()) {
      if (part == choice + " previous") step(choice, -1);
      if (part == choice + " next") step(choice, 1);
    }
    if (part == "compute") studio_.describe_list();
  }

 protected:
  std::vector<Part> parts() const override {
    std::vector<Part> all;
    for (std::size_t i = 0; i < kTabs.size(); ++i)
      all.push_back({kTabs[i].part, tab_rect(static_cast<Tab>(i))});
    for (const std::string& choice : choices()) {
      ScreenRect rect = choice_rect(choice);
      const double right = rect.right();
      rect.width = kArrowWidth;
      all.push_back({choice + " previous", rect});
      rect.left = right - kArrowWidth;
      all.push_back({choice + " next", rect});
    }
    if (can_compute()) all.push_back({"compute", compute_rect()});
    return all;
  }
  void paint(NVGcontext* ctx) override {
    draw_tabs(ctx);
    draw_choices(ctx);
  }
  bool key(int key, int modifiers) override {
    if ((modifiers & ~GLFW_MOD_SHIFT) != 0) return false;
    const bool scatter = tab_ == Tab::Scatter;
    const int count = static_cast<int>(kTabs.size());
    const int by = (modifiers & GLFW_MOD_SHIFT) != 0 ? count - 1 : 1;
    const bool across = key == GLFW_KEY_LEFT || key == GLFW_KEY_RIGHT;
    if (across && !scatter) return false;
    const char* const descriptor = across ? "y" : scatter ? "x" : "descriptor";
    return run_key(key,
                   {{{GLFW_KEY_TAB},
                     [&] { set_tab(static_cast<Tab>((static_cast<int>(tab_) + by) % count)); }},
                    {{GLFW_KEY_UP, GLFW_KEY_LEFT}, [&] { step(descriptor, -1); }},
                    {{GLFW_KEY_DOWN, GLFW_KEY_RIGHT}, [&] { step(descriptor, 1); }},
                    {{GLFW_KEY_ENTER}, [&] {
                       if (can_compute()) studio_.describe_list();
                     }}});
  }

 private:
  enum class Tab { Values, Histogram, Scatter };
  Studio& studio_;
  DescriptorModel& model_;
  Tab tab_ = Tab::Values;
  std::size_t x_ = 0, y_ = 0;  ///< rows of the model
  DescriptorTable* table_;
  ListPlot *histogram_, *scatter_;

  const QuantityInfo& info_of(std::size_t row) const { return model_.rows()[row].info; }
  void set_tab(Tab tab) {
    tab_ = tab;
    table_->setVisible(tab == Tab::Values);
    histogram_->setVisible(tab == Tab::Histogram);
    scatter_->setVisible(tab == Tab::Scatter);
    if (tab == Tab::Values) table_->show_selected();
    choice_changed();
  }
  void select_row(std::size_t row) {
    if (!model_.select_row(row)) return;
    table_->show_selected();
    choice_changed();
  }
  void step(const std::string& choice, int by) {
    const auto moved = [&](std::size_t row) {
      const std::size_t count = model_.rows().size();
      return (row + (by > 0 ? 1 : count - 1)) % count;
    };
    if (choice == "descriptor") return select_row(moved(model_.selected()));
    (choice == "x" ? x_ : y_) = moved(choice == "x" ? x_ : y_);
    choice_changed();
  }
  void update_plots() {
    histogram_->update(model_.selected_row().info, {});
    scatter_->update(info_of(x_), info_of(y_));
  }
  void choice_changed() {
    update_plots();
    studio_.track_descriptors(shown_ids());
  }
  /// The descriptors whose values over the list are displayed: none, one or two.
  std::vector<std::string> shown_ids() const {
    if (tab_ == Tab::Values) return {};
    if (tab_ == Tab::Histogram) return {model_.selected_row().info.id};
    if (x_ == y_) return {info_of(x_).id};
    return {info_of(x_).id, info_of(y_).id};
  }
  /// The number of values of shown_ids() that are not computed.
  std::size_t missing() const {
    const auto& values = studio_.descriptors().list_values();
    std::size_t missing = 0;
    for (const std::string& id : shown_ids())
      if (const ListColumn* column = values ? values->column(id) : nullptr)
        missing += column->not_computed_count();
    return missing;
  }
  bool can_compute() const { return studio_.describe_progress().empty() && missing() > 0; }
  /// "descriptor", or "x" and "y".
  std::vector<std::string> choices() const {
    if (tab_ == Tab::Values) return {};
    if (tab_ == Tab::Histogram) return {"descriptor"};
    return {"x", "y"};
  }
  /// In a narrow panel the choices are stacked, and the compute button is next to the tabs.
  bool is_narrow() const { return width() < kNarrow; }
  ScreenRect tab_rect(Tab tab) const {
    const double tab_width = is_narrow() ? kNarrowTabWidth : kTabWidth;
    return {static_cast<int>(tab) * tab_width, 0, tab_width, kTabHeight};
  }
  ScreenRect choice_rect(const std::string& choice) const {
    if (is_narrow())
      return {0, choice == "y" ? kTabHeight + kChoiceHeight : kTabHeight, area().width,
              kChoiceHeight};
    const double wide = std::min((width() - kComputeWidth - 12) / 2, kMaxChoiceWidth);
    return {choice == "y" ? wide : 0, kTabHeight, wide, kChoiceHeight};
  }
  ScreenRect compute_rect() const {
    if (is_narrow()) {
      const double left = tab_rect(Tab::Scatter).right() + 4;
      return {left, 3, width() - left - 4, kTabHeight - 6};
    }
    return {width() - kComputeWidth - 4, kTabHeight + 2, kComputeWidth, kChoiceHeight - 4};
  }
  void draw_tabs(NVGcontext* ctx) const {
    const Palette& colors = palette();
    draw::fill(ctx, {0, 0, area().width, kTabHeight}, colors.window);
    for (std::size_t i = 0; i < kTabs.size(); ++i) {
      const ScreenRect rect = tab_rect(static_cast<Tab>(i));
      draw::tab(ctx, rect, rect, kTabs[i].title, static_cast<Tab>(i) == tab_, false,
                draw::Align::Center);
    }
    const double left = tab_rect(Tab::Scatter).right();
    const bool of_list = model_.status().empty() || tab_ != Tab::Values;
    const std::string status = of_list ? studio_.describe_progress() : model_.status();
    draw::text(ctx, ScreenRect{left, 0, width() - left, kTabHeight}.inset(8),
               is_narrow() ? shortest(status) : status,
               !of_list && model_.failed() ? colors.error_text : colors.faint_text,
               draw::kSmallTextSize, draw::Align::Right);
  }
  void draw_choices(NVGcontext* ctx) const {
    const Palette& colors = palette();
    if (tab_ != Tab::Values)
      draw::fill(ctx, {0, kTabHeight, area().width, 2 * kChoiceHeight}, colors.panel);
    for (const std::string& choice : choices()) {
      const ScreenRect rect = choice_rect(choice);
      const ScreenRect name = rect.inset(kArrowWidth);
      draw::text(ctx, {rect.left, rect.top, kArrowWidth, rect.height}, "‹", colors.accent, 20,
                 draw::Align::Center, true);
      draw::text(ctx, {name.right(), rect.top, kArrowWidth, rect.height}, "›", colors.accent, 20,
                 draw::Align::Center, true);
      const std::size_t row = choice == "descriptor" ? model_.selected() : choice == "x" ? x_ : y_;
      draw::text(ctx, name, (choice == "descriptor" ? "" : choice + ": ") + info_of(row).name,
                 colors.text, draw::kTextSize, draw::Align::Center);
    }
    if (can_compute())
      draw::button(ctx, compute_rect(),
                   "compute " + std::to_string(missing()) + (is_narrow() ? "" : " missing"), {true},
                   draw::kSmallTextSize);
  }
};

}  // namespace

Element* make_descriptor_panel(nanogui::Widget* parent, Studio& studio) {
  return new DescriptorPanel(parent, studio);
}

}  // namespace slalom
