// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/inquiry/tune_space.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace slalom {
namespace {

SpaceParameter real(const std::string& name, double low, double high, double default_value) {
  SpaceParameter parameter;
  parameter.name = name;
  parameter.low = low;
  parameter.high = high;
  parameter.default_value = default_value;
  return parameter;
}

SpaceParameter log_real(const std::string& name, double low, double high, double default_value) {
  SpaceParameter parameter = real(name, low, high, default_value);
  parameter.log = true;
  return parameter;
}

SpaceParameter integer(const std::string& name, double low, double high, double default_value) {
  SpaceParameter parameter = real(name, low, high, default_value);
  parameter.integer = true;
  return parameter;
}

SpaceParameter choice(const std::string& name, const std::vector<std::string>& choices) {
  SpaceParameter parameter;
  parameter.name = name;
  parameter.choices = choices;
  return parameter;
}

SpaceParameter only_if(SpaceParameter parameter, const std::string& name,
                       const std::string& value) {
  parameter.condition = ParameterCondition{name, value};
  return parameter;
}

std::string error_of(const std::vector<SpaceParameter>& parameters) {
  try {
    const ParameterSpace space(parameters, location_of("tune"));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Usage);
    return error.what();
  }
  return "";
}

TEST(ParameterSpace, MapsTheUnitCubeToValues) {
  const ParameterSpace space({real("margin", 0, 0.4, 0.1), log_real("alpha", 0.01, 100, 1),
                              integer("bins", 1, 4, 2), choice("mode", {"a", "b", "c"})});
  // exp(log(0.01) + 0.75 log(10^4)) = 0.01 * 1000.
  EXPECT_EQ(space.from_unit({0.25, 0.75, 0.5, 0.5}), (Configuration{0.1, 10, 3, 1}));
  EXPECT_EQ(space.from_unit({0, 0, 0, 0}), (Configuration{0, 0.01, 1, 0}));
  EXPECT_EQ(space.from_unit({1, 1, 1, 1}), (Configuration{0.4, 100, 4, 2}));
  EXPECT_EQ(space.defaults(), (Configuration{0.1, 1, 2, 0}));
  EXPECT_EQ(space.text(0, 0.1), "0.1");
  EXPECT_EQ(space.text(2, 3), "3");
  EXPECT_EQ(space.text(3, 1), "b");
}

TEST(ParameterSpace, RoundsValuesThatPeopleRead) {
  const ParameterSpace space({real("x", 0, 0.4, 0.1), real("y", 1000, 1000.5, 1000)});
  const Configuration third = space.from_unit({1 / 3.0, 1 / 3.0});
  EXPECT_EQ(space.text(0, third[0]), "0.1333");
  EXPECT_EQ(space.text(1, third[1]), "1000.1667");
}

TEST(ParameterSpace, IntegersAndChoicesHaveEqualParts) {
  const ParameterSpace space(
      {integer("bins", -1, 3, 0), choice("mode", {"a", "b", "c", "d", "e"})});
  std::map<double, int> bins, modes;
  for (int i = 0; i < 1000; ++i) {
    const Configuration configuration = space.from_unit({(i + 0.5) / 1000, (i + 0.5) / 1000});
    ++bins[configuration[0]];
    ++modes[configuration[1]];
  }
  EXPECT_EQ(bins, (std::map<double, int>{{-1, 200}, {0, 200}, {1, 200}, {2, 200}, {3, 200}}));
  EXPECT_EQ(modes, (std::map<double, int>{{0, 200}, {1, 200}, {2, 200}, {3, 200}, {4, 200}}));
}

TEST(ParameterSpace, ParametersWithoutTheirConditionHaveTheirDefault) {
  const ParameterSpace space({choice("mode", {"plain", "smooth"}),
                              only_if(integer("order", 1, 3, 1), "mode", "smooth"),
                              only_if(real("weight", 0, 1, 0.5), "order", "3")});
  EXPECT_EQ(space.from_unit({0.9, 0.9, 0.25}), (Configuration{1, 3, 0.25}));
  EXPECT_EQ(space.from_unit({0.9, 0.5, 0.25}), (Configuration{1, 2, 0.5}));
  EXPECT_EQ(space.from_unit({0.1, 0.9, 0.25}), (Configuration{0, 1, 0.5}));
  EXPECT_TRUE(space.active({1, 3, 0.25}, 2));
  EXPECT_FALSE(space.active({0, 3, 0.25}, 2));  // `order` itself is not active
  RandomEngine engine(1);
  for (int i = 0; i < 100; ++i) {
    const Configuration near = space.sample_around({1, 3, 0.25}, 0.2, engine);
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_TRUE(space.active(near, j) || near[j] == space.defaults()[j]);
  }
}

/// Mean and standard deviation of the normal truncated to [0, 1], by the midpoint rule.
std::pair<double, double> truncated_moments(double mean, double sd) {
  double weight = 0, sum = 0, squares = 0;
  for (int i = 0; i < 10000; ++i) {
    const double x = (i + 0.5) / 10000;
    const double density = std::exp(-0.5 * (x - mean) * (x - mean) / (sd * sd));
    weight += density;
    sum += density * x;
    squares += density * x * x;
  }
  sum /= weight;
  return {sum, std::sqrt(squares / weight - sum * sum)};
}

TEST(ParameterSpace, DrawsTruncatedNormalsInTheUnitCube) {
  const ParameterSpace space({real("x", -2, 2, 0), log_real("y", 0.1, 10, 1)});
  RandomEngine engine(1);
  for (const double center : {0.0, 0.3, 1.0}) {
    const Configuration middle = {-2 + 4 * center, std::pow(10, -1 + 2 * center)};
    const auto [mean, sd] = truncated_moments(center, 0.2);
    const int n = 4000;
    double sums[2] = {}, squares[2] = {};
    for (int i = 0; i < n; ++i) {
      const Configuration near = space.sample_around(middle, 0.2, engine);
      const double unit[] = {(near[0] + 2) / 4, (std::log10(near[1]) + 1) / 2};
      for (int j = 0; j < 2; ++j) {
        ASSERT_GE(unit[j], 0);
        ASSERT_LE(unit[j], 1);
        sums[j] += unit[j];
        squares[j] += unit[j] * unit[j];
      }
    }
    for (int j = 0; j < 2; ++j) {
      EXPECT_NEAR(sums[j] / n, mean, 4 * sd / std::sqrt(n));
      EXPECT_NEAR(std::sqrt(squares[j] / n - sums[j] * sums[j] / n / n), sd, 0.05 * sd);
    }
  }
}

TEST(ParameterSpace, KeepsChoicesWithOneMinusTheStandardDeviation) {
  const ParameterSpace space({choice("mode", {"a", "b", "c"})});
  RandomEngine engine(1);
  std::map<double, int> counts;
  const int n = 3000;
  for (int i = 0; i < n; ++i) ++counts[space.sample_around({1}, 0.2, engine)[0]];
  EXPECT_NEAR(counts[0], 0.1 * n, 4 * std::sqrt(0.09 * n));
  EXPECT_NEAR(counts[1], 0.8 * n, 4 * std::sqrt(0.16 * n));
  EXPECT_NEAR(counts[2], 0.1 * n, 4 * std::sqrt(0.09 * n));
}

TEST(ParameterSpace, RefusesInvalidParameters) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_of({}), "tune: no parameter to tune; expected at least one");
  EXPECT_EQ(error_of({real("x", 1, 1, 1)}),
            "tune.x: empty range: low 1, high 1; expected low < high");
  EXPECT_EQ(error_of({real("x", nan, 1, 1)}),
            "tune.x: empty range: low nan, high 1; expected low < high");
  EXPECT_EQ(error_of({log_real("x", 0, 1, 1)}),
            "tune.x: log of a range that is not positive: low 0, high 1; expected low > 0");
  EXPECT_EQ(error_of({real("x", 0, 1, 2)}), "tune.x: invalid default 2; expected in [0, 1]");
  EXPECT_EQ(error_of({integer("x", 0, 3, 1.5)}),
            "tune.x: invalid default 1.5; expected an integer in [0, 3]");
  EXPECT_EQ(error_of({integer("x", 0, 3.5, 1)}),
            "tune.x: ends of integers: low 0, high 3.5; expected integers");
  EXPECT_EQ(error_of({real("x", 0, 1, 0), real("x", 0, 2, 0)}),
            "tune.x: duplicate parameter; expected each parameter once");
  EXPECT_EQ(error_of({choice("mode", {"a"})}), "tune.mode: one choice: a; expected two or more");
  EXPECT_EQ(error_of({choice("mode", {"a", "b", "a"})}),
            "tune.mode: duplicate choice a; expected each choice once");
  SpaceParameter outside = choice("mode", {"a", "b"});
  outside.default_value = 2;
  EXPECT_EQ(error_of({outside}), "tune.mode: invalid default 2; expected the index of one of a, b");
}

TEST(ParameterSpace, RefusesInvalidConditions) {
  const SpaceParameter mode = choice("mode", {"plain", "smooth"});
  const SpaceParameter weight = real("weight", 0, 1, 0.5);
  EXPECT_EQ(error_of({only_if(weight, "mode", "plain"), mode}),
            "tune.weight: condition on 'mode'; expected a parameter before it");
  EXPECT_EQ(error_of({only_if(weight, "weight", "1")}),
            "tune.weight: condition on 'weight'; expected a parameter before it");
  EXPECT_EQ(error_of({mode, only_if(weight, "mode", "smoth")}),
            "tune.weight: condition 'mode = smoth'; expected 'smooth'");
  for (const std::string value : {"4", "2.5", "many", "02"})
    EXPECT_EQ(error_of({integer("order", 1, 3, 1), only_if(weight, "order", value)}),
              "tune.weight: condition 'order = " + value +
                  "'; expected a choice, or an integer in the range of a parameter of integers");
  EXPECT_NE(error_of({real("order", 1, 3, 1), only_if(weight, "order", "2")}), "");
}

TEST(SobolPoints, AreOnePerIntervalOfEachAxis) {
  // A Sobol sequence begins with the origin, which Boost leaves out: 2^k - 1 points follow it, and
  // miss one interval.
  constexpr std::size_t kDimensions = 20, kPoints = 128;
  SobolPoints points(kDimensions, 7);
  std::vector<std::set<double>> intervals(kDimensions);
  for (std::size_t i = 1; i < kPoints; ++i) {
    const std::vector<double> point = points.next();
    for (std::size_t j = 0; j < kDimensions; ++j) {
      EXPECT_GE(point[j], 0);
      EXPECT_LT(point[j], 1);
      intervals[j].insert(std::floor(point[j] * kPoints));
    }
  }
  for (const std::set<double>& axis : intervals) EXPECT_EQ(axis.size(), kPoints - 1);
}

TEST(SobolPoints, DependOnTheSeedOnly) {
  SobolPoints first(3, 1), same(3, 1), other(3, 2);
  for (int i = 0; i < 10; ++i) {
    const std::vector<double> point = first.next();
    EXPECT_EQ(point, same.next());
    EXPECT_NE(point, other.next());
  }
}

/// Differences between points, by exclusive or, do not depend on the seed: those of the published
/// sequence (Joe and Kuo 2008: 0, 1/2, 3/4, 1/4, 3/8, ... on the first axis; 0, 1/2, 1/4, 3/4, 3/8,
/// ... on the second one).
TEST(SobolPoints, AreThePublishedSequence) {
  const std::vector<std::vector<double>> published = {
      {0.5, 0.5}, {0.75, 0.25}, {0.25, 0.75}, {0.375, 0.375}, {0.875, 0.875}};
  SobolPoints points(2, 3);
  const auto bits = [](double x) { return static_cast<std::uint64_t>(x * 0x1p53); };
  const std::vector<double> first = points.next();
  for (std::size_t i = 1; i < published.size(); ++i) {
    const std::vector<double> point = points.next();
    for (std::size_t j = 0; j < 2; ++j)
      EXPECT_EQ(bits(point[j]) ^ bits(first[j]), bits(published[i][j]) ^ bits(published[0][j]));
  }
}

}  // namespace
}  // namespace slalom
