#pragma once

#include <slalom/gui/plot_frame.h>
#include <slalom/gui/scatter.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The scenarios of a list over two descriptors, the current one marked. Dragging selects all in a
/// rectangle, a click goes to the scenario under the mouse. Parts: "plot", "current", "selection".
class ScatterPlot : public Element {
 public:
  explicit ScatterPlot(nanogui::Widget* parent);

  /// `message` is shown where there are no points.
  void set_values(std::shared_ptr<const ListValues> values, const QuantityInfo& x,
                  const QuantityInfo& y, std::string message);
  void set_current(const std::string& hash);

  std::function<void(const std::vector<std::string>& hashes)> on_select;
  std::function<void(const std::string& hash)> on_pick;

  std::string text() const override;
  std::optional<ScreenRect> rect_of(const std::string& part) const override;
  void draw(NVGcontext* ctx) override;
  bool mouseButtonEvent(const nanogui::Vector2i& p, int button, bool down, int modifiers) override;
  bool mouseDragEvent(const nanogui::Vector2i& p, const nanogui::Vector2i& rel, int button,
                      int modifiers) override;

 private:
  struct Corner {
    double x, y;  ///< values
  };
  struct Drag {
    Corner from, to;
    bool moved = false;
  };
  std::shared_ptr<const ListValues> values_;
  Scatter scatter_;
  QuantityInfo x_info_, y_info_;
  std::string message_, current_;
  std::optional<Drag> drag_;    ///< while the button is down
  std::optional<Drag> chosen_;  ///< the last rectangle
  std::size_t chosen_count_ = 0;
  int image_ = 0;                           ///< NanoVG's handle; 0 for none
  int image_width_ = 0, image_height_ = 0;  ///< pixels
  bool image_outdated_ = true;

  PlotFrame frame() const;
  Corner corner_at(const nanogui::Vector2i& p) const;
  std::optional<Corner> current_point() const;
  ScreenRect rect_between(const PlotFrame& frame, const Drag& drag) const;
  std::string summary() const;
  void release(const nanogui::Vector2i& p);
  void update_image(NVGcontext* ctx, const PlotFrame& frame);
  void draw_points(NVGcontext* ctx, const PlotFrame& frame);
  void draw_marks(NVGcontext* ctx, const PlotFrame& frame) const;
};

}  // namespace slalom
