#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/gui/descriptor_panel.h>
#include <slalom/gui/list_panel.h>
#include <slalom/gui/results_panel.h>
#include <slalom/gui/scenario_view.h>
#include <slalom/gui/studio_window.h>

namespace slalom {

// What the elements of the window tell each other, always by way of the Studio.

void StudioWindow::connect() {
  studio_->on_documents = [this] { show_documents(); };
  studio_->on_current = [this] { show_current(); };
  studio_->on_message = [this](const std::string& message, bool is_error) {
    say(message, is_error);
    if (is_error) show_message("That did not work", message);
  };
  studio_->scenes().on_scene = [this](const ScenePtr& scene) { view_->set_scene(scene); };
  list_->on_tab = [this](std::size_t tab) { studio_->activate(tab); };
  list_->on_close_tab = [this](std::size_t tab) { studio_->close_list(tab); };
  view_->on_edit = [this](const SceneEdit& edit) {
    try {
      studio_->edit_current(edit);
    } catch (const Error& error) {
      say(error.what(), true);
    }
  };
  ResultsLoader& loader = studio_->results();
  loader.on_source = [this](const OverlaySource& source) {
    results_->set_source(source);
    show_results(!source.path.empty());
  };
  loader.on_runs = [this](std::vector<OverlayRun> runs) { results_->set_runs(std::move(runs)); };
  loader.on_state = [this](const std::string& message) { results_->set_message(message); };
  connect_descriptors();
  studio_->on_view = [this] { show_list_values(); };
  results_->on_overlay_changed = [this](std::vector<OverlayTrajectory> runs) {
    view_->set_trajectories(std::move(runs));
  };
}

void StudioWindow::show_documents() {
  std::vector<ListDocument*> documents;
  for (const auto& document : studio_->documents()) documents.push_back(document.get());
  list_->set_documents(documents, studio_->active_index());
  show_list_values();
}

void StudioWindow::show_current() {
  descriptors_->show(studio_->current_hash());
  const auto entry = studio_->current_entry();
  setWindowTitle((entry ? entry->name + " - " : "") + "Slalom Studio");
}

/// What the plots of the list need. An empty list has nothing to read.
void StudioWindow::show_list_values() {
  const ListDocument* document = studio_->active();
  const std::vector<std::string> ids = descriptors_->shown_ids();
  if (document == nullptr || ids.empty()) return descriptors_->set_list_values(nullptr);
  studio_->descriptors().read_list(document->path(), document->view().hashes, ids);
}

void StudioWindow::connect_descriptors() {
  DescriptorLoader& loader = studio_->descriptors();
  loader.on_values = [this](const std::string& hash, const std::vector<DescribedValue>& values) {
    descriptors_->set_values(hash, values);
  };
  loader.on_failed = [this](const std::string& hash, const std::string& message) {
    descriptors_->fail(hash, message);
  };
  loader.on_list_values = [this](const std::shared_ptr<const ListValues>& values) {
    descriptors_->set_list_values(values);
  };
  loader.on_list_failed = [this](const std::string& message) {
    descriptors_->set_list_message(message);
  };
  descriptors_->on_shown_ids = [this] { show_list_values(); };
  descriptors_->on_select = [this](const std::vector<std::string>& hashes) {
    if (studio_->active() != nullptr) studio_->active()->select(hashes);
  };
  descriptors_->on_pick = [this](const std::string& hash) {
    if (studio_->active() != nullptr) studio_->active()->set_current(hash);
  };
  descriptors_->on_select_range = [this](const std::string& id, double low, double high) {
    if (studio_->active() == nullptr) return;
    studio_->active()->set_filter(format_number(low) + " <= " + id + " < " + format_number(high));
  };
  descriptors_->on_describe_list = [this](const std::vector<std::string>&) {
    studio_->describe_list();
  };
}

/// How far the descriptors of the current scenario are, which only their job knows.
void StudioWindow::show_progress() {
  std::string list_status;
  for (const JobStatus& job : studio_->jobs().status()) {
    if (job.key == DescriptorLoader::kKey) descriptors_->set_computing(job.done, job.total);
    if (job.key.rfind("describe ", 0) == 0)
      list_status = "computing " + std::to_string(job.done) + " of " + std::to_string(job.total);
  }
  descriptors_->set_list_status(list_status);
}

}  // namespace slalom
