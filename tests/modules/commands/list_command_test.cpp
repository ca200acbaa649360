#include "io_sample.h"

#include <slalom/commands/list_command.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

TEST(AddScenarios, CanBeTakenBackAndDoneAgain) {
  const TemporaryFolder folder;
  ScenarioList list = ScenarioList::create(folder / "a.scenarios");
  list.add(sample_scenario(1));
  // The first is there already: taking the command back must leave it.
  const auto add = make_add_scenarios(list, {sample_scenario(1), sample_scenario(2)});
  EXPECT_EQ(add->title(), "Add 2 scenarios");
  add->execute();
  EXPECT_EQ(list.size(), 2U);
  add->undo();
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list.entries()[0].hash, sample_scenario(1).hash());
  add->execute();
  EXPECT_EQ(list.size(), 2U);
}

}  // namespace
}  // namespace slalom
