// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/report/figures.h>

#include <cstddef>
#include <string>
#include <utility>

/// Elements of the charts in figures.cpp and chart_figures.cpp. Lengths are pixels.
namespace slalom::svg {

constexpr double kMargin = 50;  ///< around a chart

constexpr double kLine = 18;  ///< between lines of text

/// The width that the style leaves to a figure, whose text is 12 high; 0 if it does not say.
double width_of(const FigureStyle& style);
/// The label of a method, with its mark if it is privileged.
std::string label_of(const FigureStyle& style, const std::string& method);
double width_of_text(const std::string& text);  ///< roughly
std::string document(double width, double height, const std::string& content,
                     const FigureStyle& style);
std::string text(double x, double y, const char* anchor, const std::string& content);
std::string segment(double x1, double y1, double x2, double y2, double width = 1,
                    const std::string& color = "#333");

/// A line in the color of the method at `index`, and with dashes of its own for print in gray.
std::string method_line(const std::string& points, std::size_t index);
/// The area of a chart, in parts of its width and height, with its legend beside it or, in a narrow
/// figure, below.
class Plot {
 public:
  explicit Plot(const FigureStyle& style);

  const FigureStyle& style() const { return style_; }
  double width() const { return width_; }
  double x(double part) const { return kMargin + width_ * part; }
  double y(double part) const { return kMargin + kHeight * (1 - part); }

  /// The axes; `lines` of text are between the horizontal one and its label.
  std::string frame(const std::string& x_label, const std::string& y_label, int lines = 2) const;
  std::string x_tick(double part, const std::string& label) const;
  std::string y_tick(double part, const std::string& label) const;

  /// The beginning of a line of the legend.
  std::pair<double, double> legend(std::size_t index) const;
  std::string document(const std::string& content, std::size_t legends) const;

 private:
  static constexpr double kHeight = 240, kLegend = 180;

  FigureStyle style_;
  bool below_ = false;
  double width_ = 360;
};

/// A piece of the line of a method, with its name, in the legend.
std::string method_key(const Plot& plot, std::size_t index, const std::string& name);

}  // namespace slalom::svg
