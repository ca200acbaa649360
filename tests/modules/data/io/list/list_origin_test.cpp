// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "io_sample.h"

#include <slalom/io/scenario_list.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

TEST(ScenarioList, StoresOriginsOfScenarios) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.scenarios";
  {
    ScenarioList list = ScenarioList::create(path);
    list.add(sample_scenario(1), {"maze", 0xffffffffffffffffU, {"narrow", "a/b:1"}});
    list.add_all({sample_scenario(2), sample_scenario(3)}, {{"forest", 3, {}}, {}});
    for (const std::string tag : {"two words", "", "a,b", "quote'"})
      EXPECT_TRUE(throws_error(ErrorKind::Usage, "tag '" + tag + "': ", {"letters"}, [&] {
        list.add(sample_scenario(4), {"", {}, {tag}});
      }));
  }
  const auto entries = ScenarioList::open(path).entries();
  ASSERT_EQ(entries.size(), 3U);
  EXPECT_EQ(entries[0].generator, "maze");
  EXPECT_EQ(entries[0].seed, 0xffffffffffffffffU);
  EXPECT_EQ(entries[0].tags, (std::vector<std::string>{"a/b:1", "narrow"}));
  EXPECT_EQ(entries[1].generator, "forest");
  EXPECT_EQ(entries[1].seed, 3U);
  EXPECT_EQ(entries[2].generator, "");
  EXPECT_FALSE(entries[2].seed.has_value());
}

}  // namespace
}  // namespace slalom
