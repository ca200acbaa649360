#pragma once

#include <slalom/analysis/method_ranks.h>

#include <string>
#include <utility>
#include <vector>

namespace slalom {

/// One curve of a chart.
struct ChartLine {
  std::string label, color;
  std::vector<std::pair<double, double>> points;  ///< by increasing x
};

/// What a chart's axes show; y is always a share, from 0 to 1.
struct ChartAxes {
  std::string x_label, y_label;
  double x_low = 0, x_high = 1;
  bool logarithmic = false;  ///< x; then x_low > 0
};

/// Step curves: each keeps the value of a point until the next one, and the last one to the right
/// border. One self-contained <svg> with a legend; colours of text and lines follow the page's
/// style. Fit for paper and for dark mode.
std::string step_chart(const ChartAxes& axes, const std::vector<ChartLine>& lines);

/// Critical-difference diagram (Demsar 2006): methods on a scale of mean ranks, 1 at the left, bars
/// over those that do not differ by more than the critical difference. `colors` by method.
std::string rank_diagram(const MethodRanks& ranks, const std::vector<std::string>& colors);

}  // namespace slalom
