// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "list_sample.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

/// A random edit of a list.
void edit(ScenarioList& list, RandomEngine& engine, std::uint64_t number) {
  const auto entries = list.entries();
  const auto& random = entries[static_cast<std::size_t>(
      uniform_int(engine, 0, static_cast<int>(entries.size()) - 1))];
  ListSelection selection;
  selection.hashes = {random.hash, entries.front().hash};
  switch (uniform_int(engine, 0, 7)) {
    case 0:
      list.add(sample_scenario(5000 + number, "added"), {"maze", number, {"new"}});
      break;
    case 1:
      list.remove(selection);
      break;
    case 2:
      list.tag(selection, {"t" + std::to_string(number)}, {"hard"});
      break;
    case 3:
      list.rename(random.hash, "name " + std::to_string(number));
      break;
    case 4:
      list.replace(random.hash, sample_scenario(9000 + number, "edited"));
      break;
    case 5:
      list.create_index(
          {"i" + std::to_string(number), "density", sample_view().at("density"), {0, 1}});
      break;
    case 6:
      if (!list.indexes().empty()) list.drop_index(list.indexes().front().name);
      break;
    default:
      list.store_value(random.hash, {{"traps", 1, std::to_string(number)}, Value::na("r")});
      list.set_note("n", std::to_string(number));
  }
}

TEST(ListChange, RevertAndApplyRestoreTheExactState) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.scenarios";
  std::vector<SampleRow> rows;
  ScenarioList list = sample_list(path, 30, 3, rows);
  RandomEngine engine(9);
  std::vector<ListChange> changes;
  std::vector<std::string> dumps = {dump_list(path)};
  for (std::uint64_t step = 0; step < 30; ++step) {
    changes.push_back(list.record([&] {
      edit(list, engine, 2 * step);
      edit(list, engine, 2 * step + 1);
    }));
    dumps.push_back(dump_list(path));
  }
  for (std::size_t i = changes.size(); i-- > 0;) {
    list.revert(changes[i]);
    ASSERT_EQ(dump_list(path), dumps[i]) << i;
  }
  for (std::size_t i = 0; i < changes.size(); ++i) {
    list.apply(changes[i]);
    ASSERT_EQ(dump_list(path), dumps[i + 1]) << i;
  }
}

TEST(ListChange, AFailedEditChangesNothing) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.scenarios";
  std::vector<SampleRow> rows;
  ScenarioList list = sample_list(path, 10, 3, rows);
  const std::string before = dump_list(path);
  EXPECT_THROW(list.record([&] {
    list.remove(rows[0].hash);
    list.create_index({"x", "density", sample_view().at("density"), {0, 1}});
    throw std::runtime_error("midway");
  }),
               std::runtime_error);
  EXPECT_EQ(dump_list(path), before);
  EXPECT_THROW(list.in_transaction([&] {
    list.rename(rows[1].hash, "x");
    throw std::runtime_error("midway");
  }),
               std::runtime_error);
  EXPECT_EQ(dump_list(path), before);
  list.rename(rows[1].hash, "x");  // the list is still writable
  EXPECT_NE(dump_list(path), before);
}

TEST(ListChange, IsNotRevertedOverChangesByAnotherProgram) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.scenarios";
  std::vector<SampleRow> rows;
  ScenarioList list = sample_list(path, 10, 3, rows);
  const ListChange change = list.record([&] {
    list.rename(rows[0].hash, "mine");
    list.rename(rows[1].hash, "mine too");
  });
  ScenarioList other = ScenarioList::open(path);
  other.rename(rows[1].hash, "theirs");
  const std::string before = dump_list(path);
  EXPECT_TRUE(throws_error(ErrorKind::Job, path, {"changed by another program"},
                           [&] { list.revert(change); }));
  EXPECT_EQ(dump_list(path), before) << "no partial change";
}

TEST(ListEdit, ReplacedScenariosKeepPositionAndTags) {
  const TemporaryFolder folder;
  ScenarioList list = ScenarioList::create(folder / "a.scenarios");
  for (std::uint64_t i = 0; i < 3; ++i)
    list.add(sample_scenario(i, std::to_string(i)), {"maze", i, {"t" + std::to_string(i)}});
  const std::string old = sample_scenario(1).hash();
  list.store_value(old, {{"density", 1, ""}, Value::of(0.5)});
  list.replace(old, sample_scenario(10, "ten"));
  const auto entry = list.entries()[1];
  EXPECT_EQ(entry.hash, sample_scenario(10).hash());
  EXPECT_EQ(entry.name, "ten");
  EXPECT_EQ(entry.tags, std::vector<std::string>{"t1"});
  EXPECT_EQ(entry.generator, "") << "not created by a generator";
  EXPECT_FALSE(list.find(entry.hash, {"density", 1, ""}).has_value());
  EXPECT_FALSE(list.find(old, {"density", 1, ""}).has_value());
  EXPECT_EQ(list.read(entry.hash).name(), "ten");
  EXPECT_TRUE(throws_error(ErrorKind::Usage, list.path(), {"already contains", "'2'"},
                           [&] { list.replace(entry.hash, sample_scenario(2, "other name")); }));
}

TEST(ListEdit, RenamingKeepsEverythingElse) {
  const TemporaryFolder folder;
  ScenarioList list = ScenarioList::create(folder / "a.scenarios");
  list.add(sample_scenario(1, "old"), {"maze", 4, {"t"}});
  const std::string hash = list.entries()[0].hash;
  list.store_value(hash, {{"density", 1, ""}, Value::of(0.5)});
  list.rename(hash, "new name");
  const auto entry = list.entries()[0];
  EXPECT_EQ(entry.name, "new name");
  EXPECT_EQ(entry.generator, "maze");
  EXPECT_EQ(entry.tags, std::vector<std::string>{"t"});
  EXPECT_EQ(list.read(hash).name(), "new name");
  EXPECT_EQ(list.find(hash, {"density", 1, ""}), Value::of(0.5));
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "name ''", {}, [&] { list.rename(hash, ""); }));
}

TEST(ListEdit, AddsAndRemovesTags) {
  const TemporaryFolder folder;
  std::vector<SampleRow> rows;
  ScenarioList list = sample_list(folder / "a.scenarios", 5, 3, rows);
  EXPECT_EQ(list.tag({}, {"x", "y"}, {}), 5U);
  EXPECT_EQ(list.tag({}, {"x"}, {}), 0U) << "all have the tag";
  ListSelection one;
  one.hashes = {rows[3].hash};
  EXPECT_EQ(list.tag(one, {}, {"x", "nothing"}), 1U);
  for (const auto& entry : list.entries())
    EXPECT_EQ(std::count(entry.tags.begin(), entry.tags.end(), "x"),
              entry.hash == rows[3].hash ? 0 : 1);
}

}  // namespace
}  // namespace slalom
