// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/parameter.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/generation/generator.h>
#include <slalom/robot/robot_model.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace slalom {
namespace {

/// The numeric options of a section by the name of the parameter: "width" for min_width and
/// max_width.
class ParameterFinder : public OptionVisitor {
 public:
  void visit(const Option& option) override {
    const int* const integer = option.get_if<int>();
    const double* const real = option.get_if<double>();
    if (integer == nullptr && real == nullptr) return;
    const bool is_end = starts_with(option.key, "min_") || starts_with(option.key, "max_");
    Parameter& found = is_end ? ranges_[option.key.substr(4)] : options_[option.key];
    found.keys.push_back(option.key);
    found.unit = option.unit == "-" ? "" : option.unit;
    found.integer = integer != nullptr;
    found.defaults.push_back(integer != nullptr ? *integer : *real);
  }
  std::map<std::string, Parameter> take() {
    // A range with one end only, such as max_v, is an option of its own.
    for (auto& [name, range] : ranges_)
      options_.emplace(range.keys.size() == 1 ? range.keys[0] : name, std::move(range));
    return std::move(options_);
  }

 private:
  std::map<std::string, Parameter> options_, ranges_;
};

constexpr char kRobot[] = "robot", kSensor[] = "sensor";

std::map<std::string, Parameter> parameters_of(const std::string& owner) {
  ParameterFinder finder;
  if (owner == kRobot)
    RobotModel().visit(finder);
  else if (owner == kSensor)
    SensorModel().visit(finder);
  else
    visit_generator_options(owner, finder);
  return finder.take();
}

std::vector<std::string> owners() {
  std::vector<std::string> names = generator_names();
  names.insert(names.end(), {kRobot, kSensor});
  return names;
}

}  // namespace

double rounded(double value) {
  return std::round(value * 1e9) / 1e9;
}

void Parameter::set(IniFile& ini, double value) const {
  for (const std::string& key : keys) ini.set(section, key, format_number(value), "--of ");
}

Parameter parse_parameter(const std::string& name, const std::string& option_name) {
  const std::size_t dot = std::min(name.find('.'), name.size());
  const std::string owner = name.substr(0, dot);
  if (!contains(owners(), owner))
    throw usage_error(option_name + " " + name, "unknown family, robot or sensor '" + owner + "'",
                      expected_name(owner, owners()));
  const std::string option = name.substr(std::min(dot + 1, name.size()));
  const std::map<std::string, Parameter> known = parameters_of(owner);
  const auto found = known.find(option);
  if (found == known.end()) {
    std::vector<std::string> names;
    for (const auto& [key, parameter] : known) names.push_back(key);
    throw usage_error(option_name + " " + name, owner + " has no numeric option '" + option + "'",
                      expected_name(option, names));
  }
  Parameter parameter = found->second;
  parameter.name = name;
  parameter.family = owner == kRobot || owner == kSensor ? "" : owner;
  parameter.section = parameter.family.empty() ? owner : "generator." + owner;
  return parameter;
}

std::vector<std::string> parameter_names() {
  std::vector<std::string> names;
  for (const std::string& owner : owners())
    for (const auto& [key, parameter] : parameters_of(owner)) names.push_back(owner + "." + key);
  return names;
}

std::size_t Bins::count() const {
  const double count = std::abs(to - from) / step;
  if (to == from)
    throw usage_error(to_option + " " + value_text(to), "is the value of " + from_option,
                      "another value");
  if (!(step > 0) || !std::isfinite(step))
    throw usage_error(step_option + " " + format_number(step), "is not positive",
                      "a positive number");
  const bool complete = std::abs(count - std::round(count)) < 1e-6 * std::max(1.0, count);
  if (!(count >= 0.5 && count <= static_cast<double>(kMaxBins) && complete))
    throw usage_error(
        step_option + " " + format_number(step),
        "does not divide the range from " + value_text(from) + " to " + value_text(to),
        "1 to 10000 equal steps");
  for (const double value : {from, to, step})
    if (integer && value != std::round(value))
      throw usage_error(from_option + ", " + to_option + ", " + step_option,
                        "'" + format_number(value) + "'", "integers for this parameter");
  return static_cast<std::size_t>(std::lround(count));
}

double Bins::edge(std::size_t bin) const {
  return rounded(from + (to > from ? step : -step) * static_cast<double>(bin));
}

double Bins::hardest(const BinRange& bins) const {
  return integer ? edge(bins.end) + (to > from ? -1 : 1) : edge(bins.end);
}

double Bins::draw(const BinRange& bins, RandomEngine& engine) const {
  const auto [low, high] = std::minmax({edge(bins.first), hardest(bins)});
  if (integer) return uniform_int(engine, static_cast<int>(low), static_cast<int>(high));
  return uniform_real(engine, low, high);
}

std::string Bins::text(const BinRange& bins) const {
  const std::string first = format_number(edge(bins.first)), last = format_number(hardest(bins));
  return "[" + first + ", " + last + "]" + (unit.empty() ? "" : " " + unit);
}

std::string Bins::value_text(double value) const {
  return format_number(value) + (unit.empty() ? "" : " " + unit);
}

}  // namespace slalom
