// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "finish_jobs.h"
#include "forms/requests.h"
#include "io_sample.h"
#include "list_sample.h"

#include <slalom/commands/list_command.h>
#include <slalom/studio/jobs.h>

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>

namespace slalom {
namespace {

/// The values of a form with some fields filled in.
FormValues filled(const FormDescription& form, const FormValues& input) {
  FormModel model(form);
  for (const auto& [key, text] : input) model.set_value(model.index_of(key), text);
  EXPECT_EQ(model.first_error(), std::nullopt) << model.first_error()->second;
  return model.values();
}

FormValues random_values(const FormValues& typed) {
  return filled(random_generation_form({}), typed);
}

FormValues bins_values(FormValues typed) {
  const FormValues small = {{"families", "random"}, {"bins", "2"},
                            {"per_bin", "1"},       {"min_extent", "5"},
                            {"max_extent", "6"},    {"budget_evaluations", "96"},
                            {"resolution", "0.1"}};
  typed.insert(small.begin(), small.end());
  return filled(bins_generation_form({}), typed);
}

/// Cancels the work after `max_done` steps.
class CancelingProgress : public Progress {
 public:
  explicit CancelingProgress(std::size_t max_done) : max_done_(max_done) {}
  void start(const std::string&, std::size_t) override {}
  void advance(std::size_t done) override {
    ++reports;
    if (done >= max_done_) throw JobCanceled();
  }
  void finish() override {}

  std::atomic<int> reports = 0;

 private:
  std::size_t max_done_;
};

TEST(GenerationForm, HidesTheOptionsOfWalkersUntilTheyAreWanted) {
  FormModel form(random_generation_form({}));
  const auto shown = [&form](const std::string& key) { return form.is_shown(form.index_of(key)); };
  EXPECT_TRUE(shown("moving"));
  const std::vector<std::string> keys = {"walkers", "walker_min_radius", "walker_max_radius",
                                         "walker_min_speed", "walker_max_speed"};
  for (const std::string& key : keys) EXPECT_FALSE(shown(key)) << key;
  EXPECT_FALSE(read_random_generation(form.values()).ini.get("scenarios", "walkers"));
  form.choose(form.index_of("moving"), "");
  for (const std::string& key : keys) EXPECT_TRUE(shown(key)) << key;
  form.set_value(form.index_of("walker_max_speed"), "2");
  const IniFile ini = read_random_generation(form.values()).ini;
  EXPECT_EQ(ini.get("scenarios", "walkers"), "4");
  EXPECT_EQ(ini.get("scenarios", "walker_max_speed"), "2");
  EXPECT_FALSE(ini.get("scenarios", "walker_min_speed")) << "as the program's default";
}

TEST(GenerationForm, HidesTheOptionsOfPeopleUntilTheyAreWanted) {
  FormModel form(random_generation_form({}));
  const auto shown = [&form](const std::string& key) { return form.is_shown(form.index_of(key)); };
  EXPECT_TRUE(shown("reacting"));
  const std::vector<std::string> keys = {"people", "person_min_radius", "person_max_radius",
                                         "person_min_speed", "person_max_speed"};
  for (const std::string& key : keys) EXPECT_FALSE(shown(key)) << key;
  EXPECT_FALSE(read_random_generation(form.values()).ini.get("scenarios", "people"));
  form.choose(form.index_of("reacting"), "");
  for (const std::string& key : keys) EXPECT_TRUE(shown(key)) << key;
  EXPECT_FALSE(shown("walkers"));
  form.set_value(form.index_of("person_max_speed"), "2");
  const IniFile ini = read_random_generation(form.values()).ini;
  EXPECT_EQ(ini.get("scenarios", "people"), "4");
  EXPECT_EQ(ini.get("scenarios", "person_max_speed"), "2");
  EXPECT_FALSE(ini.get("scenarios", "walkers"));
}

TEST(GenerationForm, IsValidInitially) {
  EXPECT_EQ(FormModel(random_generation_form({})).first_error(), std::nullopt);
  EXPECT_EQ(FormModel(bins_generation_form({})).first_error(), std::nullopt);
}

TEST(GenerationForm, ShowsOnlyTheOptionsOfTheChosenFamilies) {
  FormModel model(random_generation_form({}));
  EXPECT_TRUE(model.is_shown(model.index_of("random.polygon_fraction")));
  EXPECT_FALSE(model.is_shown(model.index_of("maze.loop_fraction")));
  model.choose(model.index_of("families"), "maze");
  const std::size_t loops = model.index_of("maze.loop_fraction");
  EXPECT_TRUE(model.is_shown(loops));
  model.set_value(loops, "2");
  EXPECT_NE(model.error_of(loops).find("in [0, 1]"), std::string::npos) << model.error_of(loops);
}

TEST(GenerationRequest, WritesOnlyChangedValuesToTheIni) {
  const GenerationRequest request = read_random_generation(
      random_values({{"families", "maze"}, {"count", "3"}, {"seed", "7"}, {"maze.columns", "5"}}));
  EXPECT_EQ(request.order.seed, 7U);
  EXPECT_EQ(request.ini.get("scenarios", "generator"), "maze");
  EXPECT_EQ(request.ini.get("generator.maze", "columns"), "5");
  EXPECT_EQ(request.ini.get("generator.maze", "rows"), std::nullopt);
  EXPECT_FALSE(request.ini.has_section("generator.random"));
}

TEST(GenerationRequest, MakesTheSameListAsTheSameIni) {
  const TemporaryFolder folder;
  FormValues typed = {{"families", "random, maze"},
                      {"count", "4"},
                      {"seed", "7"},
                      {"maze.columns", "5"},
                      {"maze.rows", "5"},
                      {"target", "a new list"},
                      {"file", folder / "a.scenarios"},
                      {"representation", "grid"}};
  const GenerationRequest request = read_random_generation(random_values(typed));
  const auto silent = make_silent_progress();
  const NewList made = generate(request, {}, *silent);
  EXPECT_EQ(made.size, 4U);
  EXPECT_EQ(made.staging, nullptr);
  const IniFile ini = IniFile::from_text(
      "[scenarios]\ngenerator = random, maze\ncount = 4\nrepresentation = grid\nresolution = 0.05\n"
      "[generator.maze]\ncolumns = 5\nrows = 5\n"
      "[robot]\nradius = 0.25\n[simulation]\nresolution = 0.05\n");
  ScenarioList::write(folder / "b.scenarios", [&](ScenarioList& list) {
    generate_list(list, ini, {7, 1, {}}, {}, *silent);
  });
  EXPECT_EQ(dump_list(folder / "a.scenarios"), dump_list(folder / "b.scenarios"));
}

TEST(GenerationRequest, FillsBinsInAStagingListWithAReport) {
  const TemporaryFolder folder;
  const GenerationRequest request = read_bins_generation(
      bins_values({{"descriptors", "density"}, {"edges.density", "0, 0.1, 0.3"}}));
  const auto silent = make_silent_progress();
  const NewList made = generate(request, {}, *silent);
  ASSERT_NE(made.staging, nullptr);
  ASSERT_GT(made.size, 0U);
  EXPECT_NE(made.report.find("density 0.1 to 0.3: 1 of 1, full"), std::string::npos) << made.report;

  ScenarioList list = ScenarioList::create(folder / "a.scenarios");
  const std::string before = dump_list(list.path());
  CancelingProgress canceling(1);
  EXPECT_THROW(add_to_list(list.path(), made, canceling), JobCanceled);
  EXPECT_EQ(dump_list(list.path()), before);
  AddedScenarios added = add_to_list(list.path(), made, *silent);
  EXPECT_EQ(added.count, made.size);
  CommandHistory history;
  history.execute(std::move(added.command));
  EXPECT_EQ(list.size(), made.size);
  const ScenarioList::Entry entry = list.entries().front();
  EXPECT_EQ(entry.hash, added.first);
  EXPECT_EQ(entry.generator, "coverage");
  EXPECT_EQ(entry.tags.front().substr(0, 4), "bin_");
  EXPECT_TRUE(list.find(entry.hash, {"density", 1, ""}).has_value() ||
              list.find(entry.hash, {"density", 1, "resolution=0.1"}).has_value());
  const std::string after = dump_list(list.path());
  history.undo();
  EXPECT_EQ(dump_list(list.path()), before);
  history.redo();
  EXPECT_EQ(dump_list(list.path()), after);
}

TEST(GenerationRequest, ReportsSectionAndKeyOfAContradiction) {
  const std::string text = error_text(ErrorKind::Usage, [] {
    read_random_generation(
        random_values({{"random.min_obstacles", "50"}, {"random.max_obstacles", "40"}}));
  });
  EXPECT_NE(text.find("[generator.random] max_obstacles"), std::string::npos) << text;
  EXPECT_NE(text.find("expected"), std::string::npos) << text;
  const std::string bins = error_text(ErrorKind::Usage, [] {
    read_bins_generation(bins_values({{"edges.density", "0.3, 0.1"}}));
  });
  EXPECT_NE(bins.find("[coverage] edges.density"), std::string::npos) << bins;
  const std::string map = error_text(ErrorKind::Usage, [] {
    read_random_generation(random_values({{"families", "crop"}}));
  });
  EXPECT_NE(map.find("[generator.crop] map"), std::string::npos) << map;
}

TEST(GenerationRequest, ChecksFamiliesOnMapsWithoutReadingTheMap) {
  EXPECT_NO_THROW(read_random_generation(
      random_values({{"families", "crop"}, {"crop.map", "/there/is/none.gridmap"}})));
}

TEST(GenerationRequest, RefusesAnExistingFile) {
  const TemporaryFolder folder;
  ScenarioList::create(folder / "a.scenarios");
  const std::string text = error_text(ErrorKind::Usage, [&] {
    read_random_generation(
        random_values({{"target", "a new list"}, {"file", folder / "a.scenarios"}}));
  });
  EXPECT_TRUE(mentions(text, {folder / "a.scenarios", "already", "exists"}));
}

TEST(GenerationRequest, LeavesNothingBehindWhenItIsCancelled) {
  const TemporaryFolder folder;
  GenerationRequest request = read_random_generation(random_values(
      {{"count", "100"}, {"target", "a new list"}, {"file", folder / "a.scenarios"}}));
  request.order.jobs = 3;
  CancelingProgress progress(5);
  EXPECT_THROW(generate(request, {}, progress), JobCanceled);
  EXPECT_LT(progress.reports, 20) << "it ends soon after the cancellation";
  EXPECT_TRUE(std::filesystem::is_empty(folder / "")) << "neither the list nor part of it";
  CancelingProgress bins(0);
  EXPECT_THROW(generate(read_bins_generation(bins_values({})), {}, bins), JobCanceled);
}

TEST(GenerationRequest, RunsAsAJobThatIsCancelled) {
  Jobs jobs;
  std::atomic<bool> delivered = false, failed = false;
  GenerationRequest request = read_random_generation(random_values({{"count", "100000"}}));
  jobs.start(
      "make", "Generate",
      [&, request](Progress& progress) -> Jobs::Delivery {
        generate(request, {}, progress);
        return [&] { delivered = true; };
      },
      [&](const std::string&) { failed = true; });
  wait_until([&] {
    const auto status = jobs.status();
    return status.empty() || status.front().done > 0;
  });
  ASSERT_FALSE(jobs.status().empty()) << "cannot be finished yet";
  EXPECT_EQ(jobs.status().front().total, 100000U);
  jobs.cancel("make");
  finish_jobs(jobs);
  EXPECT_FALSE(delivered);
  EXPECT_FALSE(failed);
}

}  // namespace
}  // namespace slalom
