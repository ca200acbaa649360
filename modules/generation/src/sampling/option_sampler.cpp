// SPDX-License-Identifier: BSD-3-Clause
#include "option_sampler.h"

#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/text.h>
#include <slalom/scenario/grid_map.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>

namespace slalom {
namespace {

/// The default of a length option of the family; 0 if there is none.
double default_length(const std::string& family, const std::string& key) {
  double found = 0;
  OptionFunction find([&](const Option& option) {
    const double* const length = option.get_if<double>();
    if (option.key == key && option.unit == "m" && length != nullptr) found = *length;
  });
  visit_generator_options(family, find);
  return found;
}

double log_uniform(RandomEngine& engine, double low, double high) {
  return math::exp(uniform_real(engine, math::log(low), math::log(high)));
}

/// Reads the options that are set in the section, and draws values for all others.
class OptionDrawer : public OptionVisitor {
 public:
  OptionDrawer(const IniFile& ini, const std::string& section, const CoverageOptions& limits,
               double scale, double spread, RandomEngine& engine)
      : ini_(ini),
        section_(section),
        given_(ini, section),
        limits_(limits),
        scale_(scale),
        spread_(spread),
        engine_(engine) {}

  void visit(const Option& option) override {
    if (is_given(option.key) || option.get_if<std::uint64_t>() != nullptr)
      given_.visit(option);
    else if (double* number = option.get_if<double>();
             number != nullptr && option.key != "resolution")
      draw(option, *number);
    else if (int* integer = option.get_if<int>(); integer != nullptr && varies())
      draw(option, *integer);
    else if (bool* flag = option.get_if<bool>();
             flag != nullptr && option.key != "people" && varies())
      *flag = uniform_int(engine_, 0, 1) == 1;
    else if (std::string* text = option.get_if<std::string>();
             text != nullptr && !option.choices.empty() && varies())
      *text = option.choices[static_cast<std::size_t>(
          uniform_int(engine_, 0, static_cast<int>(option.choices.size()) - 1))];
  }

 private:
  template <typename Number>
  struct Minimum {
    double drawn;
    Number* value;
  };
  template <typename Number>
  using Minima = std::map<std::string, Minimum<Number>>;

  void draw(const Option& option, double& value) {
    double drawn = value * (option.unit == "m" ? scale_ : 1);
    const bool is_fraction = option.range.low == 0 && option.range.high == 1;
    if (is_floor(option.key)) {
      drawn = std::clamp(drawn * log_uniform(engine_, 0.8, 1.25), limits_.min_extent,
                         limits_.max_extent);
    } else if (varies()) {
      drawn = is_fraction ? uniform_real(engine_, 0, 1) : drawn * factor();
    }
    set(option.key, value, clamped(drawn, option.range), drawn);
  }
  void draw(const Option& option, int& value) {
    const double drawn = std::round(clamped(value == 0 ? value : value * factor(), option.range));
    const double whole = std::clamp(drawn, -1e9, 1e9);
    set(option.key, value, whole, whole);
  }

  bool is_given(const std::string& key) const { return ini_.get(section_, key).has_value(); }
  static bool is_floor(const std::string& key) { return key == "width" || key == "height"; }
  bool varies() { return uniform_real(engine_, 0, 1) < spread_; }
  double factor() { return log_uniform(engine_, 0.25, 4); }
  static double clamped(double value, const Range& range) {
    const double low = range.low_open ? range.low + 1e-3 : range.low;
    return std::clamp(value, std::min(low, range.high), range.high);
  }
  /// Swaps the values of min_X and max_X where they are in the wrong order; min_X is visited first.
  template <typename Number>
  void set(const std::string& key, Number& value, double valid, double drawn) {
    value = static_cast<Number>(valid);
    auto& minima = std::get<Minima<Number>>(minima_);
    if (starts_with(key, "min_")) minima[key.substr(4)] = {drawn, &value};
    if (!starts_with(key, "max_")) return;
    const auto minimum = minima.find(key.substr(4));
    if (minimum != minima.end() && minimum->second.drawn > drawn)
      std::swap(*minimum->second.value, value);
  }

  const IniFile& ini_;
  std::string section_;
  OptionReader given_;
  const CoverageOptions& limits_;
  double scale_, spread_;
  RandomEngine& engine_;
  std::tuple<Minima<double>, Minima<int>> minima_;
};

double draw_scale(const CoverageOptions& limits, const std::string& family, const IniFile& ini,
                  RandomEngine& engine) {
  const double width = default_length(family, "width");
  const std::string section = "generator." + family;
  if (width <= 0 || ini.get(section, "width") || ini.get(section, "height")) return 1;
  // Larger workspaces result from mutations; sampling thousands of obstacles would be too slow.
  const double largest = std::max(limits.min_extent, std::min(limits.max_extent, 40.0));
  return log_uniform(engine, limits.min_extent, largest) / width;
}

/// Caches maps, because each draw of options creates a new generator. Thread-safe.
MapLoader cached_loader(const MapLoader& load_map) {
  using mrpt::maps::COccupancyGridMap2D;
  struct Cache {
    std::mutex mutex;
    std::map<std::string, COccupancyGridMap2D> maps;
  };
  if (!load_map) return load_map;
  return [load_map, cache = std::make_shared<Cache>()](const std::string& path) {
    const std::lock_guard<std::mutex> lock(cache->mutex);
    auto cached = cache->maps.find(path);
    if (cached == cache->maps.end()) {
      cached = cache->maps.try_emplace(path).first;
      cached->second.copyMapContentFrom(load_map(path));
    }
    COccupancyGridMap2D copy = one_cell_map();
    copy.copyMapContentFrom(cached->second);
    return copy;
  };
}

}  // namespace

OptionSampler::OptionSampler(const CoveragePlan& plan, const MapLoader& load_map)
    : plan_(plan), load_map_(cached_loader(load_map)) {
  // Reports configuration errors of the families immediately.
  for (const std::string& family : plan_.families)
    make_generator(family, plan_.ini, {1, load_map_});
}

std::unique_ptr<Generator> OptionSampler::draw(RandomEngine& engine) const {
  const int last = static_cast<int>(plan_.families.size()) - 1;
  const std::string& family =
      plan_.families[static_cast<std::size_t>(uniform_int(engine, 0, last))];
  const std::string section = "generator." + family;
  for (const double spread : {0.7, 0.4, 0.2, 0.0}) {
    const double scale = draw_scale(plan_.options, family, plan_.ini, engine);
    OptionDrawer drawer(plan_.ini, section, plan_.options, scale, spread, engine);
    try {
      return make_generator(family, drawer, {1, load_map_});
    } catch (const Error&) {
      // Contradictory options: retry closer to the defaults.
    }
  }
  return nullptr;
}

}  // namespace slalom
