// SPDX-License-Identifier: BSD-3-Clause
#include "compression.h"
#include "error_text.h"
#include "io_sample.h"

#include <slalom/core/error.h>
#include <slalom/core/read_file.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_list.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

constexpr Representation kAll[] = {Representation::Continuous, Representation::Grid,
                                   Representation::Points};

testing::AssertionResult refused_as_damaged(const std::string& bytes) {
  return throws_error(ErrorKind::File, "source", {},
                      [&] { deserialize_scenario(bytes, "source"); });
}

TEST(ScenarioCodec, RestoresEveryRepresentationWithItsHash) {
  for (const Representation representation : kAll) {
    const Scenario scenario = sample_as(representation);
    const Scenario back = deserialize_scenario(serialize(scenario), "test");
    EXPECT_EQ(back.hash(), scenario.hash()) << to_string(representation);
    EXPECT_EQ(back.name(), scenario.name());
    EXPECT_EQ(serialize(back), serialize(scenario));
  }
}

TEST(ScenarioCodec, RestoresPublishedPathsAndRejectsTruncatedBytes) {
  for (const Representation representation : kAll) {
    const Scenario scenario = sample_with_path(representation);
    const std::string bytes = serialize(scenario);
    const Scenario back = deserialize_scenario(bytes, "test");
    ASSERT_NE(back.published_path(), nullptr);
    EXPECT_EQ(*back.published_path(), *scenario.published_path());
    EXPECT_EQ(back.hash(), sample_as(representation).hash());
    EXPECT_NE(bytes, serialize(sample_as(representation)));
    for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 300)
      EXPECT_TRUE(refused_as_damaged(bytes.substr(0, size)));
  }
}

TEST(ScenarioCodec, RestoresMoversAndRejectsTruncatedBytes) {
  for (const Representation representation : kAll)
    for (const Scenario& still : {sample_as(representation), sample_with_path(representation)}) {
      const Scenario scenario = still.with_movers(sample_movers());
      const std::string bytes = serialize(scenario);
      const Scenario back = deserialize_scenario(bytes, "test");
      EXPECT_EQ(back.movers(), scenario.movers());
      EXPECT_EQ(back.hash(), scenario.hash());
      EXPECT_EQ(back.published_path() != nullptr, still.published_path() != nullptr);
      EXPECT_EQ(serialize(back), bytes);
      EXPECT_EQ(serialize(back.with_movers({})), serialize(still));
      for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 300)
        EXPECT_TRUE(refused_as_damaged(bytes.substr(0, size)));
    }
}

TEST(ScenarioCodec, RestoresPeopleAndRejectsDamagedBytes) {
  const Scenario path = sample_with_path(Representation::Grid);
  for (const Scenario& empty : {sample_scenario(1), path, path.with_goal_heading(0.1 + 0.2),
                                sample_scenario(1).with_movers(sample_movers())}) {
    const Scenario scenario = empty.with_people(sample_people());
    const std::string bytes = serialize(scenario);
    const Scenario back = deserialize_scenario(bytes, "test");
    EXPECT_EQ(back.people(), sample_people());
    EXPECT_EQ(back.hash(), scenario.hash());
    EXPECT_NE(back.hash(), empty.hash());
    EXPECT_EQ(serialize(back), bytes);
    EXPECT_EQ(serialize(back.with_people({})), serialize(empty));
    for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 300)
      EXPECT_TRUE(refused_as_damaged(bytes.substr(0, size)));
  }
}

TEST(ScenarioCodec, RefusesHostilePeople) {
  const std::string content =
      decompress(serialize(sample_scenario(1).with_people(sample_people())), "test");
  const std::size_t id = content.find("anna # 1");
  ASSERT_NE(id, std::string::npos);
  const auto changed = [&](std::size_t at, char byte) {
    std::string bytes = content;
    bytes[at] = byte;
    return throws_error(ErrorKind::File, "test", {},
                        [&] { deserialize_scenario(compress(bytes), "test"); });
  };
  const std::size_t numbers = id + std::string("anna # 1").size();
  EXPECT_TRUE(changed(id - 9, '\x7f')) << "more people than bytes";
  EXPECT_TRUE(changed(id - 1, '\x7f')) << "an id longer than the file";
  EXPECT_TRUE(changed(numbers + 24, 3)) << "an unknown end of the route";
  EXPECT_TRUE(changed(content.size() - 1, 2)) << "an unknown flag";
}

TEST(ScenarioCodec, WritesScenariosWithoutMoversAsBefore) {
  // The first byte of the content is the version: 1, or 2 with a published path.
  EXPECT_EQ(decompress(serialize(sample_scenario(1)), "test")[0], 1);
  EXPECT_EQ(decompress(serialize(sample_with_path(Representation::Points)), "test")[0], 2);
  EXPECT_EQ(decompress(serialize(sample_scenario(1).with_movers(sample_movers())), "test")[0], 3);
  EXPECT_EQ(decompress(serialize(sample_scenario(1).with_goal_heading(1)), "test")[0], 4);
  EXPECT_EQ(decompress(serialize(sample_scenario(1).with_people(sample_people())), "test")[0], 5);
}

TEST(ScenarioCodec, RejectsTruncatedAndCorruptedBytes) {
  for (const Representation representation : kAll) {
    const std::string bytes = serialize(sample_as(representation));
    for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 300)
      EXPECT_TRUE(refused_as_damaged(bytes.substr(0, size)));
    RandomEngine engine(2);
    for (int trial = 0; trial < 300; ++trial) {
      std::string changed = bytes;
      changed[static_cast<std::size_t>(
          uniform_int(engine, 0, static_cast<int>(bytes.size()) - 1))] ^=
          static_cast<char>(1 << uniform_int(engine, 0, 7));
      // A flipped bit may be irrelevant; then the content must be unchanged.
      try {
        EXPECT_EQ(serialize(deserialize_scenario(changed, "t")), bytes);
      } catch (const Error& e) {
        EXPECT_EQ(e.exit_status(), 3);
      }
    }
  }
}

TEST(ScenarioList, StoresScenariosInOrder) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.scenarios";
  {
    ScenarioList list = ScenarioList::create(path);
    list.add_all({sample_scenario(3, "third"), sample_scenario(1, "first")});
    EXPECT_TRUE(list.add(sample_as(Representation::Grid)));
    EXPECT_FALSE(list.add(sample_scenario(3, "same content, other name")));
    list.set_note("origin", "a test");
  }
  const ScenarioList list = ScenarioList::open(path);
  ASSERT_EQ(list.size(), 3U);
  const auto entries = list.entries();
  EXPECT_EQ(entries[0].name, "third");
  EXPECT_EQ(entries[1].name, "first");
  EXPECT_EQ(entries[2].representation, Representation::Grid);
  EXPECT_EQ(entries[0].id, entries[0].hash.substr(0, 12));
  EXPECT_EQ(list.read(entries[1].hash).hash(), sample_scenario(1).hash());
  EXPECT_EQ(list.note("origin"), "a test");
  EXPECT_FALSE(list.note("nothing").has_value());
}

TEST(ScenarioList, FindsEntriesByIdHashPrefixAndName) {
  const TemporaryFolder folder;
  ScenarioList list = ScenarioList::create(folder / "a.scenarios");
  list.add_all({sample_scenario(1, "one"), sample_scenario(2, "two")});
  const auto one = list.entries()[0];
  EXPECT_EQ(list.find_entry(one.id).name, "one");
  EXPECT_EQ(list.find_entry(one.hash).name, "one");
  EXPECT_EQ(list.find_entry("two").name, "two");
  for (const std::string name : {"three", ""})
    EXPECT_TRUE(throws_error(ErrorKind::Usage, list.path(), {"'" + name + "'"},
                             [&] { list.find_entry(name); }));
}

TEST(ScenarioList, RemovesScenarios) {
  const TemporaryFolder folder;
  ScenarioList list = ScenarioList::create(folder / "a.scenarios");
  list.add(sample_scenario(1));
  EXPECT_TRUE(list.remove(sample_scenario(1).hash()));
  EXPECT_FALSE(list.remove(sample_scenario(1).hash()));
  EXPECT_EQ(list.size(), 0U);
}

TEST(ScenarioList, StoresDescriptorValues) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.scenarios";
  {
    ScenarioList list = ScenarioList::create(path);
    list.store_value("h", {{"density", 1, ""}, Value::of(0.1 + 0.2)});
    list.store_value("h", {{"confinement", 1, "sensor_range=8"}, Value::of(0.5, 0.004)});
    list.store_value("h", {{"detour_ratio", 2, "robot_radius=0.25"}, Value::na("no path")});
  }
  ScenarioList list = ScenarioList::open(path);
  EXPECT_EQ(list.find("h", {"density", 1, ""}), Value::of(0.1 + 0.2));
  EXPECT_EQ(list.find("h", {"confinement", 1, "sensor_range=8"}), Value::of(0.5, 0.004));
  EXPECT_EQ(list.find("h", {"detour_ratio", 2, "robot_radius=0.25"}), Value::na("no path"));
  EXPECT_FALSE(list.find("h", {"density", 2, ""}).has_value());
  EXPECT_FALSE(list.find("h", {"density", 1, "x"}).has_value());
}

TEST(ScenarioList, RejectsFilesThatAreNotLists) {
  const TemporaryFolder folder;
  const auto refused = [](const std::string& path) {
    return throws_error(ErrorKind::File, path, {"scenario list"},
                        [&] { ScenarioList::open(path); });
  };
  EXPECT_TRUE(refused(folder / "missing"));
  write_file_atomically(folder / "text", "not a database, but long enough to have a header");
  EXPECT_TRUE(refused(folder / "text"));
  ResultFile::create(folder / "a.results", {}, {}, {});
  EXPECT_TRUE(refused(folder / "a.results"));
  EXPECT_TRUE(throws_error(ErrorKind::Job, "/nonexistent/a.scenarios", {},
                           [] { ScenarioList::create("/nonexistent/a.scenarios"); }));
}

TEST(ScenarioList, RejectsTruncatedFiles) {
  const TemporaryFolder folder;
  {
    ScenarioList list = ScenarioList::create(folder / "a.scenarios");
    for (int i = 0; i < 40; ++i) list.add(sample_scenario(static_cast<std::uint64_t>(i)));
  }
  const std::string bytes = read_file(folder / "a.scenarios");
  for (const std::size_t size : {std::size_t{50}, std::size_t{5000}, bytes.size() / 2}) {
    write_file_atomically(folder / "b.scenarios", bytes.substr(0, size));
    EXPECT_TRUE(throws_error(ErrorKind::File, folder / "b.scenarios", {}, [&] {
      const ScenarioList list = ScenarioList::open(folder / "b.scenarios");
      for (const auto& entry : list.entries()) list.read(entry.hash);
    })) << size;
  }
}

}  // namespace
}  // namespace slalom
