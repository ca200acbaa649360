// SPDX-License-Identifier: BSD-3-Clause
#include "kinds.h"
#include "shuffle.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/statistics/sequential_rate.h>

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
  std::string unmet_requirement(const Json& answer) const override;
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
  double bound_of(std::size_t runs, std::size_t hits, bool claimed) const;
  bool shows(std::size_t runs, std::size_t hits) const;
  void check_sums(const Json& answer, const CampaignOptions& options) const;
  void compare_listed(const Json& answer, std::size_t batch, const Counts& repeated) const;
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
      throw usage_error("--outcome", "unknown outcome '" + outcome + "'",
                        expected_name(outcome, known));
  if (outcomes_.empty()) throw usage_error("--outcome", "no outcome", join(known, ", "));
  require_probability("--confidence", confidence_);
  if (at_most_) require_probability("--at-most", *at_most_);
  if (at_most_ && *at_most_ < kSmallestBound)
    throw usage_error("--at-most " + format_number(*at_most_), "is less than runs can show",
                      "at least " + format_number(kSmallestBound));
  if (require_ && !at_most_) throw usage_error("--require", "nothing is to be shown", "--at-most");
  if (budget_ && !(*budget_ >= 1 && *budget_ <= 1e12))
    throw usage_error("--budget", format_number(*budget_) + " is out of range", "1 to 10^12");
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
  std::size_t runs = 0, hits = 0, redrawn = 0;
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
      counts.listed.push_back(failure_json(runner, runs, run));
    ++done;
    hits += hit ? 1 : 0;
    ++counts.outcomes[run.outcome];
    if (counts.test) counts.test->add(!hit);
    return !counts.decided();
  });
  counts.runs += done;
  counts.hits += hits;
  const std::size_t redrawn = runner.redrawn(runs);
  counts.redrawn += redrawn;
  return {{"runs", done}, {"hits", hits}, {"redrawn", redrawn}, {"hash", runner.hash(runs.name)}};
}

/// Keeps what was excluded once: the bound is not above what the test has reached.
double RiskQuestion::bound_of(std::size_t runs, std::size_t hits, bool claimed) const {
  const double bound = failure_bound(runs, hits, confidence_);
  return claimed ? std::min(bound, *at_most_) : bound;
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
  const bool claimed = counts.test && counts.test->reached();
  Json answer = {{"claim", ""},
                 {"claimed", claimed},
                 {"bound", bound_of(counts.runs, counts.hits, claimed)},
                 {"runs", counts.runs},
                 {"hits", counts.hits},
                 {"outcome_counts", outcomes},
                 {"redrawn", counts.redrawn},
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

std::string RiskQuestion::unmet_requirement(const Json& answer) const {
  if (!require_ || answer.at("claimed").get<bool>()) return "";
  return "--require: " + answer.at("claim").get<std::string>() + "; expected at most " +
         format_number(*at_most_);
}

Statement RiskQuestion::statement(const Json& answer) const {
  Statement statement;
  statement.title = "risk of " + method + ", confidence " + format_number(confidence_);
  StatementTable table{"", "lr", {"outcome", "runs"}, {}, false};
  // Another program may write the members of an object in another order.
  const Json& counts = answer.at("outcome_counts");
  for (const char* outcome : enum_names(Outcome()))
    if (const auto count = counts.find(outcome); count != counts.end())
      table.rows.push_back({outcome, std::to_string(count->get<std::size_t>())});
  statement.parts.emplace_back(std::move(table));
  statement.parts.emplace_back("claim: " + answer.at("claim").get<std::string>());
  statement.parts.emplace_back(count_text(answer.at("runs").get<std::size_t>(), "run") + ", " +
                               std::to_string(answer.at("hits").get<std::size_t>()) +
                               " with the outcome, in cells of " +
                               format_number(answer.at("resolution")) + " m");
  append_redrawn(statement, answer);
  return statement;
}

/// Whether these runs reach --at-most: the test ends with the first run that does, and its evidence
/// depends on the numbers only.
bool RiskQuestion::shows(std::size_t runs, std::size_t hits) const {
  if (!at_most_) return false;
  const RateTest test(1 - *at_most_, confidence_, close_rates_mixture());
  return test.log_wealth(runs - hits, hits) >= test.log_target();
}

/// Recomputes all that follows from the batches, so that only their runs are left to be executed.
void RiskQuestion::check_sums(const Json& answer, const CampaignOptions& options) const {
  const Json& batches = answer.at("batches");
  std::size_t runs = 0, hits = 0, redrawn = 0, counted = 0, counted_hits = 0;
  std::map<Json, std::size_t> hashes;
  std::map<std::string, std::string> by_stream;
  for (std::size_t i = 0; i < batches.size(); ++i) {
    const auto size = batches.at(i).at("runs").get<std::size_t>();
    const auto own_hits = batches.at(i).at("hits").get<std::size_t>();
    const std::string name = "batch " + std::to_string(i);
    if (size == 0 || own_hits > size || (i + 1 < batches.size() ? size != kBatch : size > kBatch))
      throw job_error(name, "differs: " + batches.at(i).dump(),
                      "batches of " + std::to_string(kBatch) + " runs, the last one of the rest");
    by_stream["risk/" + std::to_string(i)] = batches.at(i).at("hash");
    const auto [other, is_new] = hashes.emplace(batches.at(i).at("hash"), i);
    if (!is_new)
      throw job_error(name, "differs: it has the runs of batch " + std::to_string(other->second));
    runs += size;
    hits += own_hits;
    redrawn += batches.at(i).at("redrawn").get<std::size_t>();
  }
  for (const auto& [outcome, count] : answer.at("outcome_counts").items()) {
    const auto value = from_name<Outcome>(outcome);
    if (!value) throw job_error("outcome_counts", "differs: unknown outcome '" + outcome + "'");
    counted += count.get<std::size_t>();
    if (is_hit(*value)) counted_hits += count.get<std::size_t>();
  }
  if (counted != runs || counted_hits != hits)
    throw job_error("outcome_counts", "differs: " + std::to_string(counted_hits) + " of " +
                                          std::to_string(counted) + " runs with the outcome, " +
                                          std::to_string(hits) + " of " + std::to_string(runs) +
                                          " in the batches");
  Json expected = answer;
  const bool claimed = shows(runs, hits);
  expected["runs"] = runs;
  expected["hits"] = hits;
  expected["redrawn"] = redrawn;
  expected["claimed"] = claimed;
  expected["bound"] = bound_of(runs, hits, claimed);
  expected["claim"] = claim_text(expected);
  expected["resolution"] = options.simulation.resolution;
  expected["seed"] = options.seed;
  expected["outcomes"] = hash_of_streams(by_stream);
  for (const char* key :
       {"runs", "hits", "redrawn", "claimed", "bound", "claim", "resolution", "seed", "outcomes"})
    if (answer.at(key) != expected.at(key))
      throw job_error(
          key, "differs: " + expected.at(key).dump() + " instead of " + answer.at(key).dump());
  if (answer.at("failures").size() != std::min(hits, kListedHits))
    throw job_error("failures", "differs: " + std::to_string(answer.at("failures").size()) +
                                    " instead of " + std::to_string(std::min(hits, kListedHits)));
}

/// Compares the failures of a batch that an answer lists: the first ones of all batches.
void RiskQuestion::compare_listed(const Json& answer, std::size_t batch,
                                  const Counts& repeated) const {
  std::size_t place = 0;
  for (std::size_t i = 0; i < batch; ++i)
    place += answer.at("batches").at(i).at("hits").get<std::size_t>();
  for (const Json& failure : repeated.listed) {
    if (place >= kListedHits) return;
    const std::string name = "failures[" + std::to_string(place) + "]";
    const Json& stored = answer.at("failures").at(place++);
    if (nlohmann::json(failure) != nlohmann::json(stored))
      throw job_error(name, "differs: " + failure.dump() + " instead of " + stored.dump());
  }
}

std::string RiskQuestion::verify_sample(const MethodCampaign& campaign, const Json& answer,
                                        BlockRunner& runner, std::size_t size,
                                        RandomEngine& engine) const {
  check_sums(answer, campaign.options);
  const Json& batches = answer.at("batches");
  std::vector<std::size_t> order(batches.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  shuffle(order, engine);
  order.resize(std::min(size, order.size()));
  std::vector<std::string> names;
  std::map<Outcome, std::size_t> outcomes;
  for (const std::size_t batch : order) {
    const Json& stored = batches.at(batch);
    Counts counts;
    const Json repeated = run_batch(stream(campaign.ini, batch),
                                    stored.at("runs").get<std::size_t>(), runner, counts);
    names.push_back(std::to_string(batch));
    // Unordered: other programs may have written the file again.
    if (nlohmann::json(repeated) != nlohmann::json(stored))
      throw job_error("batch " + names.back(),
                      "differs: " + repeated.dump() + " instead of " + stored.dump());
    compare_listed(answer, batch, counts);
    for (const auto& [outcome, count] : counts.outcomes) outcomes[outcome] += count;
  }
  for (const auto& [outcome, count] : outcomes) {
    const auto stored = answer.at("outcome_counts").value(to_string(outcome), std::size_t{0});
    if (stored < count || (order.size() == batches.size() && stored != count))
      throw job_error("outcome_counts", "differs: " + std::to_string(count) + " " +
                                            std::string(to_string(outcome)) + " in " +
                                            std::to_string(order.size()) + " batches" + ", " +
                                            std::to_string(stored) + " in all");
  }
  return std::to_string(order.size()) + " of " + std::to_string(batches.size()) + " batches (" +
         join(names, ", ") + ")";
}

}  // namespace

std::unique_ptr<Question> make_risk_question() {
  return std::make_unique<RiskQuestion>();
}

}  // namespace slalom
