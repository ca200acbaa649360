// SPDX-License-Identifier: BSD-3-Clause
#include "figures.h"
#include "kinds.h"

#include <slalom/app/parameter_field.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <fmt/format.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr std::size_t kListedFailures = 6;  ///< in full

/// The question up to which value of a parameter the method is reliable.
class LimitQuestion : public Question {
 public:
  std::string kind() const override { return "limit"; }
  std::string help() const override {
    return "Find the hardest values of a parameter up to which the method succeeds with a "
           "reliability";
  }
  std::vector<QuestionField> fields() override;
  void prepare(IniFile& ini) override;
  void check(const MethodCampaign& campaign, BlockRunner& runner) override;
  Json answer(const MethodCampaign& campaign, BlockRunner& runner) const override;
  Statement statement(const Json& answer) const override;
  std::string unmet_requirement(const Json& answer) const override;
  std::string remark(const Json& answer, const BlockRunner& runner) const override;

 private:
  RunStream stream(const IniFile& ini, LimitPhase phase, const BinRange& bins) const;
  Json claim_at(double reliability, const IniFile& ini, BlockRunner& runner) const;
  Json failures_of(const Json& claims, const IniFile& ini, BlockRunner& runner) const;
  bool covers(const Json& limit, double value) const;
  void add_claim(const Json& claim, const Json& answer, Statement& statement) const;

  ParameterField parameter_;
  std::vector<double> reliability_ = {0.95};
  double confidence_ = 0.95;
  std::size_t blocks_ = 6, budget_ = 5000, max_per_step_ = 2000;
  std::optional<double> require_;
};

std::vector<QuestionField> LimitQuestion::fields() {
  return {{"method", &method, "The method that is tested", true},
          {"of", &parameter_.of,
           "The parameter: FAMILY.OPTION of a generator, such as passage.width for min_width and "
           "max_width; robot.KEY or sensor.KEY, in the scenarios of the .ini",
           true},
          {"from", &parameter_.from, "The easy end; default: as the .ini or the family has it"},
          {"to", &parameter_.to, "The hard end"},
          {"step", &parameter_.step,
           "Width of a bin, in which each run draws its value; of an integer, the values in a bin, "
           "without that of --to; default: a tenth of the range, at least two cells"},
          {"reliability", &reliability_, "Rate of success to show; of several, each by itself"},
          {"confidence", &confidence_,
           "Confidence of a claim: 1 minus the probability that it is wrong"},
          {"blocks", &blocks_,
           "Blocks of bins before the limit of the pilot; 0: each bin is claimed by itself"},
          {"budget", &budget_, "Runs for a claim"},
          {"max_per_step", &max_per_step_, "Runs for one block or bin of a claim"},
          {"require", &require_, "Exit status 1 unless the claims reach this value", false, false}};
}

void LimitQuestion::prepare(IniFile& ini) {
  parameter_.prepare(ini);
}

void LimitQuestion::check(const MethodCampaign& campaign, BlockRunner& runner) {
  if (reliability_.empty())
    throw usage_error("--reliability", "no value", "a rate of success, such as 0.95");
  require_probability("--confidence", confidence_);
  for (const double rate : reliability_) {
    require_probability("--reliability", rate);
    require_runs(rate, confidence_, "--budget", budget_);
    require_runs(rate, confidence_, "--max-per-step", max_per_step_);
  }
  if (blocks_ > kMaxBins)
    throw usage_error("--blocks " + std::to_string(blocks_), "is too large", "at most 10000");
  parameter_.resolve(campaign, runner);
  const Bins& bins = parameter_.bins;
  const auto [low, high] = std::minmax({bins.from, bins.to});
  if (require_ && !(*require_ >= low && *require_ <= high))
    throw usage_error("--require " + format_number(*require_), "is not between --from and --to",
                      "a value of " + parameter_.of);
  runner.check(stream(campaign.ini, LimitPhase::Claim, {0, bins.count()}));
}

RunStream LimitQuestion::stream(const IniFile& ini, LimitPhase phase, const BinRange& bins) const {
  const std::string name(to_string(phase));
  return {"limit/" + name + "/" + std::to_string(bins.first) + "-" + std::to_string(bins.end),
          name + " in " + parameter_.bins.text(bins),
          ini,
          {parameter_.in(bins)}};
}

Json to_json(const std::vector<BinRuns>& phase, const Bins& bins, bool claim) {
  Json rows = Json::array();
  for (const BinRuns& runs : phase) {
    Json row = {{"from", bins.edge(runs.bins.first)},
                {"to", bins.hardest(runs.bins)},
                {"runs", runs.runs},
                {"failures", runs.failures}};
    if (claim) row["claimed"] = runs.reached;
    rows.push_back(std::move(row));
  }
  return rows;
}

/// "success >= 0.95 in each of [1.2, 1.1] m, [1.1, 1] m".
std::string claim_text(double reliability, double confidence, const LimitResult& result,
                       const Bins& bins) {
  const std::string rate = format_number(reliability);
  std::vector<std::string> claimed;
  for (const BinRuns& step : result.steps)
    if (step.reached) claimed.push_back(bins.text(step.bins));
  if (!claimed.empty())
    return "success >= " + rate + (claimed.size() > 1 ? " in each of " : " in ") +
           join(claimed, ", ");
  const std::vector<BinRuns>& seen = result.curve;
  const auto best =
      std::max_element(seen.begin(), seen.end(),
                       [](const BinRuns& a, const BinRuns& b) { return a.rate() < b.rate(); });
  // The interval of a bin that was chosen holds for all bins together (Bonferroni).
  const double of_each = 1 - (1 - confidence) / static_cast<double>(seen.size());
  return "nothing can be claimed at " + rate + ": best seen " +
         rate_text(best->runs, best->runs - best->failures, of_each) + " in " +
         bins.text(best->bins);
}

Json LimitQuestion::claim_at(double reliability, const IniFile& ini, BlockRunner& runner) const {
  const Bins& bins = parameter_.bins;
  const RunBins run = [&](LimitPhase phase, const BinRange& range, std::size_t max_runs,
                          const std::function<bool(bool)>& receive) {
    runner.run(stream(ini, phase, range), max_runs,
               [&](const BlockRun& one) { return receive(one.outcome == Outcome::Success); });
    return true;
  };
  const LimitResult result =
      find_limit({bins.count(), reliability, confidence_, blocks_, max_per_step_, budget_}, run);
  if (result.exchanged)
    throw usage_error("--from " + format_number(bins.from) + " --to " + format_number(bins.to),
                      "the method succeeds at " + bins.value_text(bins.to) + ", not at " +
                          bins.value_text(bins.from),
                      "the easy end first");
  const std::size_t claimed = result.claimed();
  return {{"reliability", reliability},
          {"claim", claim_text(reliability, confidence_, result, bins)},
          {"limit", claimed == 0 ? Json() : Json(bins.hardest(result.steps[claimed - 1].bins))},
          {"pilot", to_json(result.pilot, bins, false)},
          {"steps", to_json(result.steps, bins, true)},
          {"curve", to_json(result.curve, bins, false)}};
}

/// The first failures beyond the limits.
Json LimitQuestion::failures_of(const Json& claims, const IniFile& ini, BlockRunner& runner) const {
  const Bins& bins = parameter_.bins;
  Json failures = Json::array();
  for (const Json& curve : last_of(claims).at("curve")) {
    std::size_t bin = 0;
    while (bins.edge(bin) != curve.at("from").get<double>()) ++bin;
    const RunStream runs = stream(ini, LimitPhase::Curve, {bin, bin + 1});
    runner.run(runs, curve.at("runs").get<std::size_t>(), [&](const BlockRun& one) {
      if (one.outcome != Outcome::Success) failures.push_back(failure_json(runner, runs, one));
      return failures.size() < kListedFailures;
    });
    if (failures.size() >= kListedFailures) break;
  }
  return failures;
}

Json LimitQuestion::answer(const MethodCampaign& campaign, BlockRunner& runner) const {
  Json claims = Json::array();
  for (const double reliability : reliability_)
    claims.push_back(claim_at(reliability, campaign.ini, runner));
  return {{"claims", claims},
          {"unit", parameter_.bins.unit},
          {"resolution", campaign.options.simulation.resolution},
          {"seed", campaign.options.seed},
          {"outcomes", runner.hash_all("limit/")},
          {"failures", failures_of(claims, campaign.ini, runner)}};
}

bool LimitQuestion::covers(const Json& limit, double value) const {
  if (limit.is_null()) return false;
  const double reached = limit.get<double>();
  return *parameter_.to > *parameter_.from ? reached >= value : reached <= value;
}

std::string LimitQuestion::unmet_requirement(const Json& answer) const {
  if (!require_) return "";
  for (const Json& claim : answer.at("claims")) {
    const Json& limit = claim.at("limit");
    if (covers(limit, *require_)) continue;
    return "--require " + parameter_.bins.value_text(*require_) + ": " +
           (limit.is_null() ? "nothing can be claimed"
                            : "the limit is " + parameter_.bins.value_text(limit)) +
           "; expected a claim up to that value";
  }
  return "";
}

/// Compares the limit of a delay with the time of a cycle.
std::string LimitQuestion::remark(const Json& answer, const BlockRunner& runner) const {
  const Json& limit = last_of(answer.at("claims")).at("limit");
  if (parameter_.of != "robot.delay" || limit.is_null() || !runner.cycle_time()) return "";
  const double cycle = *runner.cycle_time() / 1000;
  if (!(cycle > 0)) return "";
  return fmt::format(
      "not part of the claim: a control cycle took at most {:.3g} ms here in 99 % of the cycles of "
      "each run; a computer {:.3g} times as slow stays within the delay of {} s\n",
      cycle * 1000, limit.get<double>() / cycle, format_number(limit));
}

/// Why a step was the last one.
std::string end_text(const Json& step, const Json& steps, std::size_t max_per_step,
                     std::size_t budget) {
  if (step.at("claimed").get<bool>()) return "claimed";
  std::size_t runs = 0;
  for (const Json& other : steps) runs += other.at("runs").get<std::size_t>();
  if (step.at("runs").get<std::size_t>() >= max_per_step) return "undecided after --max-per-step";
  if (runs >= budget) return "undecided at the end of --budget";
  return "not claimed";
}

StatementTable make_table(const std::string& caption, const std::string& last) {
  StatementTable table{caption, "lrrl", {"values", "runs", "failures", last}, {}, false};
  return table;
}

void add_row(StatementTable& table, const Json& row, const std::string& unit,
             const std::string& end) {
  table.rows.push_back({range_text(row, unit), count_text(row.at("runs").get<std::size_t>(), "run"),
                        count_text(row.at("failures").get<std::size_t>(), "failure"), end});
}

std::size_t runs_of(const Json& rows) {
  std::size_t runs = 0;
  for (const Json& row : rows) runs += row.at("runs").get<std::size_t>();
  return runs;
}

void LimitQuestion::add_claim(const Json& claim, const Json& answer, Statement& statement) const {
  const std::string unit = answer.at("unit").get<std::string>();
  const Json &steps = claim.at("steps"), &curve = claim.at("curve"), &limit = claim.at("limit");
  const std::string heading = "reliability " + format_number(claim.at("reliability"));
  StatementTable claimed = make_table(heading, "result");
  for (const Json& step : steps)
    add_row(claimed, step, unit, end_text(step, steps, max_per_step_, budget_));
  StatementTable seen = make_table("not part of the claim:", "success");
  for (const Json& bin : curve) {
    const auto runs = bin.at("runs").get<std::size_t>();
    add_row(seen, bin, unit, rate_text(runs, runs - bin.at("failures").get<std::size_t>()));
  }
  statement.parts.emplace_back(std::move(claimed));
  statement.parts.emplace_back("claim: " + claim.at("claim").get<std::string>());
  if (!limit.is_null())
    statement.parts.emplace_back("limit: " + format_number(limit) +
                                 (unit.empty() ? "" : " " + unit) + ", in cells of " +
                                 format_number(answer.at("resolution")) + " m");
  if (!seen.rows.empty()) statement.parts.emplace_back(std::move(seen));
  const std::size_t pilot = runs_of(claim.at("pilot"));
  statement.parts.emplace_back(fmt::format("{} runs, {} of them of the pilot",
                                           pilot + runs_of(steps) + runs_of(curve), pilot));
}

Statement LimitQuestion::statement(const Json& answer) const {
  Statement statement;
  statement.title = parameter_.of + " of " + method + ", confidence " + format_number(confidence_);
  for (const Json& claim : answer.at("claims")) add_claim(claim, answer, statement);
  statement.parts.emplace_back(curve_figure(parameter_.of, answer));
  return statement;
}

}  // namespace

std::unique_ptr<Question> make_limit_question() {
  return std::make_unique<LimitQuestion>();
}

}  // namespace slalom
