// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/studio/palette.h>
#include <slalom/studio/plot_data.h>
#include <slalom/studio/results_overlay.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <utility>

namespace slalom {
namespace {

Value metric_of(const RunRecord& run, const std::string& id) {
  const auto found = run.metrics.find(id);
  return found == run.metrics.end() ? Value::na(kNotRecorded) : found->second.value;
}

std::string metric_text(const std::string& name, const Value& value, const std::string& unit) {
  if (value.is_na()) return name + " NA (" + value.reason() + ")";
  char number[48];
  std::snprintf(number, sizeof number, "%.3f %s", value.number(), unit.c_str());
  return name + " " + number;
}

std::string detail_of(const OverlayRun& run, const OverlayRow& row) {
  std::string text = overlay_label(run.record) + ": " + run.record.outcome;
  if (!run.record.outcome_detail.empty()) text += ", " + run.record.outcome_detail;
  if (!run.problem.empty()) text += "; " + run.problem;
  return text + "; " + metric_text("length", row.length, "m") + "; " +
         metric_text("time to goal", row.time, "s");
}

bool succeeded(const OverlayRun& run) {
  return run.record.outcome == to_string(Outcome::Success);
}

constexpr const char* kOpenKey = "results.open";
constexpr const char* kRunsKey = "results.runs";

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

}  // namespace

const std::vector<double>& ReplayClock::speeds() {
  static const std::vector<double> speeds = {0.25, 0.5, 1, 2, 4, 8, 16};
  return speeds;
}

std::string ReplayClock::speed_text() const {
  char text[16];
  std::snprintf(text, sizeof text, "%gx", speed());
  return text;
}

void ReplayClock::set_duration(double duration) {
  const bool at_end = time_ >= duration_;
  duration_ = std::isfinite(duration) ? std::max(duration, 0.0) : 0;
  time_ = at_end ? duration_ : std::min(time_, duration_);
  if (time_ >= duration_) playing_ = false;
}

void ReplayClock::seek(double time) {
  time_ = std::isnan(time) ? 0 : std::clamp(time, 0.0, duration_);
}

void ReplayClock::play() {
  if (duration_ <= 0) return;
  if (time_ >= duration_) time_ = 0;
  playing_ = true;
}

void ReplayClock::faster() {
  if (speed_ + 1 < speeds().size()) ++speed_;
}

void ReplayClock::slower() {
  if (speed_ > 0) --speed_;
}

bool ReplayClock::advance(double seconds) {
  if (!playing_ || !(seconds > 0)) return false;
  const double before = time_;
  seek(time_ + seconds * speed());
  if (time_ >= duration_) pause();
  return time_ != before;
}

void ReplayClock::tick(double now) {
  if (last_tick_ >= 0) advance(now - last_tick_);
  last_tick_ = playing_ ? now : -1;
}

void ResultsOverlay::set_source(OverlaySource source) {
  hidden_.clear();
  change_source(std::move(source));
}

void ResultsOverlay::change_source(OverlaySource source) {
  source_ = std::move(source);
  set_runs({});
}

void ResultsOverlay::set_runs(std::vector<OverlayRun> runs) {
  show_all_times();
  runs_ = std::move(runs);
  selected_.reset();
  clock_.pause();
  update_duration();
  clock_.seek(replays_runs() ? clock_.duration() : 0);
}

void ResultsOverlay::set_movers_duration(double duration) {
  movers_duration_ = duration;
  update_duration();
}

bool ResultsOverlay::replays_runs() const {
  for (std::size_t run = 0; run < runs_.size(); ++run)
    if (runs_[run].trajectory && is_shown(run)) return true;
  return false;
}

double ResultsOverlay::scene_time() const {
  for (std::size_t run = 0; run < runs_.size(); ++run)
    if (runs_[run].trajectory && is_shown(run))
      return clock_.time() + runs_[run].trajectory->samples.front().t;
  return clock_.time();
}

Movers ResultsOverlay::people_in(const Scenario& scenario) const {
  const std::size_t count = scenario.people().size();
  const auto has_people = [&](std::size_t run) {
    return is_shown(run) && runs_[run].people.size() == count;
  };
  if (count > 0 && selected_ && has_people(*selected_)) return runs_[*selected_].people;
  for (std::size_t run = 0; count > 0 && run < runs_.size(); ++run)
    if (has_people(run)) return runs_[run].people;
  Movers standing;
  for (const Person& person : scenario.people())
    standing.push_back({person.id, person.radius, {{person.begin, person.start}}});
  return standing;
}

OverlayRow ResultsOverlay::make_row(std::size_t run, bool indented) const {
  const OverlayRun& source = runs_[run];
  OverlayRow row;
  row.label = indented ? overlay_label(source.record) : source.record.method;
  row.runs = {run};
  row.indented = indented;
  row.shown = is_shown(run);
  row.color = color_of(run);
  row.outcome = source.record.outcome;
  row.success = succeeded(source) ? "yes" : "no";
  row.length = metric_of(source.record, "path_length");
  row.time = metric_of(source.record, "time_to_goal");
  row.detail = detail_of(source, row);
  return row;
}

OverlayRow ResultsOverlay::make_group(std::size_t first, std::size_t end) const {
  OverlayRow row;
  row.group = true;
  row.label = runs_[first].record.method;
  row.color = color_of(first);
  row.outcome = runs_[first].record.outcome;
  std::size_t successes = 0;
  for (std::size_t run = first; run < end; ++run) {
    row.runs.push_back(run);
    row.shown = row.shown || is_shown(run);
    if (runs_[run].record.outcome != row.outcome) row.outcome = "mixed";
    if (succeeded(runs_[run])) ++successes;
  }
  row.success = std::to_string(successes) + " of " + std::to_string(end - first);
  row.detail = row.label + ": " + row.success + " runs reached the goal";
  return row;
}

std::vector<OverlayRow> ResultsOverlay::rows() const {
  std::vector<OverlayRow> rows;
  for (std::size_t first = 0, end = 0; first < runs_.size(); first = end) {
    while (end < runs_.size() && runs_[end].record.method == runs_[first].record.method) ++end;
    const bool several = end - first > 1;
    if (several) rows.push_back(make_group(first, end));
    for (std::size_t run = first; run < end; ++run) rows.push_back(make_row(run, several));
  }
  return rows;
}

bool ResultsOverlay::is_shown(std::size_t run) const {
  const RunRecord& record = runs_[run].record;
  return hidden_.count({record.method, record.repetition}) == 0;
}

void ResultsOverlay::toggle(const OverlayRow& row) {
  const bool hide = std::any_of(row.runs.begin(), row.runs.end(),
                                [this](std::size_t run) { return is_shown(run); });
  for (const std::size_t run : row.runs) {
    const std::pair<std::string, int> key = {runs_[run].record.method,
                                             runs_[run].record.repetition};
    if (hide)
      hidden_.insert(key);
    else
      hidden_.erase(key);
  }
  update_duration();
}

void ResultsOverlay::show_all(bool shown) {
  hidden_.clear();
  for (const OverlayRun& run : runs_)
    if (!shown) hidden_.insert({run.record.method, run.record.repetition});
  update_duration();
}

void ResultsOverlay::update_duration() {
  if (!replays_runs()) {
    const double time = clock_.time();
    clock_.set_duration(movers_duration_);
    return clock_.seek(time);
  }
  double duration = 0;
  for (std::size_t run = 0; run < runs_.size(); ++run)
    if (runs_[run].trajectory && is_shown(run))
      duration = std::max(duration, runs_[run].trajectory->duration());
  clock_.set_duration(duration);
}

std::vector<OverlayTrajectory> ResultsOverlay::trajectories() const {
  std::vector<OverlayTrajectory> drawn;
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const OverlayRun& run = runs_[i];
    if (!run.trajectory || !is_shown(i)) continue;
    OverlayTrajectory line;
    line.label = overlay_label(run.record);
    line.outcome = run.record.outcome;
    line.color = color_of(i);
    line.run = i;
    line.trajectory = run.trajectory;
    line.time = clock_.time();
    line.sample = sample_at(*run.trajectory, line.time);
    line.pose = pose_at(*run.trajectory, line.time);
    if (source_.robot) line.footprint = source_.robot->shape();
    if (line.sample < run.scans.size()) line.scan = run.scans[line.sample];
    drawn.push_back(std::move(line));
  }
  return drawn;
}

Color ResultsOverlay::color_of(std::size_t run) const {
  const auto& methods = source_.methods;
  const auto found = std::lower_bound(methods.begin(), methods.end(), runs_[run].record.method);
  return method_line_color(static_cast<std::size_t>(found - methods.begin()));
}

std::vector<ColoredPart> colored_parts(const std::vector<double>& values, double maximum) {
  constexpr double kColors = 32;
  // std::max() with NaN as its second argument is 0.
  const auto level = [&](std::size_t i) {
    return maximum > 0 ? std::round(kColors * std::max(0.0, std::min(values[i] / maximum, 1.0)))
                       : 0.0;
  };
  std::vector<ColoredPart> parts;
  for (std::size_t begin = 0; begin + 1 < values.size(); begin = parts.back().end) {
    std::size_t end = begin + 1;
    while (end + 1 < values.size() && level(end) == level(begin)) ++end;
    parts.push_back({begin, end, heat_color(level(begin) / kColors)});
  }
  return parts;
}

void ResultsOverlay::show_times(double first, double last) {
  const auto [begin, end] = std::minmax(
      {std::clamp(first, 0.0, clock_.duration()), std::clamp(last, 0.0, clock_.duration())});
  if (begin < end) shown_times_ = {begin, end};
}

const std::vector<double>* ResultsOverlay::colored_values(std::size_t run) const {
  switch (coloring_) {
    case RunColoring::Speed:
      return &runs_[run].speeds;
    case RunColoring::Clearance:
      return &runs_[run].clearances;
    default:
      return nullptr;
  }
}

double ResultsOverlay::max_colored_value() const {
  double maximum = 0;
  for (std::size_t run = 0; run < runs_.size(); ++run)
    if (const std::vector<double>* values = colored_values(run))
      for (const double value : *values)
        if (std::isfinite(value)) maximum = std::max(maximum, value);
  return maximum;
}

std::optional<ResultsOverlay::RunSample> ResultsOverlay::sample_near(const mrpt::math::TPoint2D& at,
                                                                     double radius) const {
  std::optional<RunSample> nearest;
  double least = radius * radius;
  for (std::size_t run = 0; run < runs_.size(); ++run) {
    if (!runs_[run].trajectory || !is_shown(run)) continue;
    const auto& samples = runs_[run].trajectory->samples;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double dx = samples[i].pose.x - at.x, dy = samples[i].pose.y - at.y;
      const double squared = dx * dx + dy * dy;
      if (squared > least || (nearest && squared == least)) continue;
      least = squared;
      nearest = RunSample{run, i};
    }
  }
  return nearest;
}

std::string ResultsOverlay::sample_text(const RunSample& at) const {
  const OverlayRun& run = runs_[at.run];
  char text[96];
  std::snprintf(text, sizeof text, " at %.2f s: %.2f m/s, clearance %.3f m", run.times[at.sample],
                run.speeds[at.sample], run.clearances[at.sample]);
  return overlay_label(run.record) + text;
}

std::optional<double> ResultsOverlay::now(std::size_t run,
                                          const std::vector<double>& series) const {
  const OverlayRun& source = runs_[run];
  if (!source.trajectory || clock_.time() > source.trajectory->duration()) return std::nullopt;
  return LineSeries{"", {}, source.times, series}.value_at(clock_.time());
}

std::optional<double> ResultsOverlay::clearance_now(std::size_t run) const {
  return now(run, runs_[run].clearances);
}

std::optional<double> ResultsOverlay::speed_now(std::size_t run) const {
  return now(run, runs_[run].speeds);
}

void ResultsLoader::open(const std::string& path) {
  jobs_.start(
      kOpenKey, "Open " + file_name(path),
      [this, path](Progress&) -> Jobs::Delivery {
        return [this, source = open_overlay_source(path),
                fields = std::make_shared<const ResultFields>(path)] {
          here_.clear();
          file_ = source;
          overlay_.set_source(source);
          fields_ = fields;
          opened_(file_.path);
          read_runs();
        };
      },
      [this](const std::string& message) { events_.show_error(message); });
}

void ResultsLoader::close() {
  jobs_.cancel(kOpenKey);
  jobs_.cancel(kRunsKey);
  fields_.reset();
  file_ = {};
  here_.clear();
  show_runs({}, {}, "No result file is open.");
}

void ResultsLoader::show_here(const std::string& scenario_hash, OverlaySource source,
                              std::shared_ptr<const ScratchFolder> folder) {
  here_[scenario_hash] = {std::move(source), std::move(folder)};
  if (scenario_hash == hash_) read_runs();
}

void ResultsLoader::discard_here() {
  here_.erase(hash_);
  if (here_.empty() && file_.path.empty()) return close();
  read_runs();
}

void ResultsLoader::show(const std::string& scenario_hash) {
  if (scenario_hash == hash_) return;
  hash_ = scenario_hash;
  if (overlay_.is_open()) read_runs();
}

void ResultsLoader::read_runs() {
  jobs_.cancel(kRunsKey);
  replay_when_read_ = false;
  const auto here = here_.find(hash_);
  const bool none = here == here_.end() && file_.path.empty();
  if (!none) overlay_.change_source(here == here_.end() ? file_ : here->second.source);
  set_runs({}, hash_.empty() ? "No scenario is selected."
               : none        ? "No method was run on this scenario."
                             : "Reading runs ...");
  if (hash_.empty() || none) return;
  jobs_.start(
      kRunsKey, "Read runs of " + file_name(overlay_.source().path),
      [this, source = overlay_.source(), hash = hash_](Progress&) -> Jobs::Delivery {
        return [this, runs = read_overlay_runs(source, hash)] {
          set_runs(runs, file_name(overlay_.source().path) + " contains no runs of this scenario.");
          if (std::exchange(replay_when_read_, false)) replay();
        };
      },
      [this](const std::string& message) {
        set_runs({}, "Reading the runs failed: " + message);
        events_.show_error(message);
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
  events_.publish(Change::Runs);
}

void ResultsLoader::toggle(const OverlayRow& row) {
  overlay_.toggle(row);
  events_.publish(Change::Runs);
}

void ResultsLoader::replay() {
  replay_when_read_ = jobs_.is_pending(kRunsKey);
  if (replay_when_read_) return;
  overlay_.clock().seek(0);
  overlay_.clock().play();
}

std::string ResultsLoader::replay_disabled_reason() const {
  if (!overlay_.is_open()) return "no results are open";
  const bool playable =
      jobs_.is_pending(kRunsKey) || (overlay_.replays_runs() && overlay_.clock().duration() > 0);
  return playable ? "" : "no run of this scenario is shown";
}

void ResultsLoader::show_all(bool shown) {
  overlay_.show_all(shown);
  events_.publish(Change::Runs);
}

}  // namespace slalom
