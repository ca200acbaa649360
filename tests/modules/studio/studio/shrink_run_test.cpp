// SPDX-License-Identifier: BSD-3-Clause
#include "finish_jobs.h"
#include "list_files.h"
#include "results_sample.h"

#include <slalom/studio/actions.h>
#include <slalom/studio/studio.h>

#include <atomic>
#include <filesystem>

namespace slalom {
namespace {

/// Shrinking of the runs of overlay_room(), by a function in place of the other program.
class ShrinkRun : public ListFiles {
 protected:
  void SetUp() override {
    add_generate_actions(actions_, studio_);
    ScenarioList::write(list_, [](ScenarioList& list) {
      list.add(overlay_room());
      list.add(make_scenario(1));
    });
    write_overlay_sample(folder_ / "a.results", {});
    studio_.results().show(overlay_room().hash());
    studio_.results().open(folder_ / "a.results");
    finish();
  }
  StudioServices services() {
    StudioServices services;
    services.shrink_run = [this](const StudioServices::ShrinkRequest& request, Progress& progress) {
      request_ = request;
      if (endless_) wait_for_cancel(progress);
      std::filesystem::create_directory(request.folder);
      ScenarioList::write(request.folder + "/failures.scenarios", [](ScenarioList& list) {
        list.add(make_scenario(7), {"", std::nullopt, {"stuck"}});
      });
      return std::string("1 -> 1 obstacles");
    };
    return services;
  }
  void wait_for_cancel(Progress& progress) {
    began_ = true;
    try {
      while (true) progress.advance(0);
    } catch (const JobCanceled&) {
      canceled_ = true;
      throw;
    }
  }
  void select(const std::string& label) {
    const auto& runs = studio_.results().overlay().runs();
    for (std::size_t run = 0; run < runs.size(); ++run)
      if (overlay_label(runs[run].record) == label) studio_.results().overlay().select(run);
  }
  /// Fills in the form of the action with its default values, but another folder.
  void start(const std::string& folder) {
    actions_.run("generate.shrink");
    FormDescription form = studio_.events().take_form();
    FormValues values;
    for (const FormField& field : form.fields) {
      values[field.key] = field.value;
      const bool folders_only = field.extensions == std::vector<std::string>{"/"};
      EXPECT_EQ(folders_only, field.key == "folder") << field.key;
    }
    EXPECT_EQ(values["folder"], folder_ / ("shrunk_" + id_of("ptg", 1)));
    values["folder"] = folder_ / folder;
    form.accepted(values);
  }
  static std::string id_of(const std::string& method, int repetition) {
    return overlay_room().hash().substr(0, 8) + "_" + method + "_" + std::to_string(repetition);
  }
  void finish() {
    finish_jobs(studio_.jobs());
    studio_.poll();
  }
  std::string disabled_reason() const { return actions_.find("generate.shrink").disabled_reason(); }

  bool endless_ = false;
  std::atomic<bool> began_ = false, canceled_ = false;
  StudioServices::ShrinkRequest request_;
  std::string list_ = folder_ / "a.scenarios";
  Studio studio_{{}, services(), {}};
  Actions actions_;
};

TEST_F(ShrinkRun, AddsWhatWasFoundToTheListAndCanBeUndone) {
  studio_.open_list(list_);
  select("ptg 1");
  EXPECT_EQ(disabled_reason(), "");
  start("small");
  finish();
  EXPECT_EQ(request_.results, folder_ / "a.results");
  EXPECT_EQ(request_.run, overlay_room().hash().substr(0, 8) + "/ptg/1");
  EXPECT_EQ(request_.max_runs, "5000");
  EXPECT_TRUE(request_.requires_witness);
  EXPECT_EQ(studio_.current_hash(), hash_of(7));
  EXPECT_EQ(studio_.current_entry()->tags, std::vector<std::string>{"stuck"});
  EXPECT_EQ(studio_.events().take_form().intro, "1 -> 1 obstacles");
  studio_.undo();
  EXPECT_EQ(studio_.active()->list().size(), 2U);
  studio_.redo();
  EXPECT_EQ(studio_.active()->list().size(), 3U);
}

TEST_F(ShrinkRun, SaysSoIfTheListHasTheSmallestScenarioAlready) {
  studio_.open_list(list_);
  select("ptg 1");
  start("small");
  finish();
  studio_.events().take_form();
  studio_.active()->set_current(overlay_room().hash());
  finish();
  select("ptg 1");
  start("again");
  finish();
  EXPECT_EQ(studio_.active()->list().size(), 3U);
  EXPECT_EQ(studio_.events().status().text, "0 scenarios added to " + list_);
}

TEST_F(ShrinkRun, EndsItsWorkWhenItIsCanceled) {
  studio_.open_list(list_);
  select("ptg 1");
  endless_ = true;
  start("small");
  EXPECT_EQ(disabled_reason(), "scenarios are being generated, imported, searched or shrunk");
  wait_until([this] { return began_.load(); });
  studio_.jobs().cancel("make");
  finish();
  EXPECT_TRUE(canceled_);
  EXPECT_EQ(studio_.active()->list().size(), 2U);
  EXPECT_FALSE(studio_.events().has_form());
}

TEST_F(ShrinkRun, DoesNotWriteIntoAFolderThatExists) {
  studio_.open_list(list_);
  select("ptg 1");
  std::filesystem::create_directory(folder_ / "small");
  EXPECT_TRUE(throws_error(ErrorKind::Usage, folder_ / "small", {"already exists", "new folder"},
                           [this] { start("small"); }));
}

TEST_F(ShrinkRun, IsDisabledWithoutARunThatFailed) {
  EXPECT_EQ(disabled_reason(), "no run of a result file is selected");
  select("ptg 0");
  EXPECT_EQ(disabled_reason(), "the robot reached the goal in this run");
  select("ptg 1");
  EXPECT_EQ(disabled_reason(), "no list is open");
  studio_.open_list(make_list("b.scenarios", 1));  // its scenario has no runs
  finish();
  EXPECT_EQ(disabled_reason(), "no run of a result file is selected");
}

}  // namespace
}  // namespace slalom
