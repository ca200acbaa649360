// SPDX-License-Identifier: BSD-3-Clause
#include "kinds.h"
#include "shuffle.h"

#include <slalom/analysis/rate_test.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace slalom {
namespace {

constexpr std::size_t kBatch = 10000;  ///< runs, of which the answer stores counts and a hash
constexpr std::size_t kListedHits = 100;
constexpr double kSmallestBound = 1e-9;  ///< of which 1 minus it has seven digits
constexpr char kFailure[] = "failure";   ///< all outcomes but success

/// The question how likely an outcome is.
class RiskQuestion : public Question {
 public:
  std::string kind() const override { return "risk"; }
  std::string help() const override {
    return "Bound the probability of an outcome over the scenarios of the .ini";
  }
  std::vector<QuestionField> fields() override;
  void prepare(IniFile&) override {}
  void check(const MethodCampaign& campaign, BlockRunner& runner) override;
  Json answer(const MethodCampaign& campaign, BlockRunner& runner) const override;
  Statement statement(const Json& answer) const override;
  std::string shortfall(const Json& answer) const override;
  std::string verify_sample(const MethodCampaign& campaign, const Json& answer, BlockRunner& runner,
                            std::size_t size, RandomEngine& engine) const override;

 private:
  struct Counts;
  bool is_hit(Outcome outcome) const;
  std::size_t needed() const;
  std::size_t budget() const;
  static RunStream stream(const IniFile& ini, std::size_t batch);
  Json run_batch(const RunStream& runs, std::size_t max_runs, BlockRunner& runner,
                 Counts& counts) const;
  double bound_of(const Counts& counts) const;
  std::string claim_text(const Json& answer) const;

  std::vector<std::string> outcomes_ = {"collision"};
  std::optional<double> at_most_, budget_;
  double confidence_ = 0.95;
  bool require_ = false;
};

std::vector<QuestionField> RiskQuestion::fields() {
  return {{"method", &method, "The method that is tested", true},
          {"outcome", &outcomes_, "The outcome, or several; failure: all but success"},
          {"at_most", &at_most_, "Probability that is to be shown; default: runs up to --budget"},
          {"confidence", &confidence_,
           "Confidence of the bound: 1 minus the probability that it is wrong"},
          {"budget", &budget_,
           "Runs; default: three times those that --at-most needs at least, or 10000"},
          {"require", &require_, "Exit status 1 unless --at-most is shown", false, false}};
}

bool RiskQuestion::is_hit(Outcome outcome) const {
  return contains(outcomes_, to_string(outcome)) ||
         (outcome != Outcome::Success && contains(outcomes_, kFailure));
}

/// The runs that show --at-most without a hit.
std::size_t RiskQuestion::needed() const {
  return runs_without_failure(1 - *at_most_, confidence_, close_rates_mixture());
}

std::size_t RiskQuestion::budget() const {
  if (budget_) return static_cast<std::size_t>(*budget_);
  return at_most_ ? 3 * needed() : kBatch;
}

void RiskQuestion::check(const MethodCampaign& campaign, BlockRunner& runner) {
  std::vector<std::string> known = names_of<Outcome>();
  known.back() = kFailure;  // Errors of the machine end the command.
  for (const std::string& outcome : outcomes_)
    if (!contains(known, outcome))
      throw usage_error("--outcome " + outcome, "is no outcome", expected_name(outcome, known));
  if (outcomes_.empty()) throw usage_error("--outcome", "no outcome", join(known, ", "));
  require_probability("--confidence", confidence_);
  if (at_most_) require_probability("--at-most", *at_most_);
  if (at_most_ && *at_most_ < kSmallestBound)
    throw usage_error("--at-most " + format_number(*at_most_), "is less than runs can show",
                      "at least " + format_number(kSmallestBound));
  if (require_ && !at_most_) throw usage_error("--require", "nothing is to be shown", "--at-most");
  if (budget_ && !(*budget_ >= 1 && *budget_ <= 1e12))
    throw usage_error("--budget " + format_number(*budget_), "is no number of runs", "1 to 10^12");
  if (at_most_ && budget_) {
    if (budget() < needed())
      throw usage_error("--budget " + format_number(*budget_),
                        "at most " + format_number(*at_most_) + " at " +
                            format_number(confidence_) + " needs at least " +
                            std::to_string(needed()) + " runs without that outcome",
                        "at least " + std::to_string(needed()));
  }
  runner.check(stream(campaign.ini, 0));
}

struct RiskQuestion::Counts {
  std::optional<RateTest> test;
  std::size_t runs = 0, hits = 0;
  std::map<Outcome, std::size_t> outcomes;
  Json listed = Json::array();

  bool decided() const { return test && (test->reached() || test->futile()); }
};

RunStream RiskQuestion::stream(const IniFile& ini, std::size_t batch) {
  return {"risk/" + std::to_string(batch), "batch " + std::to_string(batch), ini};
}

Json RiskQuestion::run_batch(const RunStream& runs, std::size_t max_runs, BlockRunner& runner,
                             Counts& counts) const {
  std::size_t done = 0, hits = 0;
  runner.run(runs, max_runs, [&](const BlockRun& run) {
    const bool hit = is_hit(run.outcome);
    if (hit && counts.listed.size() < kListedHits)
      counts.listed.push_back(failure_json(runner, runs, done, run.outcome));
    ++done;
    hits += hit ? 1 : 0;
    ++counts.outcomes[run.outcome];
    if (counts.test) counts.test->add(!hit);
    return !counts.decided();
  });
  counts.runs += done;
  counts.hits += hits;
  return {{"runs", done}, {"hits", hits}, {"hash", runner.hash(runs.name)}};
}

/// Keeps what was excluded once: the bound is not above what the test has reached.
double RiskQuestion::bound_of(const Counts& counts) const {
  const double bound = failure_bound(counts.runs, counts.hits, confidence_);
  return counts.test && counts.test->reached() ? std::min(bound, *at_most_) : bound;
}

Json RiskQuestion::answer(const MethodCampaign& campaign, BlockRunner& runner) const {
  Counts counts;
  if (at_most_) counts.test.emplace(1 - *at_most_, confidence_, close_rates_mixture());
  Json batches = Json::array();
  while (counts.runs < budget() && !counts.decided())
    batches.push_back(run_batch(stream(campaign.ini, batches.size()),
                                std::min(kBatch, budget() - counts.runs), runner, counts));
  Json outcomes = Json::object();
  for (const auto& [outcome, count] : counts.outcomes) outcomes[to_string(outcome)] = count;
  Json answer = {{"claim", ""},
                 {"claimed", counts.test && counts.test->reached()},
                 {"bound", bound_of(counts)},
                 {"runs", counts.runs},
                 {"hits", counts.hits},
                 {"outcome_counts", outcomes},
                 {"resolution", campaign.options.simulation.resolution},
                 {"seed", campaign.options.seed},
                 {"batches", batches},
                 {"outcomes", runner.hash_all("risk/")},
                 {"failures", counts.listed}};
  answer["claim"] = claim_text(answer);
  return answer;
}

std::string RiskQuestion::claim_text(const Json& answer) const {
  const std::string what = "probability of " + join(outcomes_, " or ");
  const double bound = answer.at("bound").get<double>();
  // Rounded up: the text must not say less.
  double scale = 1;
  while (bound * scale < 100) scale *= 10;
  const std::string text = format_number(std::min(1.0, std::ceil(bound * scale) / scale));
  if (answer.at("claimed").get<bool>()) return what + " <= " + format_number(*at_most_);
  if (at_most_)
    return what + " <= " + format_number(*at_most_) + " is not shown; <= " + text + " is";
  return what + " <= " + text;
}

std::string RiskQuestion::shortfall(const Json& answer) const {
  if (!require_ || answer.at("claimed").get<bool>()) return "";
  return "--require: " + answer.at("claim").get<std::string>() + "; expected at most " +
         format_number(*at_most_);
}

Statement RiskQuestion::statement(const Json& answer) const {
  Statement statement;
  statement.title = "risk of " + method + ", confidence " + format_number(confidence_);
  StatementTable table{"", "lr", {"outcome", "runs"}, {}, false};
  for (const auto& [outcome, count] : answer.at("outcome_counts").items())
    table.rows.push_back({outcome, std::to_string(count.get<std::size_t>())});
  statement.parts.emplace_back(std::move(table));
  statement.parts.emplace_back("claim: " + answer.at("claim").get<std::string>());
  statement.parts.emplace_back(count_text(answer.at("runs").get<std::size_t>(), "run") + ", " +
                               std::to_string(answer.at("hits").get<std::size_t>()) +
                               " with the outcome, in cells of " +
                               format_number(answer.at("resolution")) + " m");
  return statement;
}

std::string RiskQuestion::verify_sample(const MethodCampaign& campaign, const Json& answer,
                                        BlockRunner& runner, std::size_t size,
                                        RandomEngine& engine) const {
  const Json& batches = answer.at("batches");
  std::vector<std::size_t> order(batches.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  shuffle(order, engine);
  order.resize(std::min(size, order.size()));
  std::vector<std::string> names;
  for (const std::size_t batch : order) {
    const Json& stored = batches.at(batch);
    Counts counts;
    const Json repeated = run_batch(stream(campaign.ini, batch),
                                    stored.at("runs").get<std::size_t>(), runner, counts);
    names.push_back(std::to_string(batch));
    if (repeated != stored)
      throw job_error("batch " + names.back(),
                      "differs: " + repeated.dump() + " instead of " + stored.dump());
  }
  return std::to_string(order.size()) + " of " + std::to_string(batches.size()) + " batches (" +
         join(names, ", ") + ")";
}

}  // namespace

std::unique_ptr<Question> make_risk_question() {
  return std::make_unique<RiskQuestion>();
}

}  // namespace slalom
