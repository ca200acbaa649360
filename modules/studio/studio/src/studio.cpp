// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/commands/describe_list.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/studio/studio.h>

#include <algorithm>
#include <filesystem>

namespace slalom {

namespace {

constexpr const char* kDescribe = "describe ";

std::string describe_key(const std::string& path) {
  return kDescribe + path;
}

std::string count_of_scenarios(std::size_t count) {
  return count_text(count, "scenario");
}

DescribeOptions options_for(const SceneSettings& settings) {
  DescribeOptions options;
  options.robot = settings.robot.shape();
  options.sensor_range = settings.sensor.max_range;
  options.resolution = settings.resolution;
  return options;
}

}  // namespace

Studio::Studio(SceneSettings settings, StudioServices services, std::function<void()> wake)
    : services_(std::move(services)),
      jobs_(std::move(wake)),
      scenes_(jobs_, events_, std::move(settings)),
      results_(jobs_, events_, [this](const std::string& path) { remember_file(recent_, path); }),
      describe_options_(options_for(scenes_.settings())),
      descriptors_(jobs_, events_, describe_options_,
                   [this](const std::string& hash, const std::vector<KeyedValue>& values) {
                     for (const auto& document : documents_) document->store_values(hash, values);
                   }) {
  events_.observe({Change::Runs}, [this] {
    for (const auto& document : documents_) document->set_results(results_.fields());
  });
  events_.observe({Change::Scene}, [this] {
    const ScenePtr& scene = scenes_.scene();
    results_.overlay().set_movers_duration(scene ? last_waypoint_time(scene->scenario().movers())
                                                 : 0);
  });
}

ListDocument* Studio::active() const {
  return documents_.empty() ? nullptr : documents_[active_].get();
}

void Studio::open_list(const std::string& path) {
  for (std::size_t i = 0; i < documents_.size(); ++i) {
    std::error_code error;
    if (!std::filesystem::equivalent(documents_[i]->path(), path, error)) continue;
    remember_file(recent_, documents_[i]->path());
    return activate(i);
  }
  auto document = std::make_unique<ListDocument>(path, &jobs_);
  document->set_describe_options(describe_options());
  document->set_results(results_.fields());
  document->observe([this, source = document.get()](Change change) {
    if (source != active()) return;
    if (change == Change::Current) return current_changed();
    if (change == Change::Command) return events_.show_status(source->history().undo_title());
    if (change == Change::CurrentRow || change == Change::CurrentLost)
      return events_.publish(change);
    events_.publish(change);
    read_list_values();
  });
  documents_.push_back(std::move(document));
  remember_file(recent_, path);
  activate(documents_.size() - 1);
}

void Studio::create_list(const std::string& path) {
  if (std::filesystem::exists(path))
    throw usage_error(path, "already exists", "the path of a new file, or File > Open");
  ScenarioList::create(path);
  open_list(path);
}

void Studio::close_list(std::size_t index) {
  events_.show_status(documents_[index]->title() + " was closed");
  documents_.erase(documents_.begin() + static_cast<std::ptrdiff_t>(index));
  if (active_ > index || active_ == documents_.size()) active_ -= active_ > 0 ? 1 : 0;
  documents_changed();
}

void Studio::activate(std::size_t index) {
  active_ = index;
  documents_changed();
  events_.show_status(active()->title() + ": " + count_text(active()->list().size(), "scenario"));
}

void Studio::documents_changed() {
  events_.publish(Change::Documents);
  read_list_values();
  current_changed();
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
  if (hash != current_hash_) {
    current_hash_ = hash;
    if (!events_.status().scenario.empty()) events_.show_status("");
    results_.show(hash);
    descriptors_.show(active() == nullptr ? "" : active()->path(), hash);
    try {
      if (hash.empty())
        scenes_.clear();
      else
        scenes_.show(active()->list().read(hash));
    } catch (const Error& error) {
      scenes_.clear();
      events_.show_error(error.what());
    }
  }
  events_.publish(Change::Current);
}

void Studio::edit_current(const SceneEdit& edit) {
  try {
    active()->edit_current(edit.scenario);
    events_.show_status(StudioEvents::Status{edit.title, false, false, edit.scenario.hash()});
  } catch (const Error& error) {
    events_.show_status(StudioEvents::Status{error.what(), true, false, current_hash()});
  }
}

void Studio::remove(ListDocument& list) {
  const std::size_t count = list.selected_count();
  list.remove_selected();
  events_.show_status(StudioEvents::Status{"Deleted " + count_of_scenarios(count), false, true});
}

void Studio::remove_selected() {
  ListDocument& list = *active();
  const std::vector<std::string> hashes = list.selected();
  if (hashes.size() != 1)
    return events_.show_form(
        {"Delete scenarios",
         "Delete",
         "Delete " + count_of_scenarios(hashes.size()) + " of " + list.title() + "?",
         {},
         [this, &list](const FormValues&) {
           // A job may have opened another list meanwhile.
           if (active() != &list) throw usage_error("list", "is no longer the active one");
           remove(list);
         }});
  if (reveal_(*list.view().index_of(hashes.front()))) return remove(list);
  events_.show_status("The selected scenario was out of view; Delete again deletes it");
}

void Studio::undo() {
  const std::string title = active()->history().undo_title();
  active()->undo();
  events_.show_status("Undone: " + title);
}

void Studio::redo() {
  const std::string title = active()->history().redo_title();
  active()->redo();
  events_.show_status("Redone: " + title);
}

void Studio::track_descriptors(const std::vector<std::string>& ids) {
  shown_ids_ = ids;
  read_list_values();
}

void Studio::read_list_values() {
  if (active() == nullptr) return descriptors_.read_list("", {}, {});
  descriptors_.read_list(active()->path(), active()->view().hashes, shown_ids_);
}

void Studio::filter_range(const std::string& id, double low, double high) {
  if (active() != nullptr)
    active()->set_filter(format_number(low) + " <= " + id + " < " + format_number(high));
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
          events_.publish(Change::Current);
          events_.show_status("All descriptors are computed");
        };
      },
      [this](const std::string& message) { events_.show_error(message); });
}

std::string Studio::describe_progress() const {
  for (const JobStatus& job : jobs_.status())
    if (job.key.rfind(kDescribe, 0) == 0)
      return "computing " + std::to_string(job.done) + " of " + std::to_string(job.total);
  return "";
}

bool Studio::poll() {
  const bool delivered = jobs_.poll() > 0;
  descriptors_.update_progress();
  return delivered;
}

void Studio::check_files() {
  for (const auto& document : documents_)
    if (!jobs_.is_pending(describe_key(document->path())))
      if (const std::string message = document->update_from_file(); !message.empty())
        events_.show_status(message);
}

}  // namespace slalom
