#pragma once

#include "views/list_plots.h"
#include "widgets/table.h"

#include <slalom/studio/descriptor_loader.h>
#include <slalom/studio/studio.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The descriptors of the current scenario as a table, in two columns if it is wide enough. The
/// model must outlive it. Parts: "row density", ... (scrolls to the row).
class DescriptorTable : public Table {
 public:
  using Select = std::function<void(std::size_t row)>;
  DescriptorTable(nanogui::Widget* parent, const DescriptorModel& model, Select select);
  void show_selected() const { bring_into_view(cursor()); }
  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;

 protected:
  std::size_t row_count() const override { return model_.rows().size(); }
  std::size_t columns() const override;
  std::size_t cursor() const override { return model_.selected(); }
  void set_cursor(std::size_t row, int /*modifiers*/) override { select_(row); }
  void paint_row(NVGcontext* ctx, std::size_t row, const ScreenRect& rect) override;
  void paint_frame(NVGcontext* ctx) const override;
  void hover(const std::optional<Point>& at) override;

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
  DescriptorPanel(nanogui::Widget* parent, Studio& studio);
  std::string text() const override;
  void performLayout(NVGcontext* ctx) override;

 protected:
  std::vector<Part> parts() const override;
  void paint(NVGcontext* ctx) override;
  void click(const std::string& part) override;
  bool key(int key, int modifiers) override;

 private:
  enum class Tab { Values, Histogram, Scatter };
  Studio& studio_;
  DescriptorModel& model_;
  Tab tab_ = Tab::Values;
  std::size_t x_ = 0, y_ = 0;  ///< rows of the model
  DescriptorTable* table_;
  HistogramPlot* histogram_;
  ScatterPlot* scatter_;

  const QuantityInfo& info_of(std::size_t row) const { return model_.rows()[row].info; }
  void set_tab(Tab tab);
  void select_row(std::size_t row);
  void step(const std::string& choice, int by);
  void update_plots();
  void choice_changed();
  /// The descriptors whose values over the list are displayed: none, one or two.
  std::vector<std::string> shown_ids() const;
  std::size_t missing() const;  ///< number of values of shown_ids() not computed
  bool can_compute() const;
  std::vector<std::string> choices() const;  ///< "descriptor", or "x" and "y"
  bool is_narrow() const;
  ScreenRect tab_rect(Tab tab) const;
  ScreenRect choice_rect(const std::string& choice) const;
  ScreenRect compute_rect() const;
  void draw_tabs(NVGcontext* ctx) const;
  void draw_choices(NVGcontext* ctx) const;
};

}  // namespace slalom
