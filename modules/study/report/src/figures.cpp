// SPDX-License-Identifier: BSD-3-Clause
#include "svg_elements.h"

#include <slalom/core/math.h>
#include <slalom/report/figures.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slalom {
namespace {

using svg::document;
using svg::method_key;
using svg::method_line;
using svg::segment;
using svg::text;

/// Performance profiles: ratios on a logarithmic axis, fractions upwards.
class ProfileChart {
 public:
  ProfileChart(const ProfileTable& table, const FigureStyle& style) : table_(table), plot_(style) {
    for (const PerformanceProfile& profile : table.profiles)
      for (const ProfileStep& step : profile.steps) max_ = std::max(max_, step.ratio);
    max_ = std::exp2(std::ceil(math::log2(std::clamp(max_, 2.0, kMaxRatio))));
  }

  std::string render() const {
    std::string content = axes();
    for (std::size_t i = 0; i < table_.profiles.size(); ++i)
      content += curve(i) + method_key(plot_, i, table_.profiles[i].method);
    return plot_.document(content, table_.profiles.size());
  }

 private:
  static constexpr double kMaxRatio = 16;  // beyond it curves are cut

  double part(double ratio) const { return math::log2(ratio) / math::log2(max_); }

  std::string axes() const {
    std::string content = plot_.frame(
        "ratio to the best method",
        fmt::format("fraction of {} scenarios ({})", table_.scenarios, table_.column.info.name));
    for (double ratio = 1; ratio <= max_; ratio *= 2)
      content += plot_.x_tick(part(ratio), fmt::format("{:g}", ratio));
    for (const double fraction : {0.0, 0.25, 0.5, 0.75, 1.0})
      content += plot_.y_tick(fraction, fmt::format("{:g}", fraction));
    return content;
  }

  std::string curve(std::size_t index) const {
    std::string points;
    double fraction = 0;
    for (const ProfileStep& step : table_.profiles[index].steps) {
      if (step.ratio > max_) break;
      const double x = plot_.x(part(step.ratio));
      points += fmt::format("{0:.1f},{1:.1f} {0:.1f},{2:.1f} ", x, plot_.y(fraction),
                            plot_.y(step.fraction));
      fraction = step.fraction;
    }
    points += fmt::format("{:.1f},{:.1f}", plot_.x(1), plot_.y(fraction));
    return method_line(points, index);
  }

  const ProfileTable& table_;
  svg::Plot plot_;
  double max_ = 1;
};

class RankDiagram {
 public:
  RankDiagram(const MethodRanks& ranks, const FigureStyle& style) : ranks_(ranks), style_(style) {
    if (style.width) {
      side_ = 0;
      for (std::size_t i = 0; i < ranks.methods.size(); ++i)
        side_ = std::max(side_, 20 + 7 * static_cast<double>(label(i).size()));
      width_ = std::max(100.0, svg::width_of(style) - 2 * side_);
    }
    for (std::size_t i = 0; i < ranks.methods.size(); ++i) order_.push_back(i);
    std::sort(order_.begin(), order_.end(),
              [this](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  }

  std::string render() const {
    std::string content = axis() + critical_difference();
    for (std::size_t place = 0; place < order_.size(); ++place) content += method(place);
    for (std::size_t i = 0; i < ranks_.test.groups.size(); ++i) content += group(i);
    const std::size_t lines = (order_.size() + 1) / 2;
    return document(2 * side_ + width_, first_line() + kLine * static_cast<double>(lines), content,
                    style_);
  }

 private:
  static constexpr double kTop = 70, kLine = 20;  // pixels
  static constexpr double kGroup = 7;             // pixels between bars of groups

  double rank(std::size_t method) const { return ranks_.test.mean_ranks[method]; }
  std::string label(std::size_t method) const {
    return fmt::format("{} ({:.2f})", svg::label_of(style_, ranks_.methods[method]), rank(method));
  }
  double x(double rank) const {
    return side_ + width_ * (rank - 1) / static_cast<double>(ranks_.methods.size() - 1);
  }
  double first_line() const {
    return kTop + 20 + kGroup * static_cast<double>(ranks_.test.groups.size());
  }

  std::string axis() const {
    const auto count = static_cast<double>(ranks_.methods.size());
    std::string content = segment(x(1), kTop, x(count), kTop);
    for (double at = 1; at <= count; ++at)
      content += segment(x(at), kTop - 5, x(at), kTop) +
                 text(x(at), kTop - 9, "middle", fmt::format("{:g}", at));
    return content + text(side_, 16, "start",
                          fmt::format("mean rank in {} over {} scenarios", ranks_.column.info.name,
                                      ranks_.test.scenarios));
  }

  std::string critical_difference() const {
    const double cd = ranks_.test.critical_difference;
    const double right = std::min(x(1 + cd), 2 * side_ + width_);
    return segment(x(1), 36, right, 36, 2) +
           text(right + 6, 40, "start", fmt::format("CD = {:.2f}", cd));
  }

  /// The better half is labeled on the left, the other half on the right.
  std::string method(std::size_t place) const {
    const std::size_t half = (order_.size() + 1) / 2;
    const bool left = place < half;
    const double line = static_cast<double>(left ? place : order_.size() - 1 - place);
    const double y = first_line() + kLine * line, end = left ? side_ - 10 : side_ + width_ + 10;
    const std::size_t index = order_[place];
    const std::string color = method_color(index);
    return segment(x(rank(index)), kTop, x(rank(index)), y, 1.5, color) +
           segment(x(rank(index)), y, end, y, 1.5, color) +
           text(left ? end - 4 : end + 4, y + 4, left ? "end" : "start", label(index));
  }

  std::string group(std::size_t index) const {
    const std::vector<std::size_t>& members = ranks_.test.groups[index];
    const double y = kTop + 8 + kGroup * static_cast<double>(index);
    return segment(x(rank(members.front())) - 4, y, x(rank(members.back())) + 4, y, 4);
  }

  const MethodRanks& ranks_;
  FigureStyle style_;
  double width_ = 320, side_ = 150;
  std::vector<std::size_t> order_;  ///< methods, best first
};

/// The lines of scenarios and how they are drawn, each once.
std::vector<std::pair<std::string, std::string>> keys_of(
    const std::vector<ScenarioFigure>& scenarios, const FigureStyle& style) {
  std::vector<std::pair<std::string, std::string>> keys;
  const auto add = [&](const std::string& name, const std::string& key) {
    const bool known =
        std::any_of(keys.begin(), keys.end(), [&](const auto& one) { return one.first == name; });
    if (!known) keys.emplace_back(name, key);
  };
  for (const auto& [scenario, options] : scenarios)
    for (std::size_t i = 0; i < options.trajectories.size(); ++i) {
      const SceneTrajectory& one = options.trajectories[i];
      add(svg::label_of(style, one.label),
          fmt::format("stroke=\"{}\"",
                      html_escape(one.color.empty() ? method_color(i) : one.color)));
    }
  for (const auto& [scenario, options] : scenarios) {
    if (options.references == nullptr) continue;
    if (options.references->shortest) add("shortest path", reference_line(true));
    if (options.references->safest) add("safest path", reference_line(false));
  }
  return keys;
}

}  // namespace

std::string profile_figure(const ProfileTable& table, const FigureStyle& style) {
  return ProfileChart(table, style).render();
}

std::string rank_figure(const MethodRanks& ranks, const FigureStyle& style) {
  return RankDiagram(ranks, style).render();
}

std::string scenario_figure(const std::vector<ScenarioFigure>& scenarios,
                            const FigureStyle& style) {
  constexpr double kGap = 10, kCaption = 18, kDefault = 320;  // pixels
  constexpr std::size_t kInRow = 3;
  const double room = style.width ? svg::width_of(style) : std::numeric_limits<double>::infinity();
  double widest = 1;
  for (const ScenarioFigure& one : scenarios)
    widest = std::max(widest, svg::width_of_text(one.scenario.name()) + kGap);
  const double in_row =
      std::clamp(std::min(static_cast<double>(scenarios.size()), std::floor(room / widest)), 1.0,
                 static_cast<double>(kInRow));
  const double fitting = style.width ? (room - kGap * (in_row - 1)) / in_row : kDefault;
  std::string content;
  double left = 0, top = 0, height = 0, width = style.width ? room : 0;
  std::size_t placed = 0;
  for (const auto& [scenario, given] : scenarios) {
    SceneOptions options = given;
    if (options.max_pixels <= 0) options.max_pixels = static_cast<int>(fitting);
    const Bounds& bounds = scenario.bounds();
    const double scale = options.max_pixels / std::max(bounds.width(), bounds.height());
    if (placed > 0 && (placed == kInRow || left + bounds.width() * scale > room + 1)) {
      top += height + kCaption + kGap;
      left = height = 0;
      placed = 0;
    }
    std::string picture = render_svg(scenario, options);
    content += text(left, top + 13, "start", scenario.name()) +
               picture.insert(4, fmt::format(" x=\"{:.0f}\" y=\"{:.0f}\"", left, top + kCaption));
    left += bounds.width() * scale + kGap;
    height = std::max(height, bounds.height() * scale);
    width = std::max(width, left - kGap);
    ++placed;
  }
  top += height + kCaption;
  const auto keys = keys_of(scenarios, style);
  for (const auto& [name, key] : keys) {
    top += kCaption;
    content +=
        fmt::format("<polyline points=\"2,{0:.0f} 28,{0:.0f}\" fill=\"none\" {1}/>", top - 4, key);
    content += text(34, top, "start", name);
  }
  return document(width, keys.empty() ? top : top + kGap, content, style);
}

}  // namespace slalom
