#pragma once

#include <slalom/campaign/campaign.h>
#include <slalom/io/result_file.h>

namespace slalom {

/// Writes what a campaign finds into a result file and commits in short intervals, so that a kill
/// costs seconds of work at most.
class ResultSink : public CampaignSink {
 public:
  explicit ResultSink(ResultFile& file) : file_(file) {}

  void add_scenario(const ScenarioRecord& record, const Scenario& scenario,
                    const References& references) override {
    file_.add_scenario(record, scenario, references);
    count();
  }
  void add_run(const RunRecord& run, const RunTiming& timing,
               const Trajectory& trajectory) override {
    file_.add_run(run, timing, trajectory);
    count();
  }

 private:
  void count() {
    constexpr int kRecordsPerCommit = 64;
    if (++pending_ < kRecordsPerCommit) return;
    file_.commit();
    pending_ = 0;
  }

  ResultFile& file_;
  int pending_ = 0;
};

}  // namespace slalom
