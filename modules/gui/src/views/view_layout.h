#pragma once

#include "widgets/element.h"

#include <string>
#include <vector>

namespace slalom {

/// Layout of the scenario view: tools at the top, a status line at the bottom, between them the
/// canvas with the legend over its upper right corner. Independent of the window; in pixels.
class ViewLayout {
 public:
  struct Part {
    std::string name;  ///< "tool disc", "zoom in", "zoom out", "fit", "legend", "layer voronoi"
    ScreenRect rect;
  };
  struct Button {
    std::string name, title;
  };

  /// `layers` are the rows of the legend, empty when it is closed. Buttons that do not fit in a row
  /// are wrapped.
  ViewLayout(double width, double height, const std::vector<Button>& buttons,
             const std::vector<std::string>& layers);

  const ScreenRect& canvas() const { return canvas_; }  ///< of the scenario
  /// The part of the canvas to which a scenario is fitted: without the legend if there is enough
  /// space.
  ScreenRect open_canvas() const;
  const ScreenRect& status() const { return status_; }        ///< the status line
  const ScreenRect& scale_bar() const { return scale_bar_; }  ///< at the end of the status line
  const ScreenRect& tools() const { return tools_; }          ///< background of the buttons
  const ScreenRect& legend() const { return legend_; }        ///< background of its title and rows
  const std::vector<Part>& parts() const { return parts_; }
  /// The part at a position; null for none.
  const Part* at(double x, double y) const;
  const Part* find(const std::string& name) const;

 private:
  double place_buttons(double width, const std::vector<Button>& buttons);
  void place_legend(const std::vector<std::string>& layers);

  ScreenRect canvas_, status_, scale_bar_, tools_, legend_;
  std::vector<Part> parts_;
};

}  // namespace slalom
