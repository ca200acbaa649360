// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/core/random.h>

#include <boost/random/sobol.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Names a parameter and the text of one of its values.
struct ParameterCondition {
  std::string name, value;
};

/// A parameter with a range, or with choices.
struct SpaceParameter {
  std::string name;
  double default_value = 0;  ///< an index, if there are choices
  double low = 0, high = 1;
  bool log = false;      ///< equal ratios are equally far apart
  bool integer = false;  ///< the values are integers
  std::vector<std::string> choices;
  /// The parameter matters only if another one, which is before it, has a value.
  std::optional<ParameterCondition> condition;
};

/// One value per parameter; an index, if it has choices.
using Configuration = std::vector<double>;

/// The space of the configurations of a method.
///
/// Parameters whose condition does not hold have their default, so that configurations that differ
/// are different configurations. Values are rounded to a thousandth of the range or finer.
class ParameterSpace {
 public:
  /// Throws Error (Usage) for invalid parameters.
  explicit ParameterSpace(std::vector<SpaceParameter> parameters,
                          const OptionLocation& where = location_of("ParameterSpace"));

  std::size_t size() const { return parameters_.size(); }
  const std::vector<SpaceParameter>& parameters() const { return parameters_; }
  Configuration defaults() const;

  /// Whether the condition of a parameter holds, and that of the parameter that it names.
  bool active(const Configuration& configuration, std::size_t parameter) const;
  std::string text(std::size_t parameter, double value) const;

  /// The configuration at a point of the unit cube; choices and integers have equal parts of it.
  Configuration from_unit(const std::vector<double>& point) const;

  /// The coordinate of a value of a parameter with a range in the unit cube; of an integer, that of
  /// the middle of its part.
  double to_unit(std::size_t parameter, double value) const;

  /// A configuration around another one: normal with the standard deviation `sd` in the unit cube,
  /// truncated to it. A choice is kept with a probability of 1 - sd, otherwise it becomes one of
  /// the others.
  Configuration sample_around(const Configuration& center, double sd, RandomEngine& engine) const;

 private:
  void check(std::size_t parameter, const OptionLocation& where) const;
  void check_condition(std::size_t parameter, const std::string& where) const;
  std::size_t index_of(const std::string& name) const;  ///< size() if there is none
  double sample_value(std::size_t parameter, double center, double sd, RandomEngine& engine) const;
  Configuration with_inactive_defaults(Configuration configuration) const;

  std::vector<SpaceParameter> parameters_;
};

/// Points of the unit cube that fill it evenly (Sobol 1967, with the direction numbers of Joe and
/// Kuo 2008 in Boost.Random): of the first 2^k - 1 points, each interval [i, i + 1) / 2^k of each
/// axis but one has one. A seed shifts them by exclusive or, which keeps that. Integers only, with
/// the same tables since Boost 1.74: the same on all platforms.
class SobolPoints {
 public:
  SobolPoints(std::size_t dimensions, std::uint64_t seed);

  std::vector<double> next();

 private:
  boost::random::sobol engine_;
  std::vector<std::uint64_t> shifts_;
};

}  // namespace slalom
