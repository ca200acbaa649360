// SPDX-License-Identifier: BSD-3-Clause
#include "finish_jobs.h"
#include "list_files.h"

#include <slalom/studio/actions.h>
#include <slalom/studio/studio.h>

#include <filesystem>
#include <fstream>

namespace slalom {
namespace {

/// Searching failures, by a function in place of the other program.
class SearchFailures : public ListFiles {
 protected:
  void SetUp() override {
    add_generate_actions(actions_, studio_);
    std::ofstream(folder_ / "my.ini") << "[campaign]\n";
  }
  StudioServices services() {
    StudioServices services;
    services.search_failures = [this](const StudioServices::SearchRequest& request, Progress&) {
      request_ = request;
      if (!finds_) return std::string("0 failures in 10000 runs");
      std::filesystem::create_directory(request.folder);
      ScenarioList::write(request.folder + "/failures.scenarios",
                          [](ScenarioList& list) { list.add(make_scenario(7)); });
      return std::string("1 failure");
    };
    return services;
  }
  /// Fills in the form of the action with its default values, but another campaign.
  void start(const std::string& campaign) {
    actions_.run("generate.search");
    FormDescription form = studio_.events().take_form();
    FormValues values;
    for (const FormField& field : form.fields) {
      values[field.key] = field.value;
      const bool folders_only = field.extensions == std::vector<std::string>{"/"};
      EXPECT_EQ(folders_only, field.key == "folder") << field.key;
    }
    values["campaign"] = folder_ / campaign;
    values["method"] = "mine";
    form.accepted(values);
    finish_jobs(studio_.jobs());
    studio_.poll();
  }

  bool finds_ = true;
  StudioServices::SearchRequest request_;
  Studio studio_{{}, services(), {}};
  Actions actions_;
};

TEST_F(SearchFailures, OpensTheListOfWhatWasFoundBesideTheActiveOne) {
  studio_.open_list(make_list("a.scenarios", 2));
  start("my.ini");
  EXPECT_EQ(request_.campaign, folder_ / "my.ini");
  EXPECT_EQ(request_.method, "mine");
  EXPECT_EQ(request_.folder, folder_ / "failures");
  EXPECT_EQ(request_.runs, "10000");
  EXPECT_EQ(request_.failures, "10");
  EXPECT_FALSE(request_.all_outcomes);
  EXPECT_TRUE(request_.requires_witness);
  EXPECT_EQ(studio_.active()->path(), folder_ / "failures/failures.scenarios");
  EXPECT_EQ(studio_.current_hash(), hash_of(7));
  EXPECT_EQ(studio_.documents().size(), 2U);
  EXPECT_EQ(studio_.events().take_form().intro, "1 failure");
}

TEST_F(SearchFailures, SaysWhatWasSearchedIfNothingIsFound) {
  studio_.open_list(make_list("a.scenarios", 2));
  finds_ = false;
  start("my.ini");
  EXPECT_EQ(studio_.active()->path(), folder_ / "a.scenarios");
  EXPECT_EQ(studio_.events().take_form().intro, "0 failures in 10000 runs");
}

TEST_F(SearchFailures, RefusesACampaignThatDoesNotExist) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage, folder_ / "no.ini", {"does not exist", ".ini"},
                           [this] { start("no.ini"); }));
}

TEST_F(SearchFailures, IsDisabledInAProgramThatCannotSearch) {
  Studio other({}, {}, {});
  Actions actions;
  add_generate_actions(actions, other);
  EXPECT_EQ(actions.find("generate.search").disabled_reason(),
            "this program does not search failures");
}

}  // namespace
}  // namespace slalom
