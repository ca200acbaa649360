#pragma once

#include <slalom/gui/histogram.h>
#include <slalom/gui/plot_frame.h>

#include <functional>
#include <optional>
#include <string>

namespace slalom {

/// A histogram of a list with the current scenario marked. A click on a bar chooses its range.
/// Parts: "plot", "bin 0", "bin 1", ..., "current".
class HistogramPlot : public Element {
 public:
  explicit HistogramPlot(nanogui::Widget* parent);

  /// `message` is shown where there are no bars.
  void set_histogram(const QuantityInfo& info, Histogram histogram, std::string message);
  void set_current(std::optional<double> value);  ///< of the current scenario
  const Histogram& histogram() const { return histogram_; }

  std::function<void(double low, double high)> on_choose;  ///< low <= v < high

  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;
  void draw(NVGcontext* ctx) override;
  bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override;
  bool mouseMotionEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                        int modifiers) override;
  bool mouseEnterEvent(const nanogui::Vector2i& p, bool enter) override;

 private:
  QuantityInfo info_;
  Histogram histogram_;
  std::string message_;
  std::optional<double> current_;
  std::optional<std::size_t> hovered_;

  PlotFrame frame() const;
  ScreenRect bar_rect(const PlotFrame& frame, std::size_t bar, bool full) const;
  std::optional<std::size_t> bar_below(const nanogui::Vector2i& p) const;
  std::string bar_text(std::size_t bar) const;
  std::string without_number() const;
  void draw_bars(NVGcontext* ctx, const PlotFrame& frame) const;
  void draw_current(NVGcontext* ctx, const PlotFrame& frame) const;
};

}  // namespace slalom
