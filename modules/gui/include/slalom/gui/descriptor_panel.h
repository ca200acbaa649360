#pragma once

#include <slalom/gui/descriptor_model.h>
#include <slalom/gui/descriptor_table.h>
#include <slalom/gui/histogram_plot.h>
#include <slalom/gui/scatter_plot.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// What the descriptors of the current scenario are, and how they lie in the list: values,
/// histogram, scatter, one at a time. Keys: Tab and Shift+Tab go through the three; Up and Down
/// choose the descriptor (of the scatter: x), Left and Right that of y. Parts: "tab values", "tab
/// histogram", "tab scatter", "descriptor next", "descriptor previous", "x next", "x previous", "y
/// next", "y previous", "compute", and those of what is shown ("row density", "bin 3", "plot").
class DescriptorPanel : public Element {
 public:
  explicit DescriptorPanel(nanogui::Widget* parent);

  enum class Tab { Values, Histogram, Scatter };

  // Of the current scenario; as DescriptorModel.
  void show(const std::string& hash);
  void set_computing(std::size_t done, std::size_t total);
  void set_values(const std::string& hash, const std::vector<DescribedValue>& values);
  void fail(const std::string& hash, const std::string& message);

  /// Of the list; null while there is none or they are not read.
  void set_list_values(std::shared_ptr<const ListValues> values);
  const ListValues* list_values() const { return values_.get(); }
  /// What is said where a plot has nothing to show, e.g. "reading values..."
  void set_list_message(const std::string& message);
  /// What is done about the list's values, e.g. "computing 30 of 1000"; empty: nothing, and what is
  /// missing can be asked for.
  void set_list_status(const std::string& status);

  void set_tab(Tab tab);
  Tab tab() const { return tab_; }
  const std::string& histogram_id() const { return model_.chosen_row().info.id; }
  const std::string& x_id() const { return info_of(x_).id; }
  const std::string& y_id() const { return info_of(y_).id; }
  void choose(const std::string& id);  ///< of the table and the histogram
  void choose_axes(const std::string& x, const std::string& y);
  /// The descriptors whose values over the list are shown now: none, one or two.
  std::vector<std::string> shown_ids() const;

  std::function<void(const std::string& id)> on_choose_descriptor;
  std::function<void()> on_shown_ids;  ///< shown_ids() changed
  /// A bar was clicked: low <= value of `id` < high.
  std::function<void(const std::string& id, double low, double high)> on_select_range;
  std::function<void(const std::vector<std::string>& hashes)> on_select;
  std::function<void(const std::string& hash)> on_pick;  ///< a point was clicked
  std::function<void(const std::vector<std::string>& ids)> on_describe_list;

  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;
  void performLayout(NVGcontext* ctx) override;
  void draw(NVGcontext* ctx) override;
  bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override;
  bool keyboardEvent(int key, int scancode, int action, int modifiers) override;

 private:
  DescriptorModel model_;
  Tab tab_ = Tab::Values;
  std::size_t x_ = 0, y_ = 0;  ///< rows of the model
  std::shared_ptr<const ListValues> values_;
  std::string list_message_, list_status_;
  DescriptorTable* table_;
  HistogramPlot* histogram_;
  ScatterPlot* scatter_;

  const QuantityInfo& info_of(std::size_t row) const { return model_.rows()[row].info; }
  Element* shown() const;
  void choose_row(std::size_t row);
  void step(const std::string& choice, int by);
  void update_histogram();
  void update_scatter();
  void update_current();
  std::size_t missing() const;  ///< values of shown_ids() that were never computed
  std::string name_of_choice(const std::string& choice) const;
  std::vector<std::string> choices() const;  ///< "descriptor", or "x" and "y"
  ScreenRect tab_rect(Tab tab) const;
  ScreenRect choice_rect(const std::string& choice) const;
  std::optional<ScreenRect> compute_rect() const;
  std::optional<ScreenRect> own_part(const std::string& part) const;
  bool press(double x, double y);
  bool key(int key, int modifiers);
  void draw_tabs(NVGcontext* ctx) const;
  void draw_choices(NVGcontext* ctx) const;
};

}  // namespace slalom
