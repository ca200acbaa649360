#pragma once

#include "widgets/element.h"

#include <string>
#include <vector>

namespace slalom {

/// Layout of the scenario view: tools at the top, a status line at the bottom, between them the
/// canvas with the legend over its upper right corner. Independent of the window; in pixels.
struct ViewLayout {
  struct Button {
    std::string name, title;
  };

  /// `layers` are the rows of the legend, empty when it is closed. Buttons that do not fit in a row
  /// are wrapped.
  ViewLayout(double width, double height, const std::vector<Button>& buttons,
             const std::vector<std::string>& layers);
  /// The part of the canvas to which a scenario is fitted: without the legend if there is enough
  /// space.
  ScreenRect open_canvas() const;
  /// The part at a position; null for none.
  const Element::Part* at(double x, double y) const;
  const Element::Part* find(const std::string& name) const;

  ScreenRect canvas;     ///< of the scenario
  ScreenRect status;     ///< the status line
  ScreenRect scale_bar;  ///< at the end of the status line
  ScreenRect tools;      ///< background of the buttons
  ScreenRect legend;     ///< background of its title and rows
  /// "tool disc", "zoom in", "zoom out", "fit", "legend", "layer voronoi"
  std::vector<Element::Part> parts;

 private:
  double place_buttons(double width, const std::vector<Button>& buttons);
  void place_legend(const std::vector<std::string>& layers);
};

}  // namespace slalom
