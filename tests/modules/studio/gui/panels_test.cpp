// SPDX-License-Identifier: BSD-3-Clause
#include "finish_jobs.h"
#include "list_files.h"
#include "results_sample.h"
#include "views/panels.h"
#include "views/scenario_view.h"
#include "window/script_player.h"

#include <slalom/studio/actions.h>

#include <GLFW/glfw3.h>
#include <map>

namespace slalom {
namespace {

/// Panels of a studio without a window: their texts, parts and keys.
class Panels : public ListFiles {
 protected:
  template <typename Panel>
  static nanogui::ref<Panel> sized(Panel* made) {
    nanogui::ref<Panel> panel = made;
    panel->setSize({900, 600});
    return panel;
  }
  nanogui::ref<ScenarioView> make_view(ScenarioView::Mode mode) {
    return sized(new ScenarioView(nullptr, studio_, mode));
  }
  void finish() {
    finish_jobs(studio_.jobs());
    studio_.poll();
  }
  static bool key(nanogui::Widget& panel, int key) {
    return panel.keyboardEvent(key, 0, GLFW_PRESS, 0);
  }
  static bool shows(const nanogui::Widget& panel, const std::string& text) {
    return shown_text(panel).find(text) != std::string::npos;
  }

  Studio studio_{{}, {}, {}};
};

TEST_F(Panels, OfDescriptorsShowValuesHistogramAndScatterPlot) {
  auto panel = sized(make_descriptor_panel(nullptr, studio_));
  studio_.open_list(make_list("a.scenarios", 8));
  finish();
  EXPECT_TRUE(shows(*panel, "selected density"));
  EXPECT_TRUE(panel->rect_of("row density"));
  key(*panel, GLFW_KEY_TAB);
  finish();
  EXPECT_TRUE(shows(*panel, "histogram of Density")) << shown_text(*panel);
  EXPECT_TRUE(panel->rect_of("current"));
  EXPECT_FALSE(panel->rect_of("row density"));
  key(*panel, GLFW_KEY_TAB);
  finish();
  EXPECT_TRUE(shows(*panel, "Clearness over Density")) << shown_text(*panel);
  EXPECT_TRUE(shows(*panel, "values of the list are missing"));
  key(*panel, GLFW_KEY_LEFT);
  finish();
  EXPECT_FALSE(shows(*panel, "Clearness over Density"));
}

TEST_F(Panels, OfListsShowRowsOrAGridOfPictures) {
  auto rows = sized(make_list_rows(nullptr, studio_));
  rows->setSize({330, 600});
  studio_.open_list(make_list("a.scenarios", 11));
  finish();
  const auto row = [&](int i) { return *rows->rect_of("row " + std::to_string(i)); };
  EXPECT_EQ(row(1).left, 0);
  EXPECT_EQ(row(1).top, 56);
  EXPECT_EQ(row(1).width, 320) << "the scroll bar takes 10";
  studio_.grid() = true;
  // 3 columns in 320 pixels, of at least 104: 106 with pictures of 94 and 20 for the name; 4 rows
  // of 120 need no scroll bar.
  EXPECT_EQ(row(2).left, 220);
  EXPECT_EQ(row(2).width, 110);
  EXPECT_EQ(row(2).height, 120);
  EXPECT_EQ(row(3).left, 0);
  EXPECT_EQ(row(3).top, 120);
  rows->setSize({440, 300});
  EXPECT_NEAR(row(3).left, 3 * 430.0 / 4, 1e-9) << "4 columns, 3 rows and a scroll bar";
  EXPECT_EQ(row(4).left, 0);
  EXPECT_EQ(row(10).bottom(), 300) << "scrolled into view";
}

TEST_F(Panels, OfListsMoveInAGridByKeys) {
  auto rows = sized(make_list_rows(nullptr, studio_));
  rows->setSize({330, 300});
  studio_.open_list(make_list("a.scenarios", 11));
  finish();
  studio_.grid() = true;
  ListDocument& list = *studio_.active();
  list.select_only(0);
  const auto current_after = [&](int pressed) {
    key(*rows, pressed);
    return *list.view().index_of(list.current());
  };
  EXPECT_EQ(current_after(GLFW_KEY_RIGHT), 1U);
  EXPECT_EQ(current_after(GLFW_KEY_DOWN), 4U);
  EXPECT_EQ(current_after(GLFW_KEY_LEFT), 3U);
  EXPECT_EQ(current_after(GLFW_KEY_UP), 0U);
  EXPECT_EQ(current_after(GLFW_KEY_LEFT), 0U);
  EXPECT_EQ(current_after(GLFW_KEY_END), 10U);
  EXPECT_EQ(current_after(GLFW_KEY_RIGHT), 10U);
  EXPECT_EQ(current_after(GLFW_KEY_HOME), 0U);
  EXPECT_EQ(current_after(GLFW_KEY_PAGE_DOWN), 3U) << "2.5 rows are visible: one is a page";
  EXPECT_EQ(list.selected_count(), 1U);
  rows->keyboardEvent(GLFW_KEY_DOWN, 0, GLFW_PRESS, GLFW_MOD_SHIFT);
  EXPECT_EQ(list.selected_count(), 4U) << "3 to 6";
}

TEST_F(Panels, OfListsCloseAndOpenGroupsInAGridOnTheirHeaders) {
  auto rows = sized(make_list_rows(nullptr, studio_));
  studio_.grid() = true;
  studio_.open_list(make_list("a.scenarios", 5));
  finish();
  ListDocument& list = *studio_.active();
  list.create_index("by_density", "density", {0, 0.5, 1});
  list.set_group_by("by_density");
  finish();
  const std::size_t group = *list.lines().group_of(0);
  EXPECT_EQ(rows->rect_of("group " + std::to_string(group))->width, 900);
  list.select_only(0);
  key(*rows, GLFW_KEY_LEFT);  // to the header
  EXPECT_FALSE(list.lines().is_closed(group));
  key(*rows, GLFW_KEY_LEFT);
  EXPECT_TRUE(list.lines().is_closed(group));
  key(*rows, GLFW_KEY_RIGHT);
  EXPECT_FALSE(list.lines().is_closed(group));
  key(*rows, GLFW_KEY_RIGHT);
  EXPECT_TRUE(list.is_selected(0));
}

TEST_F(Panels, OfResultsShowRunsAndTheirReplay) {
  auto panel = sized(make_results_panel(nullptr, studio_));
  EXPECT_TRUE(shows(*panel, "No result file is open."));
  write_overlay_sample(folder_ / "a.results", {{"campaign", "test"}});
  studio_.results().show(overlay_room().hash());
  studio_.results().open(folder_ / "a.results");
  finish();
  EXPECT_TRUE(shows(*panel, "a.results, campaign test"));
  EXPECT_TRUE(shows(*panel, "nd: shown, success")) << shown_text(*panel);
  EXPECT_TRUE(shows(*panel, "time 8.00 of 8.00 s, paused"));
  key(*panel, GLFW_KEY_SPACE);
  EXPECT_TRUE(shows(*panel, "nd: hidden"));
  EXPECT_TRUE(shows(*panel, "of 4.00 s")) << "the longest visible run";
  key(*panel, GLFW_KEY_A);
  EXPECT_TRUE(studio_.results().overlay().trajectories().empty());
  key(*panel, GLFW_KEY_A);
  key(*panel, GLFW_KEY_LEFT);
  EXPECT_TRUE(shows(*panel, "time 7.90 of 8.00 s"));
  EXPECT_TRUE(shows(*panel, "marker 7.900"));
  EXPECT_TRUE(panel->rect_of("row ptg 1"));
}

TEST_F(Panels, OfTheScenarioShowLayersAndTools) {
  auto view = make_view(ScenarioView::Mode::Edit);
  EXPECT_TRUE(shows(*view, "No scenario is selected"));
  studio_.open_list(make_list("a.scenarios", 1));
  finish();
  EXPECT_TRUE(shows(*view, "scenario world_0, continuous"));
  EXPECT_TRUE(shows(*view, "Shortest path: on, 8.00 m")) << shown_text(*view);
  key(*view, GLFW_KEY_1);
  EXPECT_FALSE(view->layer_on("obstacles"));
  key(*view, GLFW_KEY_G);
  EXPECT_TRUE(shows(*view, "tool goal"));
  EXPECT_TRUE(view->rect_of("start"));
  auto look = make_view(ScenarioView::Mode::Look);
  EXPECT_TRUE(view->rect_of("tool disc"));
  EXPECT_FALSE(look->rect_of("tool disc"));
}

/// Every key that the help lists is handled by its panel, and so is not passed on.
TEST_F(Panels, HandleTheKeysOfTheHelp) {
  write_overlay_sample(folder_ / "a.results", {});
  const std::string path = make_list("a.scenarios", 3);
  ScenarioList list = ScenarioList::open(path);
  list.add(overlay_room());
  list.create_index(
      {"by_density", "density", descriptor_view({"density"}, {}).at("density"), {0, 1}});
  studio_.open_list(path);
  studio_.active()->set_group_by("by_density");
  studio_.active()->set_current(overlay_room().hash());
  studio_.results().open(folder_ / "a.results");
  auto rows = sized(make_list_rows(nullptr, studio_));
  auto descriptors = sized(make_descriptor_panel(nullptr, studio_));
  auto view = make_view(ScenarioView::Mode::Edit);
  auto results = sized(make_results_panel(nullptr, studio_));
  const std::map<std::string, nanogui::Widget*> panels = {{"list", rows.get()},
                                                          {"descriptors", descriptors.get()},
                                                          {"view", view.get()},
                                                          {"results", results.get()}};
  finish();
  key(*descriptors, GLFW_KEY_TAB);
  key(*descriptors, GLFW_KEY_TAB);  // the scatter plot has keys for both axes
  std::size_t handled = 0;
  for (const PanelKey& keys : panel_keys()) {
    // Keys of the list go to other scenarios, which have no results.
    studio_.active()->set_current(overlay_room().hash());
    finish();
    for (const std::string& name : keys.keys) {
      // Keys of the panel around the rows need a window: studio_list_test presses them.
      if (keys.panel == "filter" || keys.keys.front() == "F" || keys.keys.front() == "Ctrl+PageUp")
        continue;
      const KeyStroke stroke = key_stroke_of(name);
      studio_.active()->select_all();  // which Escape undoes
      EXPECT_TRUE(panels.at(keys.panel)->keyboardEvent(stroke.key, 0, GLFW_PRESS, stroke.modifiers))
          << name << " in " << keys.panel << ": " << keys.help;
      ++handled;
    }
  }
  EXPECT_GT(handled, 40U);
  EXPECT_FALSE(key(*results, GLFW_KEY_B)) << "one that is not listed";
}

TEST_F(Panels, OfTheStatusShowTheMessageAndTheRunningJob) {
  auto bar = sized(make_status_bar(nullptr, studio_, [] {}));
  studio_.events().show_status("Saved");
  EXPECT_EQ(bar->text(), "Saved");
  EXPECT_FALSE(bar->rect_of("cancel"));
  studio_.jobs().start("wait", "Waiting",
                       [](Progress& progress) -> Jobs::Delivery {
                         progress.start("waiting", 1);
                         while (true) progress.advance(0);  // until it is canceled
                       },
                       {});
  EXPECT_TRUE(shows(*bar, "Waiting"));
  const ScreenRect cancel = *bar->rect_of("cancel");
  bar->mouseButtonEvent({static_cast<int>(cancel.left + 5), static_cast<int>(cancel.top + 5)},
                        GLFW_MOUSE_BUTTON_LEFT, true, 0);
  EXPECT_EQ(bar->text(), "Waiting: canceled");
  finish();
}

}  // namespace
}  // namespace slalom
