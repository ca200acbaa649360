#pragma once

#include <slalom/gui/jobs.h>
#include <slalom/gui/overlay_run.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// Brings the runs of the scenario that is shown, from the result file that is open, without making
/// the window wait.
class ResultsLoader {
 public:
  explicit ResultsLoader(Jobs& jobs) : jobs_(jobs) {}

  std::function<void(OverlaySource)> on_source;              ///< a file was opened or closed
  std::function<void(std::vector<OverlayRun>)> on_runs;      ///< of the scenario that is shown
  std::function<void(const std::string& message)> on_state;  ///< what there is instead of runs
  std::function<void(const std::string& message)> on_error;  ///< a file cannot be read

  void open(const std::string& path);
  void close();
  /// The scenario that is shown now; empty for none. Nothing to do when it was shown before.
  void show(const std::string& scenario_hash);

 private:
  void opened(OverlaySource source);
  void read_runs();
  void arrived(std::vector<OverlayRun> runs);
  void say(const std::string& message);

  Jobs& jobs_;
  OverlaySource source_;
  std::string hash_;
};

}  // namespace slalom
