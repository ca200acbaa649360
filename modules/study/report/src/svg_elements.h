// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

/// Elements of the charts in figures.cpp and chart_figures.cpp. Lengths are pixels.
namespace slalom::svg {

constexpr double kMargin = 50;  ///< around a chart

std::string document(double width, double height, const std::string& content);
std::string text(double x, double y, const char* anchor, const std::string& content);
std::string segment(double x1, double y1, double x2, double y2, double width = 1,
                    const std::string& color = "#333");

/// A line in the color of the method at `index`, and with dashes of its own for print in gray.
std::string method_line(const std::string& points, std::size_t index);
/// A piece of that line, `length` long, with the name.
std::string method_key(double left, double top, std::size_t index, const std::string& name,
                       double length = 26);

}  // namespace slalom::svg
