#pragma once

#include <slalom/gui/descriptor_loader.h>
#include <slalom/gui/jobs.h>
#include <slalom/gui/list_document.h>
#include <slalom/gui/results_loader.h>
#include <slalom/gui/scene_editor.h>
#include <slalom/gui/scene_loader.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// What is open in Slalom Studio: lists, the scenario that is looked at, a result file; and the
/// work that is under way. Knows no window: a window shows it and tells it what the user wants.
class Studio {
 public:
  /// `wake` is called from any thread when poll() has something to do.
  Studio(SceneSettings settings, std::function<void()> wake);

  std::function<void()> on_documents;  ///< another list is open, closed or before the others
  std::function<void()> on_current;    ///< another scenario, or another content, is looked at
  std::function<void()> on_view;       ///< the active list shows other scenarios
  std::function<void()> on_selection;  ///< in the active list
  std::function<void(const std::string& message, bool is_error)> on_message;

  Jobs& jobs() { return jobs_; }
  SceneLoader& scenes() { return scenes_; }
  ResultsLoader& results() { return results_; }
  DescriptorLoader& descriptors() { return descriptors_; }
  const DescribeOptions& describe_options() const { return describe_options_; }

  const std::vector<std::unique_ptr<ListDocument>>& documents() const { return documents_; }
  std::size_t active_index() const { return active_; }
  ListDocument* active() const;  ///< null while no list is open
  /// Opens a list, or brings it to the front. Throws as ScenarioList::open() does.
  void open_list(const std::string& path);
  /// A new list, empty, in place of nothing: throws Error (Usage) when the file is there.
  void create_list(const std::string& path);
  void close_list(std::size_t index);
  void activate(std::size_t index);

  std::string current_hash() const;  ///< empty for none
  std::optional<ScenarioList::Entry> current_entry() const;
  /// Puts an edited scenario in the place of the current one.
  void edit_current(const SceneEdit& edit);
  /// Appends scenarios to the active list, as one action that can be taken back, and goes to the
  /// first of them. Throws Error (Usage) without a list.
  void add(std::vector<Scenario> scenarios, std::vector<ScenarioOrigin> origins = {});
  /// Computes the descriptors of all scenarios of the active list that it lacks.
  void describe_list();

  /// Takes in what workers have done and what other programs did to open files. True when something
  /// was.
  bool poll();
  void look_at_files();

  void say(const std::string& message) const;
  void complain(const std::string& message) const;

 private:
  void watch(ListDocument& document);
  void current_changed();

  Jobs jobs_;
  SceneLoader scenes_;
  ResultsLoader results_;
  DescribeOptions describe_options_;
  DescriptorLoader descriptors_;
  std::vector<std::unique_ptr<ListDocument>> documents_;
  std::size_t active_ = 0;
  std::string shown_hash_;
};

}  // namespace slalom
