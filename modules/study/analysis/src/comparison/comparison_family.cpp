// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/paired_comparison.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <functional>

namespace slalom {
namespace {

constexpr const char* kSuccess = "success";  // the primary metric

/// Leaves the comparisons for which `is_kept` holds; what they are corrected for remains.
template <typename Predicate>
void keep_only(std::vector<PairedComparison>& comparisons, Predicate is_kept) {
  comparisons.erase(std::remove_if(comparisons.begin(), comparisons.end(), std::not_fn(is_kept)),
                    comparisons.end());
}

/// The pair of names that has `method`. Throws Error (Usage) if there is none.
std::pair<std::string, std::string> pair_with(
    const std::vector<std::pair<std::string, std::string>>& pairs, const std::string& method) {
  std::vector<std::string> names;
  for (const auto& [a, b] : pairs) {
    if (a == method || b == method) return {a, b};
    names.push_back(a);
    if (b != a) names.push_back(b);
  }
  throw usage_error("method", "'" + method + "' is not in both results",
                    expected_name(method, names));
}

bool any_has_partners(const std::vector<PairedComparison>& family) {
  return std::any_of(family.begin(), family.end(),
                     [](const PairedComparison& c) { return c.has_partners(); });
}

using Pairs = std::vector<std::pair<Side, Side>>;

/// Compares without pairs if the options allow it and nothing pairs.
std::vector<PairedComparison> compare_all(const Pairs& pairs,
                                          const std::vector<std::string>& metrics,
                                          const ComparisonOptions& options) {
  const auto compare_by = [&](auto compare) {
    std::vector<PairedComparison> family;
    for (const std::string& metric : metrics)
      for (const auto& [a, b] : pairs) family.push_back(compare(a, b, metric, options));
    return family;
  };
  std::vector<PairedComparison> family = compare_by(compare_pair);
  if (options.unpaired && !any_has_partners(family)) family = compare_by(compare_unpaired);
  finish_families(family);
  return family;
}

/// Methods may have been run in different scenarios, but not all of them.
void expect_partners(const std::vector<PairedComparison>& family) {
  if (any_has_partners(family) || family.front().is_unpaired) return;
  throw usage_error(family.front().b + " against " + family.front().a,
                    "no common scenario and repetition", "results of the same scenarios");
}

}  // namespace

std::vector<PairedComparison> compare_methods(const ResultTable& table,
                                              const std::vector<std::string>& metrics,
                                              const std::string& baseline,
                                              const ComparisonOptions& options,
                                              const std::string& method) {
  for (const std::string& name : {baseline, method}) {
    if (!name.empty()) index_of_method(table, name);
  }
  if (table.methods.size() < 2) {
    throw usage_error("compare", "runs of only one method", "two methods, or two result files");
  }
  Pairs pairs;
  for (std::size_t i = 0; i < table.methods.size(); ++i) {
    for (std::size_t j = i + 1; j < table.methods.size(); ++j) {
      std::string a = table.methods[i], b = table.methods[j];
      if (!baseline.empty() && a != baseline && b != baseline) continue;
      if (b == baseline) std::swap(a, b);
      pairs.emplace_back(Side{&table, a, a}, Side{&table, b, b});
    }
  }
  std::vector<PairedComparison> family = compare_all(pairs, metrics, options);
  for (PairedComparison& comparison : family) comparison.baseline = baseline;
  if (!method.empty())
    keep_only(family, [&](const PairedComparison& c) { return c.a == method || c.b == method; });
  if (!family.empty()) expect_partners(family);
  return family;
}

std::vector<PairedComparison> directed_comparisons(const ResultTable& table,
                                                   const std::vector<Column>& columns,
                                                   const ComparisonOptions& options) {
  std::vector<std::string> metrics;
  if (find_metric(table, kSuccess) != nullptr) metrics.emplace_back(kSuccess);
  for (const Column& column : columns)
    if (column.info.direction != Direction::None && !column.wall_clock &&
        column.info.id != kSuccess)
      metrics.push_back(column.info.id);
  if (table.methods.size() < 2 || metrics.empty()) return {};
  try {
    return compare_methods(table, metrics, "", options);
  } catch (const Error&) {
    return {};  // no common scenarios
  }
}

std::vector<PairedComparison> compare_results(const ResultTable& a, const ResultTable& b,
                                              const std::vector<std::string>& metrics,
                                              const ComparisonOptions& options,
                                              const std::string& method) {
  std::vector<std::pair<std::string, std::string>> common;
  for (const std::string& name : a.methods) {
    if (contains(b.methods, name)) {
      common.emplace_back(name, name);
    }
  }
  if (common.empty() && a.methods.size() == 1 && b.methods.size() == 1) {
    common.emplace_back(a.methods[0], b.methods[0]);
  }
  if (common.empty()) {
    throw usage_error(b.source,
                      "no common method with " + a.source + " (" + join(b.methods, ", ") +
                          "; there " + join(a.methods, ", ") + ")",
                      "runs of the same methods");
  }
  const auto shown =
      method.empty() ? std::pair<std::string, std::string>() : pair_with(common, method);
  const auto name_in = [](const ResultTable& table, const std::string& name) {
    return name + " (" + table.source + ")";
  };
  Pairs pairs;
  for (const auto& [before, after] : common)
    pairs.emplace_back(Side{&a, before, name_in(a, before)}, Side{&b, after, name_in(b, after)});
  std::vector<PairedComparison> family = compare_all(pairs, metrics, options);
  if (!method.empty())
    keep_only(family, [&](const PairedComparison& c) { return c.a == name_in(a, shown.first); });
  if (!family.empty()) expect_partners(family);
  return family;
}

}  // namespace slalom
