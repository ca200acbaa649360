// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/generation/coverage.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace slalom {
namespace {

constexpr char kSection[] = "coverage";
constexpr std::size_t kMaxAxes = 3;
constexpr double kMaxBins = 1e5;

/// Descriptors whose values lie in [0, 1] by definition.
constexpr std::array kUnitIntervalDescriptors = {
    "density",         "cspace_density", "clearness",         "confinement",     "confinement_path",
    "narrow_fraction", "trap_fraction",  "occupancy_entropy", "goal_visibility", "dynamic_density"};

/// The keys of a descriptor, read as text and parsed here.
struct AxisKeys {
  std::string edges, range;
};

/// Reads the section: the plain options first, then the keys of each descriptor named in them.
class PlanReader {
 public:
  explicit PlanReader(const IniFile& ini) : ini_(ini), reader_(ini, kSection) {}

  CoverageOptions options() {
    CoverageOptions options;
    options.visit(reader_);
    if (options.min_extent > options.max_extent)
      throw error("max_extent", "is less than min_extent", "at least " + text(options.min_extent));
    if (options.min_distance > std::sqrt(2) * options.max_extent)
      throw error("min_distance", "exceeds the diagonal of the largest workspace",
                  "at most " + text(std::sqrt(2) * options.max_extent) + " m");
    return options;
  }

  std::vector<CoverageAxis> axes(const CoverageOptions& options) {
    const std::vector<std::string> ids = axis_ids(options);
    std::vector<AxisKeys> keys(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
      reader_.option("edges." + ids[i], keys[i].edges, "edges of bins, comma separated");
      reader_.option("range." + ids[i], keys[i].range, "lower and upper edge of equal bins");
    }
    reader_.reject_unknown_keys();
    const std::vector<int> counts = bin_counts(options, ids.size());
    std::vector<CoverageAxis> axes;
    double bins = 1;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      axes.push_back({ids[i], edges_of(ids[i], keys[i], counts[i])});
      bins *= static_cast<double>(axes.back().size());
    }
    if (bins > kMaxBins)
      throw error("bins", "specifies " + text(bins) + " bins", "at most " + text(kMaxBins));
    return axes;
  }

 private:
  Error error(const std::string& key, const std::string& what, const std::string& expected) const {
    return usage_error(ini_.where(kSection, key), what, expected);
  }
  static std::string text(double number) { return format_number(number); }

  std::vector<std::string> axis_ids(const CoverageOptions& options) const {
    const std::vector<std::string> ids = split(options.descriptors, ',');
    if (options.descriptors.empty() || ids.size() > kMaxAxes)
      throw error("descriptors",
                  "lists " + std::to_string(options.descriptors.empty() ? 0 : ids.size()) + " ids",
                  "one to three descriptor ids");
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (std::find(ids.begin(), ids.begin() + static_cast<long>(i), ids[i]) !=
          ids.begin() + static_cast<long>(i))
        throw error("descriptors", "duplicate id '" + ids[i] + "'", "each id once");
      check_id(ids[i]);
    }
    return ids;
  }

  void check_id(const std::string& id) const {
    if (contains(descriptor_ids(), id)) return;
    throw error("descriptors", "unknown id '" + id + "'", expected_name(id, descriptor_ids()));
  }

  std::vector<int> bin_counts(const CoverageOptions& options, std::size_t axes) const {
    std::vector<int> counts;
    for (const std::string& part : split(options.bins, ',')) {
      long long count = 0;
      if (!parse_integer(part, count) || count < 1 || count > 10000)
        throw error("bins", "invalid number '" + part + "'", "integers from 1 to 10000");
      counts.push_back(static_cast<int>(count));
    }
    if (counts.size() == 1) counts.resize(axes, counts[0]);
    if (counts.size() != axes)
      throw error("bins", "has " + count_text(counts.size(), "number"),
                  "one number, or one for each of " + std::to_string(axes) + " descriptors");
    return counts;
  }

  std::vector<double> numbers(const std::string& key, const std::string& list) const {
    std::vector<double> numbers;
    for (const std::string& part : split(list, ',')) {
      double number = 0;
      if (!parse_number(part, number) || !std::isfinite(number))
        throw error(key, "invalid number '" + part + "'", "numbers, comma separated");
      if (!numbers.empty() && number <= numbers.back())
        throw error(key, "'" + part + "' is not greater than " + text(numbers.back()),
                    "ascending numbers");
      numbers.push_back(number);
    }
    if (numbers.size() < 2) throw error(key, "has one edge", "two or more");
    return numbers;
  }

  std::vector<double> edges_of(const std::string& id, const AxisKeys& keys, int count) const {
    if (!keys.edges.empty()) {
      if (!keys.range.empty())
        throw error("range." + id, "conflicts with edges." + id, "only one of them");
      return numbers("edges." + id, keys.edges);
    }
    std::vector<double> range = {0, 1};
    if (!keys.range.empty()) {
      range = numbers("range." + id, keys.range);
      if (range.size() != 2) throw error("range." + id, "has more than two numbers", "two");
    } else if (std::find(kUnitIntervalDescriptors.begin(), kUnitIntervalDescriptors.end(), id) ==
               kUnitIntervalDescriptors.end()) {
      throw error("range." + id, "is missing", "the lower and upper edge, or edges." + id);
    }
    std::vector<double> edges;
    for (int i = 0; i < count; ++i) edges.push_back(range[0] + (range[1] - range[0]) * i / count);
    edges.push_back(range[1]);
    return edges;
  }

  const IniFile& ini_;
  OptionReader reader_;
};

}  // namespace

void CoverageOptions::visit(OptionVisitor& v) {
  v.option("descriptors", descriptors, "descriptors to cover, comma separated; several jointly");
  v.option("bins", bins, "equal bins of each descriptor, comma separated, or one number for all");
  v.option("per_bin", per_bin, "-", "scenarios wanted in each bin", Range::between(1, 1e6));
  v.option("min_difference", min_difference, "-", "between any two scenarios",
           Range::between(0, 1));
  v.option("budget_evaluations", budget_evaluations, "-", "candidates evaluated in total",
           Range::between(1, 1e9));
  v.option("budget_time", budget_time, "s",
           "wall-clock time, 0: unlimited; not repeatable if it expires", Range::at_least(0));
  v.option("patience", patience, "-",
           "evaluations per bin without a new scenario before it is closed",
           Range::between(1, 1e9));
  v.option("fresh_fraction", fresh_fraction, "-",
           "fraction of candidates generated without a parent", Range::between(0, 1));
  v.option("min_extent", min_extent, "m", "minimum side of the workspace", Range::positive());
  v.option("max_extent", max_extent, "m", "maximum side of the workspace", Range{0, 1000, true});
  v.option("min_distance", min_distance, "m", "straight-line distance from start to goal",
           Range::at_least(0));
  v.option("max_obstacles", max_obstacles, "-", "maximum number of discs and polygons",
           Range::between(0, 1e6));
}

CoveragePlan read_coverage_plan(const IniFile& ini, const std::vector<std::string>& families) {
  PlanReader reader(ini);
  CoveragePlan plan{reader.options(), {}, families, ini};
  plan.axes = reader.axes(plan.options);
  if (families.empty())
    throw usage_error(ini.where("scenarios", "generator"), "specifies no generator",
                      "one or more of " + join(generator_names(), ", "));
  return plan;
}

}  // namespace slalom
