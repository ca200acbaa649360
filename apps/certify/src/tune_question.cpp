// SPDX-License-Identifier: BSD-3-Clause
#include "figures.h"
#include "kinds.h"
#include "tune_hardest_quartile.h"
#include "tune_scenarios.h"
#include "tune_space.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/inquiry/sealed_claim.h>
#include <slalom/inquiry/tune_effects.h>
#include <slalom/inquiry/tune_equals.h>
#include <slalom/inquiry/tune_search.h>
#include <slalom/metrics/metric.h>
#include <slalom/statistics/paired_rates.h>

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace slalom {
namespace {

/// The question which options are better than the default ones.
class TuneQuestion : public Question {
 public:
  std::string kind() const override { return "tune"; }
  std::string help() const override {
    return "Search better options of a method and compare them with its defaults in scenarios that "
           "the search has not seen";
  }
  std::vector<QuestionField> fields() override;
  void prepare(IniFile&) override {}
  void check(const MethodCampaign& campaign, BlockRunner& runner) override;
  Json answer(const MethodCampaign& campaign, BlockRunner& runner) const override;
  Statement statement(const Json& answer) const override;
  std::string unmet_requirement(const Json& answer) const override;
  std::string metric() const override { return then_; }

 private:
  RunStream stream(const MethodCampaign& campaign, const std::string& phase, std::size_t index,
                   const Configuration& configuration, const SharedScenarios& scenarios) const;
  TuneOutcome outcome_of(const BlockRun& run) const;
  TuneResult search(const MethodCampaign& campaign, const TuneScenarios& sets,
                    BlockRunner& runner) const;
  Json front_json(const TuneResult& result) const;
  StatementTable front_table(const Json& answer) const;
  SealedOptions sealed_options() const;
  Json sealed_answer(const MethodCampaign& campaign, const TuneScenarios& sets,
                     const TuneResult& result, BlockRunner& runner) const;

  TuneOptions search_;
  std::size_t sealed_ = 400;
  double effect_ = 0.1;
  std::string stratify_ = "density", then_ = "time_to_goal";
  bool front_ = false, require_ = false;
  std::optional<ParameterSpace> space_;  ///< since check()
  bool less_is_better_ = true;           ///< of the metric
};

std::vector<QuestionField> TuneQuestion::fields() {
  return {
      {"method", &method, "The method whose options are tuned", true},
      {"runs", &search_.budget, "Runs of the search, with its finals"},
      {"development", &search_.development, "Scenarios of the search"},
      {"finals", &search_.finals, "Scenarios in which the best five and the default are compared"},
      {"sealed", &sealed_, "Scenarios of the claim, of which at least 200 are used; 200 to 1000"},
      {"effect", &effect_, "Difference in success for which the claim needs the fewest runs"},
      {"confidence", &search_.confidence, "Confidence of the claim"},
      {"collision_cost", &search_.collision_cost, "A collision counts as so many failures"},
      {"stratify", &stratify_,
       "Descriptor of which each part of the development scenarios has all quarters"},
      {"then", &then_, "Metric that decides among finalists that do not differ in success"},
      {"front", &front_,
       "Also the finalists that no other one beats in both success and the metric of --then"},
      {"require", &require_, "Exit status 1 unless the tuned options are shown to be better", false,
       false}};
}

SealedOptions TuneQuestion::sealed_options() const {
  SealedOptions options;
  options.effect = effect_;
  options.confidence = search_.confidence;
  options.max_scenarios = sealed_;
  return options;
}

void TuneQuestion::check(const MethodCampaign& campaign, BlockRunner&) {
  require_probability("--confidence", search_.confidence);
  if (search_.budget < kMinTuneBudget || search_.budget > 10000000)
    throw usage_error("--runs", std::to_string(search_.budget) + " is out of range",
                      std::to_string(kMinTuneBudget) + " to 10000000");
  for (const auto& [option, size] :
       {std::pair{"--development", search_.development}, {"--finals", search_.finals}})
    if (size < 100 || size > 100000)
      throw usage_error(option, std::to_string(size) + " is out of range", "100 to 100000");
  if (sealed_ < 200 || sealed_ > SealedClaim::kMaxSealed)
    throw usage_error("--sealed", std::to_string(sealed_) + " is out of range", "200 to 1000");
  SealedClaim checked(sealed_options());
  descriptor(stratify_);
  less_is_better_ = slalom::metric(then_).info.direction != Direction::Up;
  space_ = read_space(campaign);
}

RunStream TuneQuestion::stream(const MethodCampaign& campaign, const std::string& phase,
                               std::size_t index, const Configuration& configuration,
                               const SharedScenarios& scenarios) const {
  RunStream stream{"tune/" + phase + "/" + std::to_string(index),
                   phase + " of configuration " + std::to_string(index), campaign.ini};
  stream.scenarios = scenarios;
  stream.method = campaign.configure(options_of(*space_, configuration));
  return stream;
}

TuneOutcome TuneQuestion::outcome_of(const BlockRun& run) const {
  TuneOutcome outcome{run.outcome == Outcome::Success, run.outcome == Outcome::Collision, {}};
  if (run.value) outcome.secondary = less_is_better_ ? *run.value : -*run.value;
  return outcome;
}

TuneResult TuneQuestion::search(const MethodCampaign& campaign, const TuneScenarios& sets,
                                BlockRunner& runner) const {
  TuneOptions options = search_;
  options.seed = derive_seed(campaign.options.seed, "tune/search");
  std::size_t successes = 0, values = 0;
  return tune_search(*space_, options, [&](const TuneRequest& request) {
    const SharedScenarios& scenarios =
        request.phase == TunePhase::Finals ? sets.finals : sets.development;
    std::vector<TuneOutcome> outcomes;
    std::size_t number = 0;
    runner.run(stream(campaign, std::string(to_string(request.phase)), request.index,
                      request.configuration, scenarios),
               request.first + request.count, [&](const BlockRun& run) {
                 if (number++ < request.first) return true;
                 outcomes.push_back(outcome_of(run));
                 successes += outcomes.back().success ? 1 : 0;
                 values += outcomes.back().secondary ? 1 : 0;
                 return true;
               });
    constexpr std::size_t kEnough = 20;
    if (successes >= kEnough && values == 0)
      throw usage_error("--then " + then_, "is not available in runs that succeed",
                        "a metric that needs no safest path, such as optimality");
    return outcomes;
  });
}

/// A number without last bits that a mathematical library may change.
double six_digits(double value) {
  return std::round(value * 1e6) / 1e6;
}

Json to_json(const RateEstimate& estimate) {
  return {{"value", six_digits(estimate.value)},
          {"low", six_digits(estimate.interval.low)},
          {"high", six_digits(estimate.interval.high)}};
}

Json to_json(const TuneCounts& counts) {
  return {
      {"runs", counts.runs}, {"successes", counts.successes}, {"collisions", counts.collisions}};
}

Json to_json(const std::map<std::string, std::string>& options) {
  Json json = Json::object();
  for (const auto& [key, value] : options) json[key] = value;
  return json;
}

/// Whether the first outcomes have more collisions, by McNemar's test of pairs.
bool shows_more_collisions(const std::vector<TuneOutcome>& tuned,
                           const std::vector<TuneOutcome>& standard) {
  constexpr double kLevel = 0.05;
  std::size_t only_tuned = 0, only_standard = 0;
  for (std::size_t i = 0; i < tuned.size(); ++i) {
    only_tuned += tuned[i].collision && !standard[i].collision ? 1 : 0;
    only_standard += standard[i].collision && !tuned[i].collision ? 1 : 0;
  }
  return only_tuned > only_standard && mcnemar_exact(only_tuned, only_standard) <= kLevel;
}

RateEstimate collision_rate(const std::vector<TuneOutcome>& outcomes,
                            const SealedOptions& options) {
  std::vector<double> collisions;
  for (const TuneOutcome& outcome : outcomes) collisions.push_back(outcome.collision ? 1 : 0);
  return betting_estimate(collisions, 0, options.effect, options.confidence);
}

/// Success of the default and the winner in those of the sealed scenarios that are at the hard end
/// of a descriptor.
Json hardest_quartile_json(const HardestQuartile& end, const std::vector<TuneOutcome>& tuned,
                           const std::vector<TuneOutcome>& standard, const SealedOptions& options) {
  Json json = {{"condition", end.condition}};
  for (const auto& [side, all] : {std::pair("default", &standard), {"tuned", &tuned}}) {
    std::vector<TuneOutcome> outcomes;
    std::vector<double> successes;
    for (std::size_t i = 0; i < all->size(); ++i)
      if (end.contains[i]) {
        outcomes.push_back((*all)[i]);
        successes.push_back(outcomes.back().success ? 1 : 0);
      }
    if (successes.empty()) return {};
    json[side] = to_json(betting_estimate(successes, 0, options.effect, options.confidence));
    json[side + std::string("_counts")] = to_json(counts_of(outcomes));
  }
  return json;
}

/// The winner against the default in the sealed scenarios, in pairs.
Json TuneQuestion::sealed_answer(const MethodCampaign& campaign, const TuneScenarios& sets,
                                 const TuneResult& result, BlockRunner& runner) const {
  const Configuration& tuned = result.candidates[result.winner].configuration;
  const RunStream streams[] = {stream(campaign, "sealed", result.winner, tuned, sets.sealed),
                               stream(campaign, "sealed", 0, space_->defaults(), sets.sealed)};
  SealedClaim claim(sealed_options());
  std::vector<TuneOutcome> outcomes[2];
  while (const std::size_t more = claim.next()) {
    const std::size_t first = claim.scenarios();
    for (int side = 0; side < 2; ++side) {
      outcomes[side].clear();
      runner.run(streams[side], first + more, [&](const BlockRun& run) {
        outcomes[side].push_back(outcome_of(run));
        return true;
      });
    }
    for (std::size_t i = first; i < first + more; ++i)
      claim.add(outcomes[0][i].success, outcomes[1][i].success);
  }
  const auto values = [&](const SharedScenarios& scenarios) {
    return descriptor_values(*scenarios, campaign, stratify_);
  };
  const auto end = hardest_quartile(stratify_, values(sets.sealed), values(sets.finals),
                                    result.candidates[0].finals);
  return {
      {"verdict", claim.verdict() == TuneVerdict::Better ? "better" : "not shown"},
      {"scenarios", claim.scenarios()},
      {"tuned", to_json(claim.tuned())},
      {"default", to_json(claim.reference())},
      {"tuned_counts", to_json(counts_of(outcomes[0]))},
      {"default_counts", to_json(counts_of(outcomes[1]))},
      {"hard_end",
       end ? hardest_quartile_json(*end, outcomes[0], outcomes[1], sealed_options()) : Json()},
      {"more_collisions", shows_more_collisions(outcomes[0], outcomes[1])},
      {"tuned_collisions", to_json(collision_rate(outcomes[0], sealed_options()))},
      {"difference", to_json(claim.difference())},
      {"optimism", to_json(claim.optimism(counts_of(result.candidates[result.winner].finals)))}};
}

Json effects_json(const ParameterSpace& space, const TuneResult& result, double confidence) {
  Json effects = Json::array();
  for (const ParameterEffect& effect : main_effects(space, result, confidence)) {
    Json levels = Json::array();
    for (const ParameterLevel& level : effect.levels)
      levels.push_back({{"values", level.text},
                        {"configurations", level.configurations},
                        {"success", to_json(RateEstimate{level.rate, level.interval})}});
    effects.push_back({{"option", space.parameters()[effect.parameter].name}, {"levels", levels}});
  }
  return effects;
}

/// The values of the options among the configurations that cannot be told from the winner.
Json equals_json(const ParameterSpace& space, const TuneResult& result, double confidence) {
  const TiedConfigurations equals = statistically_tied(result, confidence);
  Json options = Json::object();
  for (std::size_t i = 0; i < space.size(); ++i) {
    std::set<double> values;
    for (const std::size_t candidate : equals.candidates)
      if (const Configuration& one = result.candidates[candidate].configuration;
          space.active(one, i))
        values.insert(one[i]);
    const SpaceParameter& parameter = space.parameters()[i];
    if (values.empty()) continue;
    Json& option = options[parameter.name];
    if (parameter.choices.empty()) {
      option = {{"low", space.text(i, *values.begin())}, {"high", space.text(i, *values.rbegin())}};
      continue;
    }
    for (const double value : values) option["choices"].push_back(space.text(i, value));
  }
  return {
      {"compared", equals.compared}, {"equal", equals.candidates.size() - 1}, {"options", options}};
}

/// The ids of the sealed scenarios that the claim has used.
Json ids_of(const std::vector<Scenario>& scenarios, const Json& sealed) {
  constexpr std::size_t kDigits = 12;
  Json ids = Json::array();
  for (std::size_t i = 0; i < sealed.at("scenarios").get<std::size_t>(); ++i)
    ids.push_back(scenarios.at(i).hash().substr(0, kDigits));
  return ids;
}

Json TuneQuestion::front_json(const TuneResult& result) const {
  Json front = Json::array();
  for (const FrontPoint& point : pareto_front(result)) {
    const TuneCandidate& one = result.candidates[point.candidate];
    const double difference = less_is_better_ ? point.minus_winner : 0 - point.minus_winner;
    front.push_back({{"configuration", point.candidate},
                     {"finals", to_json(counts_of(one.finals))},
                     {"minus_winner", six_digits(difference)},
                     {"common_successes", point.common},
                     {"options", to_json(options_of(*space_, one.configuration))}});
  }
  return front;
}

Json TuneQuestion::answer(const MethodCampaign& campaign, BlockRunner& runner) const {
  const TuneScenarios sets = make_tune_scenarios(
      campaign, {search_.development, search_.finals, sealed_, stratify_, runner.workers()});
  const TuneResult result = search(campaign, sets, runner);
  const TuneCandidate &winner = result.candidates.at(result.winner),
                      &standard = result.candidates.at(0);
  const Json sealed =
      result.keeps_default() ? Json() : sealed_answer(campaign, sets, result, runner);
  const bool better = !sealed.is_null() && sealed.at("verdict") == "better";
  const bool recommended = better && !sealed.at("more_collisions").get<bool>();
  Json answer = {
      {"verdict", better ? "better" : "not shown"},
      {"default", to_json(options_of(*space_, standard.configuration))},
      {"winner", to_json(options_of(*space_, winner.configuration))},
      {"keeps_default", result.keeps_default()},
      {"recommendation",
       to_json(options_of(*space_, recommended ? winner.configuration : standard.configuration))},
      {"configurations", result.candidates.size()},
      {"search_runs", result.runs(TunePhase::Development) + result.runs(TunePhase::Finals)},
      {"development",
       {{"winner", to_json(counts_of(winner.development))},
        {"default", to_json(counts_of(standard.development))}}},
      {"finals",
       {{"winner", to_json(counts_of(winner.finals))},
        {"default", to_json(counts_of(standard.finals))}}},
      {"not_told_apart", equals_json(*space_, result, search_.confidence)},
      {"sealed", sealed},
      {"sealed_scenarios", sealed.is_null() ? Json::array() : ids_of(*sets.sealed, sealed)},
      {"effects", effects_json(*space_, result, search_.confidence)},
      {"resolution", campaign.options.simulation.resolution},
      {"seed", campaign.options.seed},
      {"outcomes", runner.hash_all("tune/")}};
  if (front_) answer["front"] = front_json(result);
  return answer;
}

std::string TuneQuestion::unmet_requirement(const Json& answer) const {
  const bool better = answer.at("verdict") == "better";
  if (!require_ || (better && answer.at("recommendation") == answer.at("winner"))) return "";
  return std::string("--require: the tuned options ") +
         (better ? "have more collisions" : "are not shown to be better") +
         "; expected a recommendation of them";
}

std::string two_digits(const Json& number) {
  const std::string text = fmt::format("{:.2f}", number.get<double>());
  return text == "-0.00" ? "0.00" : text;
}

/// Rounded up: a bound.
std::string at_most_text(double bound) {
  return fmt::format("{:.3f}", std::ceil(bound * 1000) / 1000);
}

std::string estimate_text(const Json& estimate) {
  return two_digits(estimate.at("value")) + " [" + two_digits(estimate.at("low")) + ", " +
         two_digits(estimate.at("high")) + "]";
}

std::string counts_text(const Json& counts) {
  const auto runs = counts.at("runs").get<std::size_t>();
  return runs == 0 ? "-" : rate_text(runs, counts.at("successes").get<std::size_t>());
}

std::string collisions_text(const Json& counts) {
  return std::to_string(counts.at("collisions").get<std::size_t>()) + " of " +
         std::to_string(counts.at("runs").get<std::size_t>());
}

/// "0.05 to 0.22", "fast, safe", or "-".
std::string equals_text(const Json& options, const std::string& option) {
  if (!options.contains(option)) return "-";
  const Json& values = options.at(option);
  if (values.contains("choices"))
    return join(values.at("choices").get<std::vector<std::string>>(), ", ");
  const auto low = values.at("low").get<std::string>(), high = values.at("high").get<std::string>();
  return low == high ? low : low + " to " + high;
}

StatementTable options_table(const Json& answer) {
  StatementTable table{"", "lrrr", {"option", "default", "winner", "not told apart"}, {}};
  for (const auto& [option, value] : answer.at("default").items())
    table.rows.push_back({option, value.get<std::string>(),
                          answer.at("winner").at(option).get<std::string>(),
                          equals_text(answer.at("not_told_apart").at("options"), option)});
  return table;
}

StatementTable results_table(const Json& answer) {
  StatementTable table{"success, and collisions",
                       "lrrrr",
                       {"scenarios", "default", "winner", "collisions: default", "winner"},
                       {}};
  const Json& finals = answer.at("finals");
  table.rows.push_back({"finals", counts_text(finals.at("default")),
                        counts_text(finals.at("winner")), collisions_text(finals.at("default")),
                        collisions_text(finals.at("winner"))});
  const auto add = [&table](const std::string& scenarios, const Json& pair) {
    table.rows.push_back(
        {scenarios, estimate_text(pair.at("default")), estimate_text(pair.at("tuned")),
         collisions_text(pair.at("default_counts")), collisions_text(pair.at("tuned_counts"))});
  };
  const Json& sealed = answer.at("sealed");
  if (sealed.is_null()) return table;
  add("sealed", sealed);
  if (const Json& hard = sealed.at("hard_end"); !hard.is_null())
    add("of these " + hard.at("condition").get<std::string>(), hard);
  return table;
}

StatementTable effects_table(const Json& answer) {
  StatementTable table{"main effects: mean success of evenly spread configurations",
                       "llr",
                       {"option", "values", "success"},
                       {}};
  for (const Json& effect : answer.at("effects"))
    for (const Json& level : effect.at("levels"))
      table.rows.push_back({effect.at("option").get<std::string>(),
                            level.at("values").get<std::string>(),
                            estimate_text(level.at("success"))});
  return table;
}

/// The configurations are columns: there are at most six, but any number of options.
StatementTable TuneQuestion::front_table(const Json& answer) const {
  StatementTable table{"front: finalists that no other one beats in both success and " + then_,
                       "l",
                       {"configuration"},
                       {{"success"}, {then_ + " - winner's"}, {"in"}, {"collisions"}}};
  for (const auto& [option, unused] : answer.at("default").items()) table.rows.push_back({option});
  for (const Json& one : answer.at("front")) {
    const Json &options = one.at("options"), &finals = one.at("finals");
    std::vector<std::string> column = {counts_text(finals), two_digits(one.at("minus_winner")),
                                       one.at("common_successes").dump(), collisions_text(finals)};
    for (const auto& [option, value] : options.items()) column.push_back(value);
    table.alignment += 'r';
    table.header.push_back(options == answer.at("winner")    ? "winner"
                           : options == answer.at("default") ? "default"
                                                             : one.at("configuration").dump());
    for (std::size_t i = 0; i < column.size(); ++i) table.rows[i].push_back(column[i]);
  }
  return table;
}

Statement TuneQuestion::statement(const Json& answer) const {
  Statement statement;
  statement.title = "tuning of " + method + ", confidence " + format_number(search_.confidence);
  statement.parts.emplace_back(fmt::format("{} configurations in {} runs",
                                           answer.at("configurations").get<std::size_t>(),
                                           answer.at("search_runs").get<std::size_t>()));
  statement.parts.emplace_back(options_table(answer));
  const Json& equals = answer.at("not_told_apart");
  statement.parts.emplace_back(
      fmt::format("success is not shown to differ from the winner's in {} of {} configurations of "
                  "the finals and the last rung",
                  equals.at("equal").get<std::size_t>(), equals.at("compared").get<std::size_t>()));
  statement.parts.emplace_back(results_table(answer));
  const Json& sealed = answer.at("sealed");
  if (sealed.is_null()) {
    statement.parts.emplace_back("claim: none, the default is the best of the finals: keep it");
  } else {
    const std::string difference = estimate_text(sealed.at("difference"));
    const auto scenarios = sealed.at("scenarios").get<std::size_t>();
    const bool better = answer.at("verdict") == "better";
    statement.parts.emplace_back(
        better ? fmt::format("claim: better, by {} in {} sealed scenarios", difference, scenarios)
               : fmt::format(
                     "claim: not shown in {} sealed scenarios, difference {}: keep the default",
                     scenarios, difference));
    if (better && sealed.at("more_collisions").get<bool>())
      statement.parts.emplace_back(
          "but with more collisions: the default is recommended, unless they do not matter");
    if (better)
      statement.parts.emplace_back("collisions of the winner: at most " +
                                   at_most_text(sealed.at("tuned_collisions").at("high")) +
                                   " of the runs");
    statement.parts.emplace_back(tune_figure(sealed));
    statement.parts.emplace_back("optimism of the finals: " + estimate_text(sealed.at("optimism")));
  }
  if (answer.contains("front")) statement.parts.emplace_back(front_table(answer));
  statement.parts.emplace_back(effects_table(answer));
  return statement;
}

}  // namespace

std::unique_ptr<Question> make_tune_question() {
  return std::make_unique<TuneQuestion>();
}

}  // namespace slalom
