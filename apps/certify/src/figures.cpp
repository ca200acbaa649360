// SPDX-License-Identifier: BSD-3-Clause
#include "figures.h"

#include <slalom/core/text.h>
#include <slalom/io/svg_scene.h>
#include <slalom/statistics/statistics.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace slalom {
namespace {

constexpr double kLeft = 60, kTop = 15, kWidth = 520, kHeight = 240;  // px, of the axes
constexpr char kClaimed[] = "#009e73", kSeen[] = "#0072b2", kMissed[] = "#d55e00";

std::string text_at(double x, double y, const std::string& anchor, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     html_escape(text));
}

std::string rectangle_at(double x, double y, double width, double height, const std::string& color,
                         double opacity, const std::string& title) {
  return fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\" "
      "fill-opacity=\"{}\" stroke=\"{}\"><title>{}</title></rect>\n",
      x, y, width, height, color, opacity, color, html_escape(title));
}

StatementFigure figure_of(const std::string& content, double width, double height) {
  return {
      fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
                  "width=\"{0:.0f}\" height=\"{1:.0f}\" font-family=\"sans-serif\" "
                  "font-size=\"12\">\n{2}</svg>\n",
                  width, height, content)};
}

/// Places values of the parameter from the easy end, on the left, to the hard one.
class Axis {
 public:
  explicit Axis(const Json& claims) {
    bool first = true;
    for (const Json& claim : claims)
      for (const char* part : {"pilot", "steps", "curve"})
        for (const Json& row : claim.at(part)) {
          const double from = row.at("from").get<double>(), to = row.at("to").get<double>();
          if (first || (from - from_) * (to - from) < 0) from_ = from;
          if (first || (to - to_) * (to - from) > 0) to_ = to;
          first = false;
          ticks_.insert({from, to});
        }
    if (from_ == to_) to_ = from_ + 1;  // one value of an integer
  }
  double x(double value) const { return kLeft + kWidth * (value - from_) / (to_ - from_); }
  std::string ticks() const {
    std::string text;
    double last = -1e9;
    std::vector<double> values(ticks_.begin(), ticks_.end());
    if (to_ < from_) std::reverse(values.begin(), values.end());
    for (const double value : values) {
      if (x(value) - last < 40) continue;
      last = x(value);
      text += text_at(last, kTop + kHeight + 18, "middle", format_number(value));
    }
    return text;
  }

 private:
  double from_ = 0, to_ = 1;
  std::set<double> ticks_;
};

double y_of(double rate) {
  return kTop + kHeight * (1 - rate);
}

/// The rate of success in a range, with its interval.
std::string bar(const Axis& axis, const Json& row) {
  const double runs = row.at("runs").get<double>();
  const double successes = runs - row.at("failures").get<double>(), rate = successes / runs;
  const Interval interval = clopper_pearson_interval(successes, runs, 0.95);
  const double a = axis.x(row.at("from").get<double>()), b = axis.x(row.at("to").get<double>());
  const std::string title =
      fmt::format("{} to {}: {:.2f} [{:.2f}, {:.2f}], {:.0f} runs", format_number(row.at("from")),
                  format_number(row.at("to")), rate, interval.low, interval.high, runs);
  return rectangle_at(std::min(a, b) + 1, y_of(interval.high), std::max(1.0, std::abs(b - a) - 2),
                      std::max(1.0, y_of(interval.low) - y_of(interval.high)), kSeen, 0.25, title) +
         fmt::format("<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"{}\" stroke-width=\"3\"/>\n",
                     std::min(a, b), y_of(rate), std::max(a, b), kSeen);
}

}  // namespace

StatementFigure curve_figure(const std::string& parameter, const Json& answer) {
  const Json& claims = answer.at("claims");
  const Axis axis(claims);
  const std::string unit = answer.at("unit").get<std::string>();
  std::string content;
  for (const Json& claim : claims) {
    const double y = y_of(claim.at("reliability").get<double>());
    for (const Json& step : claim.at("steps")) {
      if (!step.at("claimed").get<bool>()) continue;
      const double a = axis.x(step.at("from").get<double>()),
                   b = axis.x(step.at("to").get<double>());
      content += rectangle_at(std::min(a, b), kTop, std::abs(b - a), y - kTop, kClaimed, 0.2,
                              claim.at("claim").get<std::string>());
    }
    content += fmt::format("<path d=\"M{} {:.1f}h{}\" stroke=\"{}\" stroke-dasharray=\"4\"/>\n",
                           kLeft, y, kWidth, kClaimed);
  }
  for (const Json& row : last_of(claims).at("curve")) content += bar(axis, row);
  for (const double rate : {0.0, 0.25, 0.5, 0.75, 1.0})
    content += text_at(kLeft - 8, y_of(rate) + 4, "end", format_number(rate));
  content += fmt::format("<path d=\"M{} {}v{}h{}\" fill=\"none\" stroke=\"#333\"/>\n", kLeft, kTop,
                         kHeight, kWidth);
  content += axis.ticks();
  content += text_at(kLeft + kWidth / 2, kTop + kHeight + 38, "middle",
                     parameter + (unit.empty() ? "" : " (" + unit + ")"));
  content += fmt::format(
      "<text transform=\"translate(14 {}) rotate(-90)\" text-anchor=\"middle\">success</text>\n",
      kTop + kHeight / 2);
  return figure_of(content, kLeft + kWidth + 20, kTop + kHeight + 48);
}

StatementFigure tune_figure(const Json& sealed) {
  constexpr double kNames = 170, kLine = 24, kUnit = kWidth - 110;
  const auto x_of = [&](double rate) { return kNames + kUnit * rate; };
  double y = kTop + 6;
  std::string content;
  const auto add = [&](const std::string& scenarios, const Json& pair) {
    for (const auto& [key, name, color] :
         {std::tuple("default", "default", kSeen), {"tuned", "tuned", kClaimed}}) {
      const Json& estimate = pair.at(key);
      const double value = estimate.at("value").get<double>();
      content += text_at(kNames - 10, y + 4, "end", scenarios + ": " + name) +
                 fmt::format(
                     "<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"{}\" stroke-width=\"2\"/>"
                     "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\"/>\n",
                     x_of(estimate.at("low").get<double>()), y,
                     x_of(estimate.at("high").get<double>()), color, x_of(value), y, color) +
                 text_at(x_of(1) + 8, y + 4, "start", fmt::format("{:.2f}", value));
      y += kLine;
    }
  };
  add("sealed", sealed);
  if (const Json& hard = sealed.at("hard_end"); !hard.is_null())
    add(hard.at("condition").get<std::string>(), hard);
  content += fmt::format("<path d=\"M{} {:.1f}h{}\" stroke=\"#333\"/>\n", kNames, y, kUnit);
  for (const double rate : {0.0, 0.25, 0.5, 0.75, 1.0})
    content += text_at(x_of(rate), y + 16, "middle", format_number(rate));
  return figure_of(content + text_at(x_of(0.5), y + 34, "middle", "success"), x_of(1) + 60, y + 44);
}

StatementFigure envelope_figure(const std::string& columns, const std::string& rows,
                                const Json& answer) {
  const Json &all_rows = answer.at("rows"), &all_columns = answer.at("columns");
  const double left = 110, width = kWidth / static_cast<double>(all_columns.size()), height = 32;
  std::string content;
  double y = kTop;
  for (const Json& row : all_rows) {
    content += text_at(left - 8, y + height / 2 + 4, "end",
                       format_number(row.at("from")) + " to " + format_number(row.at("to")));
    double x = left;
    for (const Json& cell : row.at("cells")) {
      const std::string counts = fmt::format("{}/{}", cell.at("failures").get<std::size_t>(),
                                             cell.at("runs").get<std::size_t>());
      content += rectangle_at(x, y, width - 2, height - 2,
                              cell.at("claimed").get<bool>() ? kClaimed : kMissed, 0.4,
                              counts + " failures") +
                 text_at(x + width / 2, y + height / 2 + 4, "middle", counts);
      x += width;
    }
    y += height;
  }
  double x = left;
  for (const Json& column : all_columns) {
    content += text_at(x, y + 14, "middle", format_number(column.at("from")));
    x += width;
  }
  content += text_at(x, y + 14, "middle", format_number(last_of(all_columns).at("to")));
  content += text_at(left + kWidth / 2, y + 34, "middle", columns);
  content += text_at(4, y + 34, "start", rows);
  return figure_of(content, left + kWidth + 20, y + 44);
}

}  // namespace slalom
