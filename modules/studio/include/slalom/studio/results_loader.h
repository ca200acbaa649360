#pragma once

#include <slalom/studio/jobs.h>
#include <slalom/studio/notices.h>
#include <slalom/studio/results_overlay.h>

#include <string>
#include <vector>

namespace slalom {

/// The overlay of recorded runs: loads those of the current scenario from the open result file in
/// background jobs. Publishes Change::Runs.
class ResultsLoader {
 public:
  ResultsLoader(Jobs& jobs, Notices& notices) : jobs_(jobs), notices_(notices) {}

  ResultsOverlay& overlay() { return overlay_; }
  const ResultsOverlay& overlay() const { return overlay_; }
  const std::string& message() const { return message_; }  ///< why there are no runs

  void open(const std::string& path);
  void close();
  /// Sets the current scenario by its hash; empty for none. Ignored if it is unchanged.
  void show(const std::string& scenario_hash);
  /// Shows these runs, whatever the current scenario is.
  void show_runs(const OverlaySource& source, std::vector<OverlayRun> runs,
                 const std::string& message = "");
  void toggle(const OverlayRow& row);  ///< see ResultsOverlay
  void show_all(bool shown);

 private:
  void read_runs();
  void set_runs(std::vector<OverlayRun> runs, const std::string& message);

  Jobs& jobs_;
  Notices& notices_;
  ResultsOverlay overlay_;
  std::string hash_, message_ = "No result file is open.";
};

}  // namespace slalom
