#include "html_text.h"
#include "svg_chart.h"

#include <slalom/core/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slalom {
namespace {

constexpr double kWidth = 640, kHeight = 300;
constexpr double kLeft = 52, kRight = 14, kTop = 12, kBottom = 44;

std::string text_at(double x, double y, const char* anchor, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>", x, y, anchor,
                     html_escape(text));
}

std::string line_from(double x1, double y1, double x2, double y2, const char* css_class) {
  return fmt::format("<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>",
                     css_class, x1, y1, x2, y2);
}

std::string open_svg(double width, double height, const std::string& title) {
  return fmt::format(
      "<svg class=\"chart\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" "
      "role=\"img\"><title>{}</title>",
      width, height, html_escape(title));
}

/// From values to pixels.
struct ChartFrame {
  const ChartAxes& axes;

  double x(double value) const {
    const double low = along(axes.x_low), high = along(axes.x_high);
    const double share = high > low ? (along(value) - low) / (high - low) : 0;
    return kLeft + std::clamp(share, 0.0, 1.0) * (kWidth - kLeft - kRight);
  }
  double y(double share) const { return kTop + (1 - share) * (kHeight - kTop - kBottom); }

 private:
  double along(double value) const { return axes.logarithmic ? std::log(value) : value; }
};

/// Round values over the axis, few enough to be read.
std::vector<double> ticks(const ChartAxes& axes) {
  std::vector<double> values;
  if (axes.logarithmic) {
    for (double value = axes.x_low; value <= axes.x_high * 1.0001; value *= 2)
      values.push_back(value);
    return values;
  }
  const double span = axes.x_high - axes.x_low;
  if (!(span > 0)) return {axes.x_low};
  const double power = std::pow(10, std::floor(std::log10(span)));
  const double step = span / power > 5 ? power : span / power > 2 ? power / 2 : power / 5;
  for (double value = std::ceil(axes.x_low / step) * step; value <= axes.x_high + step / 1000;
       value += step)
    values.push_back(value);
  return values;
}

std::string axes_svg(const ChartFrame& frame) {
  std::string svg;
  for (int quarter = 0; quarter <= 4; ++quarter) {
    const double share = 0.25 * quarter, y = frame.y(share);
    svg += line_from(kLeft, y, kWidth - kRight, y, "rule");
    svg += text_at(kLeft - 6, y + 4, "end", format_fixed(share, 2));
  }
  for (const double value : ticks(frame.axes)) {
    const double x = frame.x(value), y = frame.y(0);
    svg += line_from(x, y, x, y + 4, "axis");
    svg += text_at(x, y + 17, "middle", fmt::format("{:.4g}", value));
  }
  svg += text_at((kLeft + kWidth - kRight) / 2, kHeight - 8, "middle", frame.axes.x_label);
  return svg + line_from(kLeft, frame.y(0), kWidth - kRight, frame.y(0), "axis");
}

std::string steps_svg(const ChartFrame& frame, const ChartLine& line) {
  if (line.points.empty()) return "";
  std::string path;
  for (const auto& [x, y] : line.points) {
    path += path.empty() ? fmt::format("M{:.1f} {:.1f}", frame.x(x), frame.y(y))
                         : fmt::format("H{:.1f}V{:.1f}", frame.x(x), frame.y(y));
  }
  path += fmt::format("H{:.1f}", kWidth - kRight);
  return fmt::format(
      "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"><title>{}</title></path>",
      path, line.color, html_escape(line.label));
}

std::string legend(const std::vector<ChartLine>& lines) {
  std::string items;
  for (const ChartLine& line : lines)
    items += "<span><i class=\"swatch\" style=\"background:" + line.color + "\"></i>" +
             html_escape(line.label) + "</span>";
  return html_element("div", "legend", items);
}

/// Places of the methods from best to worst.
std::vector<std::size_t> by_rank(const MethodRanks& ranks) {
  std::vector<std::size_t> order(ranks.methods.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return ranks.test.mean_ranks[a] < ranks.test.mean_ranks[b];
  });
  return order;
}

/// Draws one diagram: the scale above, bars of groups below it, then a line per method.
class RankDiagram {
 public:
  RankDiagram(const MethodRanks& ranks, const std::vector<std::string>& colors)
      : ranks_(ranks), colors_(colors), worst_(static_cast<double>(ranks.methods.size())) {}

  std::string svg() const {
    const std::size_t n = ranks_.methods.size();
    const double height = kScale + kBar * static_cast<double>(ranks_.test.groups.size()) +
                          kLine * static_cast<double>(n) + 20;
    std::string svg = open_svg(kWidth, height, "Mean ranks of the methods");
    svg += line_from(x(1), kScale, x(worst_), kScale, "axis");
    for (std::size_t rank = 1; rank <= n; ++rank) {
      const double at = x(static_cast<double>(rank));
      svg += line_from(at, kScale - 5, at, kScale, "axis") +
             text_at(at, kScale - 9, "middle", std::to_string(rank));
    }
    svg += critical_difference() + bars() + methods();
    return svg + "</svg>";
  }

 private:
  static constexpr double kScale = 52, kBar = 9, kLine = 18, kMargin = 40;

  double x(double rank) const {
    return kMargin + (worst_ > 1 ? (rank - 1) / (worst_ - 1) : 0) * (kWidth - 220 - kMargin);
  }

  std::string critical_difference() const {
    const double end = x(std::min(worst_, 1 + ranks_.test.critical_difference));
    return line_from(x(1), 16, end, 16, "bar") +
           text_at(end + 8, 20, "start",
                   "critical difference " + format_fixed(ranks_.test.critical_difference, 2));
  }

  std::string bars() const {
    std::string svg;
    double y = kScale + 8;
    for (const auto& group : ranks_.test.groups) {
      svg += line_from(x(ranks_.test.mean_ranks[group.front()]) - 4, y,
                       x(ranks_.test.mean_ranks[group.back()]) + 4, y, "bar");
      y += kBar;
    }
    return svg;
  }

  std::string methods() const {
    std::string svg;
    double y = kScale + kBar * static_cast<double>(ranks_.test.groups.size()) + 20;
    for (const std::size_t method : by_rank(ranks_)) {
      const double at = x(ranks_.test.mean_ranks[method]);
      svg +=
          line_from(at, kScale, at, y, "rule") +
          fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\"/>", at, y,
                      colors_[method]) +
          text_at(at + 9, y + 4, "start",
                  ranks_.methods[method] + "  " + format_fixed(ranks_.test.mean_ranks[method], 2));
      y += kLine;
    }
    return svg;
  }

  const MethodRanks& ranks_;
  const std::vector<std::string>& colors_;
  double worst_;
};

}  // namespace

std::string step_chart(const ChartAxes& axes, const std::vector<ChartLine>& lines) {
  const ChartFrame frame{axes};
  std::string svg = open_svg(kWidth, kHeight, axes.y_label) + axes_svg(frame);
  for (const ChartLine& line : lines) svg += steps_svg(frame, line);
  return svg + "</svg>" + legend(lines);
}

std::string rank_diagram(const MethodRanks& ranks, const std::vector<std::string>& colors) {
  return RankDiagram(ranks, colors).svg();
}

}  // namespace slalom
