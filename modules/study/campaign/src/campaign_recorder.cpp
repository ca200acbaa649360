// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/campaign/campaign_recorder.h>
#include <slalom/core/error.h>

namespace slalom {
namespace {

/// In a file; what methods print after it is not kept.
constexpr std::size_t kMaxOutputs = std::size_t{64} << 20;

std::string key_of(const std::string& hash, const std::string& method, int repetition) {
  return hash + "/" + method + "/" + std::to_string(repetition);
}

}  // namespace

CampaignRecorder::CampaignRecorder(Campaign campaign, ResultFile file, RecorderOptions options)
    : campaign_(std::move(campaign)), file_(std::move(file)), recording_(std::move(options)) {
  file_.for_each_key([this](const std::string& hash, const std::string& method, int repetition,
                            const std::string& outcome) {
    known_runs_.insert(key_of(hash, method, repetition));
    ++known_by_scenario_[hash];
    if (outcome == to_string(Outcome::InfrastructureError)) ++errors_;
    count_known_run(hash, method, repetition, outcome);
  });
}

void CampaignRecorder::count_known_run(const std::string& hash, const std::string& method,
                                       int repetition, const std::string& outcome) {
  RunRecord run;
  run.method = method;
  run.outcome = outcome;
  // The text of the failure is needed only then.
  if (is_method_failure(outcome)) run = file_.read_run(hash, method, repetition).value_or(run);
  failures_.add(run);
}

bool CampaignRecorder::run(std::vector<Scenario> scenarios, const Execution& execution) {
  campaign_.scenarios = std::move(scenarios);
  // Polled continuously, even while no results arrive.
  Execution committing = execution;
  committing.interrupted = [&] {
    commit_when_due();
    return execution.is_interrupted();
  };
  const CampaignSummary summary = run_campaign(campaign_, *this, committing);
  commit_finally(execution);
  errors_ += summary.infrastructure_errors();
  return summary.complete;
}

std::string CampaignRecorder::problem() const {
  if (errors_ == 0) return "";
  return std::to_string(errors_) + " runs ended as infrastructure_error" +
         (first_error_.empty() ? "" : "; the first: " + first_error_);
}

std::optional<References> CampaignRecorder::known_references(const Scenario& scenario) {
  const std::string& hash = scenario.hash();
  if (!file_.has_scenario(hash)) return std::nullopt;
  const auto runs = known_by_scenario_.find(hash);
  const std::size_t all =
      campaign_.methods.size() * static_cast<std::size_t>(campaign_.options.repetitions);
  // Nothing needs the references of a scenario without missing runs.
  if (runs != known_by_scenario_.end() && runs->second == all) return References();
  return file_.read_references(hash);
}

bool CampaignRecorder::has_run(const Scenario& scenario, const RunSpec& spec) {
  return known_runs_.count(key_of(scenario.hash(), spec.method, spec.repetition)) > 0;
}

void CampaignRecorder::warn(const std::string& line) {
  if (recording_.warn) recording_.warn(line);
}

void CampaignRecorder::add_scenario(const ScenarioRecord& record, const References& references,
                                    const PackedScenario& packed) {
  file_.add_scenario(record, packed, references.timing);
  expect_commit();
}

void CampaignRecorder::add_run(const RunRecord& run, const RunTiming& timing,
                               const PackedTrajectory& trajectory) {
  RunTiming kept = timing;
  output_size_ += kept.output.size();
  if (output_size_ > kMaxOutputs) kept.output.clear();
  file_.add_run(run, kept, trajectory);
  ++added_runs_;
  failures_.add(run);
  if (first_error_.empty() && run.outcome == to_string(Outcome::InfrastructureError))
    first_error_ = run_id(run) + ": " + run.outcome_detail;
  expect_commit();
}

void CampaignRecorder::expect_commit() {
  if (!commit_at_) commit_at_ = recording_.clock() + kCommitInterval;
}

void CampaignRecorder::commit_when_due() {
  constexpr double kPatience = 0.05, kRetry = 1;  // s
  if (!commit_at_ || recording_.clock() < *commit_at_) return;
  if (file_.commit(kPatience)) {
    commit_at_.reset();
    return;
  }
  commit_at_ = recording_.clock() + kRetry;
  if (!delayed_ && recording_.notify)
    recording_.notify(file_.path() +
                      ": another program is reading it; results are stored when that ends");
  delayed_ = true;
}

void CampaignRecorder::commit_finally(const Execution& execution) {
  constexpr double kPatience = 0.5, kMaxWait = 3600, kMaxWaitInterrupted = 60;  // s
  const double begin = recording_.clock();
  std::optional<double> interrupted_at;
  commit_at_ = begin;
  commit_when_due();  // with a notice
  while (commit_at_) {
    if (file_.commit(kPatience)) {
      commit_at_.reset();
      break;
    }
    const double now = recording_.clock();
    if (!interrupted_at && execution.is_interrupted()) interrupted_at = now;
    if (now - begin > kMaxWait || now - interrupted_at.value_or(now) > kMaxWaitInterrupted)
      throw job_error(file_.path(), "is being read by another program; " + file_.rescue(),
                      "that program to end earlier");
  }
  file_.expect_runs(known_runs_.size() + added_runs_);
}

}  // namespace slalom
