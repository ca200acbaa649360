// SPDX-License-Identifier: BSD-3-Clause
#include "svg_elements.h"

#include <slalom/core/math.h>
#include <slalom/report/figures.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using svg::document;
using svg::kMargin;
using svg::method_key;
using svg::method_line;
using svg::segment;
using svg::text;

/// The area of a profile: ratios on a logarithmic axis, fractions upwards.
class ProfileChart {
 public:
  explicit ProfileChart(const ProfileTable& table) : table_(table) {
    for (const PerformanceProfile& profile : table.profiles)
      for (const ProfileStep& step : profile.steps) max_ = std::max(max_, step.ratio);
    max_ = std::exp2(std::ceil(math::log2(std::clamp(max_, 2.0, kMaxRatio))));
  }

  std::string render() const {
    std::string content = axes();
    for (std::size_t i = 0; i < table_.profiles.size(); ++i) content += curve(i) + legend(i);
    return document(kMargin + kWidth + kLegend, kHeight + 2 * kMargin, content);
  }

 private:
  static constexpr double kWidth = 360, kHeight = 240, kLegend = 180;  // pixels
  static constexpr double kMaxRatio = 16;                              // beyond it curves are cut

  double x(double ratio) const { return kMargin + kWidth * math::log2(ratio) / math::log2(max_); }
  static double y(double fraction) { return kMargin + kHeight * (1 - fraction); }

  std::string axes() const {
    std::string content = segment(x(1), y(0), x(max_), y(0)) + segment(x(1), y(0), x(1), y(1));
    for (double ratio = 1; ratio <= max_; ratio *= 2)
      content += segment(x(ratio), y(0), x(ratio), y(0) + 5) +
                 text(x(ratio), y(0) + 18, "middle", fmt::format("{:g}", ratio));
    for (const double fraction : {0.0, 0.25, 0.5, 0.75, 1.0})
      content += segment(x(1) - 5, y(fraction), x(1), y(fraction)) +
                 text(x(1) - 8, y(fraction) + 4, "end", fmt::format("{:g}", fraction));
    content += text(kMargin + kWidth / 2, y(0) + 36, "middle", "ratio to the best method");
    return content + text(kMargin - 40, kMargin - 16, "start",
                          fmt::format("fraction of {} scenarios ({})", table_.scenarios,
                                      table_.column.info.name));
  }

  std::string curve(std::size_t index) const {
    std::string points;
    double fraction = 0;
    for (const ProfileStep& step : table_.profiles[index].steps) {
      if (step.ratio > max_) break;
      points += fmt::format("{:.1f},{:.1f} {:.1f},{:.1f} ", x(step.ratio), y(fraction),
                            x(step.ratio), y(step.fraction));
      fraction = step.fraction;
    }
    points += fmt::format("{:.1f},{:.1f}", x(max_), y(fraction));
    return method_line(points, index);
  }

  std::string legend(std::size_t index) const {
    return method_key(kMargin + kWidth + 15, kMargin + 18 * static_cast<double>(index), index,
                      table_.profiles[index].method);
  }

  const ProfileTable& table_;
  double max_ = 1;
};

class RankDiagram {
 public:
  explicit RankDiagram(const MethodRanks& ranks) : ranks_(ranks) {
    for (std::size_t i = 0; i < ranks.methods.size(); ++i) order_.push_back(i);
    std::sort(order_.begin(), order_.end(),
              [this](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  }

  std::string render() const {
    std::string content = axis() + critical_difference();
    for (std::size_t place = 0; place < order_.size(); ++place) content += method(place);
    for (std::size_t i = 0; i < ranks_.test.groups.size(); ++i) content += group(i);
    const std::size_t lines = (order_.size() + 1) / 2;
    return document(2 * kSide + kWidth, first_line() + kLine * static_cast<double>(lines), content);
  }

 private:
  static constexpr double kWidth = 320, kSide = 150, kTop = 70, kLine = 20;  // pixels
  static constexpr double kGroup = 7;  // pixels between bars of groups

  double rank(std::size_t method) const { return ranks_.test.mean_ranks[method]; }
  double x(double rank) const {
    return kSide + kWidth * (rank - 1) / static_cast<double>(ranks_.methods.size() - 1);
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
    return content + text(kSide, 16, "start",
                          fmt::format("mean rank in {} over {} scenarios", ranks_.column.info.name,
                                      ranks_.test.scenarios));
  }

  std::string critical_difference() const {
    const double cd = ranks_.test.critical_difference;
    const double right = std::min(x(1 + cd), 2 * kSide + kWidth);
    return segment(x(1), 36, right, 36, 2) +
           text(right + 6, 40, "start", fmt::format("CD = {:.2f}", cd));
  }

  /// The better half is labeled on the left, the other half on the right.
  std::string method(std::size_t place) const {
    const std::size_t half = (order_.size() + 1) / 2;
    const bool left = place < half;
    const double line = static_cast<double>(left ? place : order_.size() - 1 - place);
    const double y = first_line() + kLine * line, end = left ? kSide - 10 : kSide + kWidth + 10;
    const std::size_t index = order_[place];
    const std::string color = method_color(index), name = ranks_.methods[index];
    return segment(x(rank(index)), kTop, x(rank(index)), y, 1.5, color) +
           segment(x(rank(index)), y, end, y, 1.5, color) +
           text(left ? end - 4 : end + 4, y + 4, left ? "end" : "start",
                fmt::format("{} ({:.2f})", name, rank(index)));
  }

  std::string group(std::size_t index) const {
    const std::vector<std::size_t>& members = ranks_.test.groups[index];
    const double y = kTop + 8 + kGroup * static_cast<double>(index);
    return segment(x(rank(members.front())) - 4, y, x(rank(members.back())) + 4, y, 4);
  }

  const MethodRanks& ranks_;
  std::vector<std::size_t> order_;  ///< methods, best first
};

/// The lines of scenarios and how they are drawn, each once.
std::vector<std::pair<std::string, std::string>> keys_of(
    const std::vector<ScenarioFigure>& scenarios) {
  std::vector<std::pair<std::string, std::string>> keys;
  const auto add = [&](const std::string& name, const std::string& key) {
    const bool known =
        std::any_of(keys.begin(), keys.end(), [&](const auto& one) { return one.first == name; });
    if (!known) keys.emplace_back(name, key);
  };
  for (const auto& [scenario, options] : scenarios)
    for (std::size_t i = 0; i < options.trajectories.size(); ++i) {
      const SceneTrajectory& one = options.trajectories[i];
      add(one.label, fmt::format("stroke=\"{}\"",
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

std::string profile_figure(const ProfileTable& table) {
  return ProfileChart(table).render();
}

std::string rank_figure(const MethodRanks& ranks) {
  return RankDiagram(ranks).render();
}

std::string scenario_figure(const std::vector<ScenarioFigure>& scenarios, std::size_t columns) {
  constexpr double kGap = 10, kCaption = 18;  // pixels
  std::string content;
  double top = 0, width = 0;
  for (std::size_t first = 0; first < scenarios.size(); first += columns) {
    double left = 0, height = 0;
    for (std::size_t i = first; i < std::min(first + columns, scenarios.size()); ++i) {
      const auto& [scenario, options] = scenarios[i];
      const Bounds& bounds = scenario.bounds();
      const double scale = options.max_pixels / std::max(bounds.width(), bounds.height());
      std::string picture = render_svg(scenario, options);
      content += text(left, top + 13, "start", scenario.name()) +
                 picture.insert(4, fmt::format(" x=\"{:.0f}\" y=\"{:.0f}\"", left, top + kCaption));
      left += bounds.width() * scale + kGap;
      height = std::max(height, bounds.height() * scale);
    }
    width = std::max(width, left - kGap);
    top += height + kCaption + kGap;
  }
  top -= kGap;
  const auto keys = keys_of(scenarios);
  for (const auto& [name, key] : keys) {
    top += kCaption;
    content +=
        fmt::format("<polyline points=\"2,{0:.0f} 28,{0:.0f}\" fill=\"none\" {1}/>", top - 4, key);
    content += text(34, top, "start", name);
  }
  return document(width, keys.empty() ? top : top + kGap, content);
}

}  // namespace slalom
