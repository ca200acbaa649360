// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/options.h>
#include <slalom/core/text.h>
#include <slalom/generation/generator.h>
#include <slalom/generation/moving.h>
#include <slalom/generation/obstacles.h>
#include <slalom/generation/start_goal.h>

#include <cmath>
#include <string>

namespace slalom {

/// Checks the options of one family.
class FamilyChecks {
 public:
  FamilyChecks(const std::string& family, const GeneratorContext& context)
      : context_(context),
        where_(context.where ? context.where : location_of("generator." + family)) {}

  /// The options with their lengths (in m) scaled. Throws Error (Usage) for a value out of range.
  template <typename Options>
  Options scaled(Options options) const {
    check_options(options, where_);
    for_each_option(options, [&](const Option& option) {
      if (double* length = option.get_if<double>(); length != nullptr && option.unit == "m")
        *length *= context_.length_scale;
    });
    return options;
  }

  /// Throws Error (Usage) for `key` unless `valid`.
  void expect(bool valid, const std::string& key, const std::string& what,
              const std::string& expected) const {
    if (!valid) throw usage_error(where_(key), what, expected);
  }

  /// Expects low_value <= high_value.
  void expect_order(const std::string& low, double low_value, const std::string& high,
                    double high_value) const {
    expect(low_value <= high_value, high, "is less than " + low,
           "at least " + format_number(low_value));
  }
  void expect_valid(const SizeOptions& size) const {
    expect_order("min_size", size.min_size, "max_size", size.max_size);
  }
  void expect_valid(const ObstacleOptions& options) const {
    expect_order("min_obstacles", options.min_obstacles, "max_obstacles", options.max_obstacles);
    expect_valid(options.size);
  }

  void expect_valid(const MoverOptions& options) const {
    expect_order("min_movers", options.min_movers, "max_movers", options.max_movers);
    expect_order("min_radius", options.min_radius, "max_radius", options.max_radius);
    expect_order("min_speed", options.min_speed, "max_speed", options.max_speed);
  }
  /// Expects that all movers fit into a passage of that width (m).
  void expect_movers_fit(const MoverOptions& options, double width) const {
    expect(options.max_movers == 0 || 2 * (options.max_radius + kWallMargin) < width, "max_radius",
           "moving obstacles do not fit between the walls",
           "less than " + format_number(width / 2 - kWallMargin));
  }

  /// Expects that start and goal can be min_distance apart in a workspace of this size (m).
  void expect_start_goal_fit(const StartGoalOptions& start_goal, double width,
                             double height) const {
    const double m = 2 * start_goal.margin;
    const bool fits =
        m < width && m < height && math::hypot(width - m, height - m) >= start_goal.min_distance;
    expect(fits, "min_distance", "start and goal cannot be min_distance apart within the margins",
           "a larger workspace or smaller min_distance and margin");
  }

  const GeneratorContext& context() const { return context_; }

 private:
  const GeneratorContext& context_;
  OptionLocation where_;
};

}  // namespace slalom
