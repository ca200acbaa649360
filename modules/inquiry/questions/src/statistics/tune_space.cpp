// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/text.h>
#include <slalom/inquiry/tune_space.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace slalom {
namespace {

double scaled(const SpaceParameter& parameter, double value) {
  return parameter.log ? math::log(value) : value;
}

/// The scaled ends; those of integers are half a step further, so that each has an equal part.
std::pair<double, double> scaled_ends(const SpaceParameter& parameter) {
  const double margin = parameter.integer ? 0.5 : 0;
  return {scaled(parameter, parameter.low - margin), scaled(parameter, parameter.high + margin)};
}

/// Rounds to a thousandth of the range or finer, for texts that people read.
double round_value(const SpaceParameter& parameter, double value) {
  if (parameter.integer) return std::clamp(std::round(value), parameter.low, parameter.high);
  int digits = 4;
  double size = std::max(std::abs(parameter.low), std::abs(parameter.high));
  for (; size > parameter.high - parameter.low && digits < 17; size /= 10) ++digits;
  double rounded = value;
  parse_number(fmt::format("{:.{}g}", value, digits), rounded);
  return std::clamp(rounded, parameter.low, parameter.high);
}

double value_at(const SpaceParameter& parameter, double unit) {
  if (const std::size_t n = parameter.choices.size(); n > 0)
    return std::min(std::floor(unit * static_cast<double>(n)), static_cast<double>(n - 1));
  const auto [low, high] = scaled_ends(parameter);
  const double value = low + unit * (high - low);
  return round_value(parameter, parameter.log ? math::exp(value) : value);
}

bool is_integer(double value) {
  return std::floor(value) == value;
}

void check_range(const SpaceParameter& p, const std::string& where) {
  const std::string ends = "low " + format_number(p.low) + ", high " + format_number(p.high);
  if (!std::isfinite(p.low) || !std::isfinite(p.high) || !(p.low < p.high))
    throw usage_error(where, "empty range: " + ends, "low < high");
  if (p.log && p.low <= 0)
    throw usage_error(where, "log of a range that is not positive: " + ends, "low > 0");
  if (p.integer && !(is_integer(p.low) && is_integer(p.high)))
    throw usage_error(where, "ends of integers: " + ends, "integers");
  if (p.default_value < p.low || p.default_value > p.high || !std::isfinite(p.default_value) ||
      (p.integer && !is_integer(p.default_value)))
    throw usage_error(where, "invalid default " + format_number(p.default_value),
                      (p.integer ? "an integer in [" : "in [") + format_number(p.low) + ", " +
                          format_number(p.high) + "]");
}

void check_choices(const SpaceParameter& p, const std::string& where) {
  if (p.choices.size() < 2) throw usage_error(where, "one choice: " + p.choices[0], "two or more");
  for (std::size_t i = 0; i < p.choices.size(); ++i)
    if (std::count(p.choices.begin(), p.choices.end(), p.choices[i]) > 1)
      throw usage_error(where, "duplicate choice " + p.choices[i], "each choice once");
  if (!is_integer(p.default_value) || p.default_value < 0 ||
      p.default_value >= static_cast<double>(p.choices.size()))
    throw usage_error(where, "invalid default " + format_number(p.default_value),
                      "the index of one of " + join(p.choices, ", "));
}

}  // namespace

ParameterSpace::ParameterSpace(std::vector<SpaceParameter> parameters, const OptionLocation& where)
    : parameters_(std::move(parameters)) {
  if (parameters_.empty()) throw usage_error(where(""), "no parameter to tune", "at least one");
  for (std::size_t i = 0; i < size(); ++i) check(i, where);
}

void ParameterSpace::check(std::size_t parameter, const OptionLocation& where) const {
  const SpaceParameter& p = parameters_[parameter];
  if (index_of(p.name) != parameter)
    throw usage_error(where(p.name), "duplicate parameter", "each parameter once");
  (p.choices.empty() ? check_range : check_choices)(p, where(p.name));
  if (p.condition) check_condition(parameter, where(p.name));
}

void ParameterSpace::check_condition(std::size_t parameter, const std::string& where) const {
  const ParameterCondition& condition = *parameters_[parameter].condition;
  const std::size_t other = index_of(condition.name);
  if (other >= parameter)
    throw usage_error(where, "condition on '" + condition.name + "'", "a parameter before it");
  const SpaceParameter& o = parameters_[other];
  double value = 0;
  if (!o.choices.empty()) {
    if (!contains(o.choices, condition.value))
      throw usage_error(where, "condition '" + condition.name + " = " + condition.value + "'",
                        expected_name(condition.value, o.choices));
  } else if (!o.integer || !parse_number(condition.value, value) || !is_integer(value) ||
             value < o.low || value > o.high || condition.value != format_number(value)) {
    throw usage_error(where, "condition '" + condition.name + " = " + condition.value + "'",
                      "a choice, or an integer in the range of a parameter of integers");
  }
}

std::size_t ParameterSpace::index_of(const std::string& name) const {
  const auto found = std::find_if(parameters_.begin(), parameters_.end(),
                                  [&name](const SpaceParameter& p) { return p.name == name; });
  return static_cast<std::size_t>(found - parameters_.begin());
}

Configuration ParameterSpace::defaults() const {
  Configuration values;
  for (const SpaceParameter& p : parameters_) values.push_back(p.default_value);
  return values;
}

bool ParameterSpace::active(const Configuration& configuration, std::size_t parameter) const {
  const auto& condition = parameters_[parameter].condition;
  if (!condition) return true;
  const std::size_t other = index_of(condition->name);
  return text(other, configuration[other]) == condition->value && active(configuration, other);
}

std::string ParameterSpace::text(std::size_t parameter, double value) const {
  const std::vector<std::string>& choices = parameters_[parameter].choices;
  return choices.empty() ? format_number(value) : choices.at(static_cast<std::size_t>(value));
}

Configuration ParameterSpace::with_inactive_defaults(Configuration configuration) const {
  for (std::size_t i = 0; i < size(); ++i)
    if (!active(configuration, i)) configuration[i] = parameters_[i].default_value;
  return configuration;
}

Configuration ParameterSpace::from_unit(const std::vector<double>& point) const {
  Configuration values;
  for (std::size_t i = 0; i < size(); ++i) values.push_back(value_at(parameters_[i], point[i]));
  return with_inactive_defaults(std::move(values));
}

double ParameterSpace::to_unit(std::size_t parameter, double value) const {
  const auto [low, high] = scaled_ends(parameters_[parameter]);
  return (scaled(parameters_[parameter], value) - low) / (high - low);
}

double ParameterSpace::sample_value(std::size_t parameter, double center, double sd,
                                    RandomEngine& engine) const {
  const SpaceParameter& p = parameters_[parameter];
  if (const int n = static_cast<int>(p.choices.size()); n > 0) {
    if (uniform_real(engine, 0, 1) >= sd) return center;
    const double other = uniform_int(engine, 0, n - 2);
    return other < center ? other : other + 1;
  }
  const double mean = to_unit(parameter, center);
  double unit = -1;
  while (unit < 0 || unit > 1) unit = normal(engine, mean, sd);
  return value_at(p, unit);
}

Configuration ParameterSpace::sample_around(const Configuration& center, double sd,
                                            RandomEngine& engine) const {
  Configuration values;
  for (std::size_t i = 0; i < size(); ++i) values.push_back(sample_value(i, center[i], sd, engine));
  return with_inactive_defaults(std::move(values));
}

SobolPoints::SobolPoints(std::size_t dimensions, std::uint64_t seed) : engine_(dimensions) {
  RandomEngine random(seed);
  for (std::size_t i = 0; i < dimensions; ++i) shifts_.push_back(random());
}

std::vector<double> SobolPoints::next() {
  std::vector<double> point;
  for (const std::uint64_t shift : shifts_)
    point.push_back(static_cast<double>((engine_() ^ shift) >> 11) * 0x1p-53);
  return point;
}

}  // namespace slalom
