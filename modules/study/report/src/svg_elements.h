// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

/// Elements of the charts in figures.cpp and chart_figures.cpp. Lengths are pixels.
namespace slalom::svg {

constexpr double kMargin = 50;  ///< around a chart

std::string document(double width, double height, const std::string& content);
std::string text(double x, double y, const char* anchor, const std::string& content);
std::string segment(double x1, double y1, double x2, double y2, double width = 1,
                    const std::string& color = "#333");

}  // namespace slalom::svg
