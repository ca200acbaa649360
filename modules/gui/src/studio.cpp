#include <slalom/commands/describe_list.h>
#include <slalom/core/error.h>
#include <slalom/gui/studio.h>

#include <algorithm>
#include <filesystem>

namespace slalom {

namespace {

std::string describe_key(const std::string& path) {
  return "describe " + path;
}

DescribeOptions options_for(const SceneSettings& settings) {
  DescribeOptions options;
  options.robot = settings.robot.shape();
  options.sensor_range = settings.sensor.max_range;
  options.resolution = settings.resolution;
  return options;
}

}  // namespace

Studio::Studio(SceneSettings settings, std::function<void()> wake)
    : jobs_(std::move(wake)),
      scenes_(jobs_, std::move(settings)),
      results_(jobs_),
      describe_options_(options_for(scenes_.settings())),
      descriptors_(jobs_, describe_options_) {
  descriptors_.on_computed = [this](const std::string& hash,
                                    const std::vector<GeneratedValue>& values) {
    for (const auto& document : documents_) document->keep_values(hash, values);
  };
  scenes_.on_error = [this](const std::string& message) { complain(message); };
  results_.on_error = [this](const std::string& message) { complain(message); };
}

ListDocument* Studio::active() const {
  return documents_.empty() ? nullptr : documents_[active_].get();
}

void Studio::open_list(const std::string& path) {
  for (std::size_t i = 0; i < documents_.size(); ++i) {
    std::error_code error;
    if (std::filesystem::equivalent(documents_[i]->path(), path, error)) return activate(i);
  }
  auto document = std::make_unique<ListDocument>(path, &jobs_);
  document->set_describe_options(describe_options());
  watch(*document);
  documents_.push_back(std::move(document));
  activate(documents_.size() - 1);
}

void Studio::create_list(const std::string& path) {
  if (std::filesystem::exists(path))
    throw usage_error(path, "is there already", "a file that is not there, or File > Open");
  ScenarioList::create(path);
  open_list(path);
}

void Studio::close_list(std::size_t index) {
  documents_.erase(documents_.begin() + static_cast<std::ptrdiff_t>(index));
  if (active_ > index || active_ == documents_.size()) active_ -= active_ > 0 ? 1 : 0;
  if (on_documents) on_documents();
  current_changed();
}

void Studio::activate(std::size_t index) {
  active_ = index;
  if (on_documents) on_documents();
  current_changed();
  say(active()->title() + ": " + std::to_string(active()->list().size()) + " scenarios");
}

void Studio::watch(ListDocument& document) {
  const ListDocument* which = &document;
  document.on_current = [this, which](const std::string&) {
    if (which == active()) current_changed();
  };
  document.on_view = [this, which] {
    if (which == active() && on_view) on_view();
  };
  document.on_selection = [this, which] {
    if (which == active() && on_selection) on_selection();
  };
}

std::string Studio::current_hash() const {
  return active() == nullptr ? "" : active()->current();
}

std::optional<ScenarioList::Entry> Studio::current_entry() const {
  if (current_hash().empty()) return std::nullopt;
  const ListRow* row = active()->row(current_hash());
  return row == nullptr ? std::nullopt : std::optional(row->entry);
}

void Studio::current_changed() {
  const std::string hash = current_hash();
  if (hash != shown_hash_) {
    shown_hash_ = hash;
    results_.show(hash);
    descriptors_.show(active() == nullptr ? "" : active()->path(), hash);
    try {
      if (hash.empty())
        scenes_.clear();
      else
        scenes_.show(active()->list().read(hash));
    } catch (const Error& error) {
      scenes_.clear();
      complain(error.what());
    }
  }
  if (on_current) on_current();
}

void Studio::edit_current(const SceneEdit& edit) {
  ListDocument& document = *active();
  document.run(make_edit_scenario(document.list(), document.current(), edit.scenario));
  document.set_current(edit.scenario.hash());
  say(edit.title);
}

void Studio::add(std::vector<Scenario> scenarios, std::vector<ScenarioOrigin> origins) {
  if (active() == nullptr) throw usage_error("add scenarios", "no list is open", "an open list");
  if (scenarios.empty()) return;
  const std::string first = scenarios.front().hash();
  ListDocument& document = *active();
  const std::size_t before = document.list().size();
  document.run(make_add_scenarios(document.list(), std::move(scenarios), std::move(origins)));
  document.set_current(first);
  say("Added " + std::to_string(document.list().size() - before) + " scenarios to " +
      document.title());
}

void Studio::describe_list() {
  const std::string path = active()->path();
  jobs_.start(
      describe_key(path), "Compute descriptors of " + active()->title(),
      [this, path, options = describe_options()](Progress& progress) -> Jobs::Delivery {
        ScenarioList list = ScenarioList::open(path);
        make_describe_list(list, options, progress)->execute();
        return [this, path] {
          for (const auto& document : documents_)
            if (document->path() == path) document->refresh();
          if (on_current) on_current();
          say("All descriptors are computed");
        };
      },
      [this](const std::string& message) { complain(message); });
}

bool Studio::poll() {
  return jobs_.poll() > 0;
}

void Studio::look_at_files() {
  for (const auto& document : documents_)
    if (!jobs_.is_pending(describe_key(document->path())) && document->follow_file() && on_message)
      on_message(document->notice(), false);
}

void Studio::say(const std::string& message) const {
  if (on_message) on_message(message, false);
}

void Studio::complain(const std::string& message) const {
  if (on_message) on_message(message, true);
}

}  // namespace slalom
