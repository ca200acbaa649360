#include <slalom/studio/results_loader.h>

#include <filesystem>

namespace slalom {
namespace {

constexpr const char* kOpenKey = "results.open";
constexpr const char* kRunsKey = "results.runs";

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

}  // namespace

void ResultsLoader::open(const std::string& path) {
  jobs_.start(
      kOpenKey, "Open " + file_name(path),
      [this, path](Progress&) -> Jobs::Delivery {
        return [this, source = open_overlay_source(path)] {
          overlay_.set_source(source);
          read_runs();
        };
      },
      [this](const std::string& message) { notices_.show_error(message); });
}

void ResultsLoader::close() {
  jobs_.cancel(kOpenKey);
  jobs_.cancel(kRunsKey);
  show_runs({}, {}, "No result file is open.");
}

void ResultsLoader::show(const std::string& scenario_hash) {
  if (scenario_hash == hash_) return;
  hash_ = scenario_hash;
  if (overlay_.is_open()) read_runs();
}

void ResultsLoader::read_runs() {
  jobs_.cancel(kRunsKey);
  set_runs({}, hash_.empty() ? "No scenario is selected." : "Reading runs ...");
  if (hash_.empty()) return;
  jobs_.start(
      kRunsKey, "Read runs of " + file_name(overlay_.source().path),
      [this, source = overlay_.source(), hash = hash_](Progress&) -> Jobs::Delivery {
        return [this, runs = read_overlay_runs(source, hash)] {
          set_runs(runs, file_name(overlay_.source().path) + " contains no runs of this scenario.");
        };
      },
      [this](const std::string& message) {
        set_runs({}, "Reading the runs failed: " + message);
        notices_.show_error(message);
      },
      false);
}

void ResultsLoader::show_runs(const OverlaySource& source, std::vector<OverlayRun> runs,
                              const std::string& message) {
  overlay_.set_source(source);
  set_runs(std::move(runs), message);
}

void ResultsLoader::set_runs(std::vector<OverlayRun> runs, const std::string& message) {
  message_ = runs.empty() ? message : "";
  overlay_.set_runs(std::move(runs));
  notices_.publish(Change::Runs);
}

void ResultsLoader::toggle(const OverlayRow& row) {
  overlay_.toggle(row);
  notices_.publish(Change::Runs);
}

void ResultsLoader::show_all(bool shown) {
  overlay_.show_all(shown);
  notices_.publish(Change::Runs);
}

}  // namespace slalom
