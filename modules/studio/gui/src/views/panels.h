// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "widgets/plot.h"

#include <slalom/studio/studio.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

// The panels of the window and their parts, which read and call the studio and observe its changes.
// Their keys and the parts that scripts can click are described at their classes.

/// The status bar, id "status"; `undo` undoes the last change.
Element* make_status_bar(nanogui::Widget* parent, Studio& studio, std::function<void()> undo);
/// The descriptors of the current scenario and their distribution in the list, id "descriptors".
Element* make_descriptor_panel(nanogui::Widget* parent, Studio& studio);
/// The open lists, id "list".
Element* make_list_panel(nanogui::Widget* parent, Studio& studio);
/// The rows of the active list, id "rows".
Element* make_list_rows(nanogui::Widget* parent, Studio& studio);

/// A plot of the values of descriptors over the active list.
class ListPlot : public Plot {
 public:
  using Plot::Plot;
  /// After a change of the values or of the descriptors.
  virtual void update(const QuantityInfo& x, const QuantityInfo& y) = 0;
};
ListPlot* make_histogram(nanogui::Widget* parent, Studio& studio);     ///< of x; id "histogram"
ListPlot* make_scatter_plot(nanogui::Widget* parent, Studio& studio);  ///< id "scatter"

/// The recorded runs and their replay, id "results".
Element* make_results_panel(nanogui::Widget* parent, Studio& studio);
/// The table of the recorded runs, id "runs".
Element* make_run_table(nanogui::Widget* parent, Studio& studio);
/// Play and pause, speed and time of a replay.
Element* make_replay_bar(nanogui::Widget* parent, ReplayClock& clock, const std::string& id);
/// A series of each visible run over time; the title includes the unit: "speed (m/s)".
Element* make_time_plot(nanogui::Widget* parent, Studio& studio, const std::string& id,
                        const std::string& y_title, std::vector<double> OverlayRun::*values);

}  // namespace slalom
