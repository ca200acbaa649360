// SPDX-License-Identifier: BSD-3-Clause
#include "row_table.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/difficulty.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <array>

namespace slalom {
namespace {

constexpr std::size_t kLeadingShown = 8;
constexpr double kLargeOutfit = 2;  ///< as Linacre (2002) for measures that are distorted

DataTable abilities_table(const DifficultyScale& scale, const std::string& only) {
  RowTable rows("abilities", "Ability of the methods (logit)");
  for (const MethodAbility& method : of_method(scale.methods, only)) {
    rows.begin_row();
    rows.add("method", Field{method.method});
    rows.add("success", std::optional(method.success));
    rows.add("ability", method.ability, method.interval);
    const auto& residuals = method.residuals;
    rows.add("infit", residuals ? std::optional(residuals->infit) : std::nullopt);
    rows.add("infit_expected", residuals ? std::optional(residuals->expected_infit) : std::nullopt);
    rows.add("outfit", residuals ? std::optional(residuals->outfit) : std::nullopt);
    rows.add("outfit_expected",
             residuals ? std::optional(residuals->expected_outfit) : std::nullopt);
    rows.add("discrimination", method.discrimination);
  }
  return rows.table();
}

std::size_t solved_by(const DifficultyScale& scale, std::size_t number) {
  return static_cast<std::size_t>(std::count_if(
      scale.scenarios.begin(), scale.scenarios.end(),
      [number](const ScenarioDifficulty& scenario) { return scenario.solved_by == number; }));
}

bool is_negative(const std::optional<double>& discrimination) {
  return discrimination && *discrimination < 0;
}

std::size_t negative_scenarios(const DifficultyScale& scale) {
  return static_cast<std::size_t>(std::count_if(
      scale.scenarios.begin(), scale.scenarios.end(),
      [](const ScenarioDifficulty& scenario) { return is_negative(scenario.discrimination); }));
}

/// Whether two groups of methods find different scenarios hard.
bool are_groups_shown(const DifficultyScale& scale) {
  return scale.dimensions && scale.dimensions->split_p <= test_level(scale.confidence);
}

/// "a, c against b, d"; requires a test of the dimensions.
std::string groups_text(const DifficultyScale& scale) {
  std::array<std::vector<std::string>, 2> groups;
  for (std::size_t i = 0; i < scale.compared.size(); ++i)
    groups[scale.dimensions->second_group[i] ? 1 : 0].push_back(scale.compared[i]);
  return join(groups[0], ", ") + " against " + join(groups[1], ", ");
}

DataTable fit_table(const DifficultyScale& scale) {
  RowTable rows("fit", "Fit of the model");
  rows.begin_row();
  rows.add("scenarios", scale.scenarios.size());
  rows.add("left_out", scale.left_out);
  rows.add("informative", scale.informative);
  rows.add("solved_by_none", solved_by(scale, 0));
  rows.add("solved_by_all", solved_by(scale, scale.by_solvers.size() - 1));
  rows.add("negative_scenarios", negative_scenarios(scale));
  const auto& dimensions = scale.dimensions;
  rows.add("eigenvalue", dimensions ? std::optional(dimensions->eigenvalue) : std::nullopt);
  rows.add("eigenvalue_p", dimensions ? std::optional(dimensions->eigenvalue_p) : std::nullopt);
  rows.add("split", dimensions ? std::optional(dimensions->split) : std::nullopt);
  rows.add("split_p", dimensions ? std::optional(dimensions->split_p) : std::nullopt);
  rows.add("groups", are_groups_shown(scale) ? Field{groups_text(scale)} : Field{});
  const auto& test = scale.andersen;
  rows.add("andersen", test ? std::optional(test->statistic) : std::nullopt);
  rows.add("andersen_degrees", test ? Field{static_cast<std::int64_t>(test->degrees)} : Field{});
  rows.add("andersen_p", test ? std::optional(test->p) : std::nullopt);
  return rows.table();
}

DataTable solvers_table(const DifficultyScale& scale) {
  RowTable rows("difficulty_by_solvers",
                "Difficulty of a scenario (logit) by the number of methods that solve it");
  for (std::size_t number = scale.by_solvers.size(); number-- > 0;) {
    rows.begin_row();
    rows.add("solved_by", number);
    rows.add("scenarios", solved_by(scale, number));
    rows.add("difficulty", std::optional(scale.by_solvers[number]));
  }
  return rows.table();
}

DataTable geometry_table(const GeometryFit& fit) {
  RowTable rows("geometry", "Difficulty predicted without a run, R² by cross-validation");
  const auto add = [&rows](const std::string& from, const std::string& folds,
                           const std::optional<double>& r2) {
    rows.begin_row();
    rows.add("from", Field{from});
    rows.add("folds", Field{folds});
    rows.add("r2", r2);
  };
  add("descriptors", "10 at random", fit.descriptors_r2);
  add("descriptors", "families", fit.held_out_r2);
  add("family", "10 at random", fit.family_r2);
  return rows.table();
}

DataTable leading_table(const GeometryFit& fit, std::size_t shown) {
  RowTable rows("leading", "Difficulty predicted by one descriptor, R² by cross-validation");
  for (std::size_t i = 0; i < std::min(shown, fit.leading.size()); ++i) {
    rows.begin_row();
    rows.add("descriptor", Field{fit.leading[i].first});
    rows.add("r2", std::optional(fit.leading[i].second));
  }
  return rows.table();
}

DataTable scenario_difficulty_table(const DifficultyScale& scale, const ResultTable& table) {
  RowTable rows("scenarios", "Difficulty of the scenarios (logit)");
  for (const ScenarioDifficulty& scenario : scale.scenarios) {
    rows.begin_row();
    rows.add("scenario", Field{table.scenario_names[scenario.scenario]});
    rows.add("scenario_hash", Field{table.scenario_hashes[scenario.scenario]});
    rows.add("solved_by", scenario.solved_by);
    rows.add("difficulty", std::optional(scenario.difficulty));
    rows.add("predicted_difficulty", scenario.predicted);
    rows.add("discrimination", scenario.discrimination);
  }
  return rows.table();
}

std::string scale_text(const DifficultyScale& scale) {
  if (!scale.dimensions) {
    return "one dimension of difficulty is not tested: NA, that takes at least " +
           std::to_string(kMinMethodsOfDimensionTest) + " methods with an ability";
  }
  const std::string p = " (" + p_text(scale.dimensions->eigenvalue_p) + ")";
  if (scale.dimensions->eigenvalue_p > test_level(scale.confidence)) {
    return "one scale is not refuted by a test that compares how often methods solve the same "
           "scenarios with what the scale says" +
           p;
  }
  return "one scale does not fit: some methods solve the same scenarios more often than the scale "
         "says" +
         p + "; read it as a description";
}

std::string groups_remark(const DifficultyScale& scale) {
  const std::string p = " (" + p_text(scale.dimensions->split_p) + ")";
  if (are_groups_shown(scale))
    return "two groups of methods find different scenarios hard" + p + ": " + groups_text(scale);
  return "one dimension of difficulty is not refuted by a test that looks for two groups of "
         "methods that find different scenarios hard" +
         p;
}

std::string andersen_text(const DifficultyScale& scale) {
  if (!scale.andersen)
    return "whether abilities differ between easy and hard scenarios cannot be tested with these "
           "runs";
  const std::string test = " between easy and hard scenarios (Andersen, " +
                           count_text(scale.andersen->methods.size(), "method") + ", " +
                           p_text(scale.andersen->p) + ")";
  return (scale.andersen->p > test_level(scale.confidence) ? "abilities are not shown to differ"
                                                           : "abilities differ") +
         test;
}

/// "PREFIX: a, b" if any method is `chosen`.
template <typename Chosen>
void add_names(std::vector<std::string>& remarks, const std::vector<MethodAbility>& methods,
               const std::string& prefix, const Chosen& chosen) {
  std::vector<std::string> names;
  for (const MethodAbility& method : methods)
    if (chosen(method)) names.push_back(method.method);
  if (!names.empty()) remarks.push_back(prefix + ": " + join(names, ", "));
}

void add_remarks(std::vector<std::string>& remarks, const DifficultyScale& scale,
                 const std::vector<MethodAbility>& methods) {
  remarks.push_back(
      std::to_string(scale.informative) + " of " + count_text(scale.scenarios.size(), "scenario") +
      " tell the methods apart; " + std::to_string(solved_by(scale, 0)) + " are solved by none, " +
      std::to_string(solved_by(scale, scale.by_solvers.size() - 1)) + " by all of them");
  if (scale.left_out > 0) {
    remarks.push_back("left out: " + count_text(scale.left_out, "scenario") +
                      " in which not every method has a value");
  }
  remarks.push_back(scale_text(scale));
  if (scale.dimensions) remarks.push_back(groups_remark(scale));
  remarks.push_back(andersen_text(scale));
  add_names(remarks, methods, "no finite ability, set aside",
            [](const MethodAbility& method) { return !method.ability; });
  add_names(remarks, methods, "less predictable than the scale says, outfit above 2",
            [](const MethodAbility& method) {
              return method.residuals && method.residuals->outfit > kLargeOutfit;
            });
  add_names(remarks, methods, "negative discrimination, better in hard scenarios than in easy ones",
            [](const MethodAbility& method) { return is_negative(method.discrimination); });
  const std::size_t negative = negative_scenarios(scale);
  if (negative == 0) return;
  remarks.push_back(count_text(negative, "scenario") +
                    " solved rather by weak methods than by strong ones");
}

void add_geometry(Interpretation& found, const DifficultyScale& scale) {
  if (!scale.geometry) {
    found.remarks.push_back("the difficulty is not predicted: that takes descriptors of at least " +
                            std::to_string(kMinScenariosOfGeometry) + " scenarios");
    return;
  }
  const GeometryFit& fit = *scale.geometry;
  found.tables.push_back(geometry_table(fit));
  found.tables.push_back(leading_table(fit, fit.leading.size()));
  found.views.push_back(geometry_table(fit));
  found.views.push_back(leading_table(fit, kLeadingShown));
  if (fit.without_value.empty()) return;
  found.remarks.push_back("not used, without a value in some scenario: " +
                          join(fit.without_value, ", "));
}

}  // namespace

Interpretation interpret_difficulty(const std::vector<ResultTable>& results,
                                    const AnalysisQuery& query) {
  const ResultTable& table = results[0];
  selected_methods(table, query.method);
  if (query.metrics.size() != 1) {
    throw usage_error("difficulty", count_text(query.metrics.size(), "metric"),
                      "one, such as success");
  }
  const DifficultyScale scale =
      build_difficulty(table, query.metrics[0], query.comparison.analysis);
  Interpretation found;
  found.tables = {abilities_table(scale, query.method), fit_table(scale), solvers_table(scale)};
  found.views = {abilities_table(scale, query.method), solvers_table(scale)};
  add_remarks(found.remarks, scale, of_method(scale.methods, query.method));
  add_geometry(found, scale);
  found.tables.push_back(scenario_difficulty_table(scale, table));
  return found;
}

}  // namespace slalom
