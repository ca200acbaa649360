#pragma once

#include <slalom/gui/element.h>

#include <string>
#include <vector>

namespace slalom {

/// Where the parts of the scenario view lie: tools above, a line of text below, between them the
/// scenario with the legend over its upper right corner. Knows no window; pixels of the view.
class ViewLayout {
 public:
  struct Part {
    std::string name;  ///< "tool disc", "zoom in", "zoom out", "fit", "legend", "layer voronoi"
    ScreenRect rect;
  };
  struct Button {
    std::string name, title;
  };

  /// `layers` are shown as rows of the legend, none when it is closed. Buttons that do not fit
  /// beside each other go to another row.
  ViewLayout(double width, double height, const std::vector<Button>& buttons,
             const std::vector<std::string>& layers);

  const ScreenRect& canvas() const { return canvas_; }  ///< of the scenario
  /// The part of the canvas in which all of a scenario is fitted: beside the legend, where there is
  /// room for both.
  ScreenRect open_canvas() const;
  const ScreenRect& status() const { return status_; }        ///< of the line of text below it
  const ScreenRect& scale_bar() const { return scale_bar_; }  ///< at the end of that line
  const ScreenRect& tools() const { return tools_; }          ///< behind the buttons
  const ScreenRect& legend() const { return legend_; }        ///< behind its title and rows
  const std::vector<Part>& parts() const { return parts_; }
  /// The button or row there; null for none.
  const Part* at(double x, double y) const;
  const Part* find(const std::string& name) const;

 private:
  double place_buttons(double width, const std::vector<Button>& buttons);
  void place_legend(const std::vector<std::string>& layers);

  ScreenRect canvas_, status_, scale_bar_, tools_, legend_;
  std::vector<Part> parts_;
};

}  // namespace slalom
