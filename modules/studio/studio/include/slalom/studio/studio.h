// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/studio/descriptor_loader.h>
#include <slalom/studio/list_document.h>
#include <slalom/studio/results_overlay.h>
#include <slalom/studio/scene.h>
#include <slalom/studio/scene_editor.h>
#include <slalom/studio/services.h>
#include <slalom/studio/settings.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// The state of Slalom Studio: open lists, the current scenario, a result file and running jobs.
/// Independent of the window, whose panels display it, call its functions and observe its changes.
class Studio {
 public:
  /// `wake` may be called from any thread, when poll() has something to do.
  Studio(SceneSettings settings, StudioServices services, std::function<void()> wake);

  StudioEvents& events() { return events_; }
  Jobs& jobs() { return jobs_; }
  SceneLoader& scenes() { return scenes_; }
  ResultsLoader& results() { return results_; }
  DescriptorLoader& descriptors() { return descriptors_; }
  const StudioServices& services() const { return services_; }
  const DescribeOptions& describe_options() const { return describe_options_; }

  const std::vector<std::unique_ptr<ListDocument>>& documents() const { return documents_; }
  std::size_t active_index() const { return active_; }
  ListDocument* active() const;  ///< null if no list is open
  /// Opens a list, or activates it if it is open. Throws like ScenarioList::open().
  void open_list(const std::string& path);
  /// Creates and opens an empty list. Throws Error (Usage) when the file exists.
  void create_list(const std::string& path);
  void close_list(std::size_t index);
  void activate(std::size_t index);

  /// Whether the list is a grid of pictures.
  bool& grid() { return grid_; }
  bool grid() const { return grid_; }

  RecentFiles& recent() { return recent_; }
  const RecentFiles& recent() const { return recent_; }

  /// The choices of the user about run_methods_here().
  struct RunChoice {
    std::string campaign;  ///< an .ini or results; empty: the default
    std::string trusted;   ///< results whose methods may execute what they name
  };
  RunChoice& run_choice() { return run_choice_; }

  std::string current_hash() const;  ///< empty for none
  std::optional<ScenarioList::Entry> current_entry() const;
  /// Replaces the current scenario by an edited one; shows an error in the status line.
  void edit_current(const SceneEdit& edit);
  /// Removes the only selected scenario of the active list if its row is visible, else scrolls to
  /// it; asks before it removes several.
  void remove_selected();
  /// `reveal` scrolls to an index of the active view; returns whether its row was visible before.
  void set_reveal(std::function<bool(std::size_t)> reveal) { reveal_ = std::move(reveal); }
  /// Undo and redo in the active list, reported in the status line. Throw as those of ListDocument.
  void undo();
  void redo();

  /// Reads the values of these descriptors for the active list, now and whenever it changes.
  void track_descriptors(const std::vector<std::string>& ids);
  /// Computes the missing descriptors of all scenarios of the active list.
  void describe_list();
  std::string describe_progress() const;  ///< "computing 30 of 1000"; empty if it does not
  /// Filters the active list by low <= value < high.
  void filter_range(const std::string& id, double low, double high);

  /// Delivers the results of finished jobs. Returns whether there were any.
  bool poll();
  void check_files();  ///< reloads files that other programs changed

 private:
  void documents_changed();
  void current_changed();
  void remove(ListDocument& list);
  void read_list_values();

  StudioEvents events_;
  StudioServices services_;  ///< used by jobs
  Jobs jobs_;
  SceneLoader scenes_;
  ResultsLoader results_;
  DescribeOptions describe_options_;
  DescriptorLoader descriptors_;
  std::vector<std::unique_ptr<ListDocument>> documents_;
  std::size_t active_ = 0;
  std::string current_hash_;
  std::vector<std::string> shown_ids_;
  RunChoice run_choice_;
  RecentFiles recent_;
  bool grid_ = false;
  std::function<bool(std::size_t)> reveal_ = [](std::size_t) { return true; };
};

}  // namespace slalom
