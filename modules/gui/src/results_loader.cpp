#include <slalom/gui/results_loader.h>

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
        return [this, source = open_overlay_source(path)] { opened(source); };
      },
      [this](const std::string& message) {
        if (on_error) on_error(message);
      });
}

void ResultsLoader::opened(OverlaySource source) {
  source_ = std::move(source);
  if (on_source) on_source(source_);
  read_runs();
}

void ResultsLoader::close() {
  jobs_.cancel(kOpenKey);
  jobs_.cancel(kRunsKey);
  source_ = {};
  if (on_source) on_source(source_);
  say("No results are open.");
}

void ResultsLoader::show(const std::string& scenario_hash) {
  if (scenario_hash == hash_) return;
  hash_ = scenario_hash;
  if (!source_.path.empty()) read_runs();
}

void ResultsLoader::read_runs() {
  jobs_.cancel(kRunsKey);
  if (on_runs) on_runs({});
  if (hash_.empty()) return say("No scenario is shown.");
  say("Reading the runs in this scenario ...");
  jobs_.start(
      kRunsKey, "Read runs of " + file_name(source_.path),
      [this, source = source_, hash = hash_](Progress&) -> Jobs::Delivery {
        auto runs = read_overlay_runs(source, hash);
        return [this, runs = std::move(runs)] { arrived(runs); };
      },
      [this](const std::string& message) {
        say("The runs cannot be read: " + message);
        if (on_error) on_error(message);
      },
      false);
}

void ResultsLoader::arrived(std::vector<OverlayRun> runs) {
  say(runs.empty() ? file_name(source_.path) + " has no runs in this scenario." : "");
  if (on_runs) on_runs(std::move(runs));
}

void ResultsLoader::say(const std::string& message) {
  if (on_state) on_state(message);
}

}  // namespace slalom
