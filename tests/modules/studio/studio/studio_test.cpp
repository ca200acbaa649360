// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "finish_jobs.h"
#include "list_files.h"
#include "results_sample.h"

#include <slalom/studio/actions.h>
#include <slalom/studio/studio.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace slalom {
namespace {

/// The studio without a window.
class StudioWithoutWindow : public ListFiles {
 protected:
  void SetUp() override {
    for (const Change change :
         {Change::Documents, Change::View, Change::Current, Change::Scene, Change::Descriptors,
          Change::ListValues, Change::Runs, Change::Form})
      studio_.events().observe({change}, [this, change] { changes_.push_back(change); });
    add_file_actions(actions_, studio_);
    add_import_export_actions(actions_, studio_);
    add_recent_actions(actions_, studio_);
    add_edit_actions(actions_, studio_);
    add_list_actions(actions_, studio_);
    add_generate_actions(actions_, studio_);
    add_help_actions(actions_, studio_);
  }
  void finish() {
    finish_jobs(studio_.jobs());
    studio_.poll();
  }
  bool published(Change change) const {
    return std::find(changes_.begin(), changes_.end(), change) != changes_.end();
  }

  Studio studio_{{}, {}, {}};
  Actions actions_;
  std::vector<Change> changes_;
};

TEST_F(StudioWithoutWindow, PublishesWhatBelongsToTheCurrentScenario) {
  studio_.open_list(make_list("a.scenarios", 3));
  EXPECT_TRUE(published(Change::Documents));
  EXPECT_TRUE(published(Change::Current));
  EXPECT_EQ(studio_.current_hash(), hash_of(0));
  finish();
  EXPECT_TRUE(published(Change::Scene));
  EXPECT_TRUE(published(Change::Descriptors));
  ASSERT_TRUE(studio_.scenes().scene());
  EXPECT_TRUE(studio_.scenes().scene()->complete());
  EXPECT_EQ(studio_.descriptors().model().hash(), hash_of(0));
  EXPECT_EQ(studio_.events().status().text, "a.scenarios: 3 scenarios");
  studio_.close_list(0);
  EXPECT_FALSE(studio_.scenes().scene());
  EXPECT_EQ(studio_.active(), nullptr);
}

TEST_F(StudioWithoutWindow, OpensListsAndResultsAgain) {
  const auto recent = [this] {
    std::vector<std::string> labels;
    for (const Action* action : actions_.matching("file .")) labels.push_back(action->label());
    return labels;
  };
  const std::size_t others = recent().size();  // "New list..."
  const std::string list = make_list("a.scenarios", 3), results = folder_ / "a.results";
  write_overlay_sample(results, {});
  studio_.open_list(list);
  studio_.results().open(results);
  finish();
  EXPECT_EQ(recent().size(), others + 2);
  EXPECT_EQ(studio_.recent()[0], results);
  EXPECT_EQ(studio_.recent()[1], list);
  studio_.close_list(0);
  studio_.results().close();
  actions_.run("file.recent_2");
  EXPECT_EQ(studio_.active()->path(), list);
  EXPECT_EQ(studio_.recent()[0], list) << "the latest";
  actions_.run("file.recent_2");
  finish();
  EXPECT_EQ(studio_.results().path(), results);
  const std::string label = actions_.find("file.recent_1").label();
  EXPECT_LE(label.size(), 39U) << "for a menu";
  EXPECT_EQ(label.substr(label.size() - 10), "/a.results");
  std::filesystem::remove(results);
  EXPECT_EQ(actions_.find("file.recent_1").disabled_reason(), label + " does not exist");
}

TEST_F(StudioWithoutWindow, ReadsTheShownValuesAgainWhenTheListChanges) {
  studio_.open_list(make_list("a.scenarios", 9));
  studio_.track_descriptors({"density"});
  finish();
  ASSERT_TRUE(studio_.descriptors().list_values());
  EXPECT_EQ(studio_.descriptors().list_values()->size(), 9U);
  studio_.filter_range("density", 0.2, 0.5);
  finish();
  EXPECT_EQ(studio_.active()->filter_text(), "0.2 <= density < 0.5");
  EXPECT_EQ(studio_.descriptors().list_values()->size(), 3U);
  studio_.track_descriptors({});
  EXPECT_FALSE(studio_.descriptors().list_values());
}

TEST_F(StudioWithoutWindow, AsksForFormsAndRunsThem) {
  actions_.run("file.new");
  ASSERT_TRUE(published(Change::Form));
  FormDescription form = studio_.events().take_form();
  EXPECT_EQ(form.title, "New list");
  form.accepted({{"file", folder_ / "new.scenarios"}});
  ASSERT_NE(studio_.active(), nullptr);
  EXPECT_EQ(studio_.active()->title(), "new.scenarios");
  EXPECT_FALSE(studio_.events().has_form());
  EXPECT_THROW(actions_.run("edit.undo"), Error);
}

TEST_F(StudioWithoutWindow, ReportsErrorsInTheStatusLineAndInAForm) {
  studio_.results().open(folder_ / "none.results");
  finish();
  EXPECT_TRUE(studio_.events().status().is_error);
  EXPECT_TRUE(mentions(studio_.events().take_form().intro, {"none.results"}));
}

TEST_F(StudioWithoutWindow, UndoesAnEditAndSaysWhat) {
  studio_.open_list(make_list("a.scenarios", 2));
  const Scenario before = make_scenario(0);
  studio_.edit_current({with_goal(before, {8, 2}), "Move goal"});
  EXPECT_EQ(studio_.events().status().text, "Move goal");
  EXPECT_NE(studio_.current_hash(), before.hash());
  studio_.undo();
  EXPECT_EQ(studio_.current_hash(), before.hash());
  EXPECT_TRUE(mentions(studio_.events().status().text, {"Undone: "}));
}

TEST_F(StudioWithoutWindow, RestoresWhatAnEarlierSessionDeleted) {
  const std::string path = make_list("a.scenarios", 6);
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "Restore deleted...", {"no list is open"},
                           [&] { actions_.run("edit.restore"); }));
  studio_.open_list(path);
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "Restore deleted...", {"no deleted scenarios"},
                           [&] { actions_.run("edit.restore"); }));
  for (const std::vector<std::string>& deletion :
       {std::vector{hash_of(1)}, {hash_of(3), hash_of(4)}}) {
    studio_.active()->select(deletion);
    studio_.active()->remove_selected();
  }
  studio_.close_list(0);
  studio_.open_list(path);
  actions_.run("edit.restore");
  FormDescription form = studio_.events().take_form();
  const std::string one = "world_1 (" + hash_of(1).substr(0, 12) + ")";
  const std::string two = "world_3 (" + hash_of(3).substr(0, 12) + ") and 1 more";
  ASSERT_EQ(form.fields.size(), 1U);
  EXPECT_EQ(form.fields[0].choices, (std::vector<std::string>{two, one, "all (3)"}));
  form.accepted({{"scenarios", two}});
  EXPECT_EQ(studio_.events().status().text, "Restore 2 scenarios");
  EXPECT_EQ(studio_.active()->view().total, 5U);
  EXPECT_EQ(studio_.current_hash(), hash_of(3));
  actions_.run("edit.undo");
  form.accepted({{"scenarios", "all (3)"}});
  EXPECT_EQ(studio_.active()->view().total, 6U);
  EXPECT_NE(actions_.find("edit.restore").disabled_reason(), "");
}

TEST_F(StudioWithoutWindow, SaysThatACommaDividesTheNamesOfImportedFiles) {
  const std::string file = folder_ / "hall, upper.pgm";
  std::ofstream(file) << "P5";
  open_files(studio_, {file});
  const FormDescription form = studio_.events().take_form();
  EXPECT_TRUE(throws_error(ErrorKind::Usage, folder_ / "hall: does not exist",
                           {"a comma in the name of a file divides it"}, [&] {
                             form.accepted({{"files", file}});
                           }));
  const std::string one = error_text(ErrorKind::Usage, [&] {
    form.accepted({{"files", "none.pgm"}});
  });
  EXPECT_TRUE(mentions(one, {"none.pgm: does not exist"}));
  EXPECT_EQ(one.find("comma"), std::string::npos) << one;
}

TEST(StudioExport, ShowsWhatTheFormatCannotHold) {
  StudioServices services;
  services.export_formats = {{"ros", ".yaml", "map"}};
  std::string left_out = "scenario room: 2 moving obstacles left out";
  services.export_scenario = [&left_out](const Scenario&, const std::string&, double,
                                         const std::string&) { return left_out; };
  Studio studio({}, services, {});
  Actions actions;
  add_import_export_actions(actions, studio);
  const TemporaryFolder folder;
  ScenarioList::create(folder / "a.scenarios")
      .add(Scenario::continuous("room", {0, 0, 4, 4}, {}, {1, 1, 0}, {3, 3}));
  studio.open_list(folder / "a.scenarios");
  const auto messages_of_export = [&] {
    actions.run("file.export");
    const FormModel form(studio.events().take_form());
    form.description().accepted(form.values());
    finish_jobs(studio.jobs());
    std::vector<std::string> messages;
    while (studio.events().has_form()) messages.push_back(studio.events().take_form().intro);
    return messages;
  };
  EXPECT_EQ(messages_of_export(), std::vector<std::string>{left_out});
  left_out.clear();
  EXPECT_TRUE(messages_of_export().empty());
}

}  // namespace
}  // namespace slalom
