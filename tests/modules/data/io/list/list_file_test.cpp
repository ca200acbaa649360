// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "list_sample.h"

#include <slalom/core/read_file.h>
#include <slalom/io/result_file.h>

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <sys/wait.h>
#include <unistd.h>

namespace slalom {
namespace {

std::size_t files_in(const TemporaryFolder& folder) {
  const std::filesystem::directory_iterator files(folder / "");
  return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

TEST(ListFile, ReplacesTheOldFileOnlyWhenComplete) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.scenarios";
  std::vector<SampleRow> rows;
  sample_list(path, 5, 1, rows);
  const std::string before = dump_list(path);
  EXPECT_THROW(ScenarioList::write(path,
                                   [&](ScenarioList& list) {
                                     list.add(sample_scenario(1));
                                     EXPECT_EQ(dump_list(path), before);
                                     throw std::runtime_error("canceled");
                                   }),
               std::runtime_error);
  EXPECT_EQ(dump_list(path), before);
  EXPECT_EQ(files_in(folder), 1U) << "no temporary files remain";
  ScenarioList::write(path, [](ScenarioList& list) { list.add(sample_scenario(1)); });
  EXPECT_EQ(ScenarioList::open(path).size(), 1U);
  EXPECT_EQ(files_in(folder), 1U);
}

TEST(ListFile, AReplacedFileIsNotWritten) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.scenarios";
  std::vector<SampleRow> rows;
  ScenarioList list = sample_list(path, 5, 1, rows);
  ScenarioList::create(path);
  EXPECT_TRUE(throws_error(ErrorKind::Job, path, {"replaced by another program", "reopened"},
                           [&] { list.add(sample_scenario(7)); }));
  std::filesystem::remove(path);
  EXPECT_TRUE(
      throws_error(ErrorKind::Job, path, {"was removed"}, [&] { list.remove(rows[0].hash); }));
}

/// Hashes that programs read of a list in three ways; none if it is refused.
std::vector<std::string> read_in_three_ways(const std::string& path) {
  try {
    const ScenarioList list = ScenarioList::open(path);
    std::vector<std::string> hashes, selected, values;
    for (const auto& entry : list.entries()) hashes.push_back(list.read(entry.hash).hash());
    for (const auto& entry : list.select({})) selected.push_back(entry.hash);
    EXPECT_EQ(hashes, selected) << path;
    EXPECT_EQ(hashes.size(), list.size()) << path;
    return hashes;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::File) << path << ": " << error.what();
    return {};
  }
}

TEST(ListFile, DamageIsAnErrorAndNeverAShorterList) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.scenarios";
  std::vector<SampleRow> rows;
  sample_list(path, 20, 1, rows);
  const std::vector<std::string> whole = read_in_three_ways(path);
  ASSERT_EQ(whole.size(), 20U);
  const std::string bytes = read_file(path);
  std::size_t variants = 0, errors = 0;
  const auto expect_whole_or_error = [&](const std::string& damaged) {
    // A name of its own: a file is checked once.
    const std::string copy = folder / ("b" + std::to_string(variants++) + ".scenarios");
    std::ofstream(copy, std::ios::binary) << damaged;
    const std::vector<std::string> found = read_in_three_ways(copy);
    EXPECT_EQ(found, found.empty() ? found : whole) << copy;
    errors += found.empty() ? 1 : 0;
  };
  for (const std::size_t size : {std::size_t{4096}, std::size_t{512}, std::size_t{16}})
    for (std::size_t at = 0; at < bytes.size(); at += std::max<std::size_t>(size / 2, 101)) {
      std::string damaged = bytes;
      damaged.replace(at, std::min(size, bytes.size() - at), std::min(size, bytes.size() - at),
                      char{0});
      expect_whole_or_error(damaged);
    }
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    std::string damaged = bytes;
    damaged[random() % bytes.size()] ^= static_cast<char>(1U << random() % 8);
    expect_whole_or_error(damaged);
  }
  EXPECT_GT(errors, 100U);
}

TEST(ListFile, ChangesByAnotherProgramAreVisible) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.scenarios";
  std::vector<SampleRow> rows;
  ScenarioList list = sample_list(path, 5, 1, rows);
  ScenarioList other = ScenarioList::open(path);
  EXPECT_EQ(other.size(), 5U);
  list.remove(rows[0].hash);
  EXPECT_EQ(other.size(), 4U);
  other.add(sample_scenario(77));
  EXPECT_EQ(list.entries().back().hash, sample_scenario(77).hash());
}

TEST(ListFile, IsSavedUnderAnotherName) {
  const TemporaryFolder folder;
  std::vector<SampleRow> rows;
  ScenarioList list = sample_list(folder / "a.scenarios", 20, 1, rows);
  list.create_index({"x", "density", sample_view().at("density"), {0, 1}});
  list.save_as(folder / "b.scenarios");
  EXPECT_EQ(dump_list(folder / "b.scenarios"), dump_list(folder / "a.scenarios"));
  EXPECT_EQ(ScenarioList::open(folder / "b.scenarios").size(), 20U);
  EXPECT_TRUE(
      throws_error(ErrorKind::Job, "/nonexistent/b", {}, [&] { list.save_as("/nonexistent/b"); }));
}

TEST(ListFile, CopiesIncludeOriginTagsAndValues) {
  const TemporaryFolder folder;
  std::vector<SampleRow> rows;
  ScenarioList list = sample_list(folder / "a.scenarios", 20, 1, rows);
  ScenarioList copy = ScenarioList::create(folder / "b.scenarios");
  copy.add(sample_scenario(999));
  // Key numbers differ between lists; the values must still be found.
  copy.store_value(sample_scenario(999).hash(),
                   {{"confinement", 1, "resolution=0.05"}, Value::of(1)});
  list.for_each({}, [&](const auto& entry) { return copy.copy_from(list, entry); });
  ASSERT_EQ(copy.size(), 21U);
  for (const auto& entry : list.entries()) {
    const auto copied = copy.find_entry(entry.hash);
    EXPECT_EQ(copied.tags, entry.tags);
    EXPECT_EQ(copied.generator, entry.generator);
    EXPECT_EQ(copied.seed, entry.seed);
    for (const auto& [id, keys] : sample_view())
      EXPECT_EQ(copy.find(entry.hash, keys), list.find(entry.hash, keys));
    EXPECT_FALSE(copy.copy_from(list, entry)) << "already contained";
  }
}

TEST(ListFile, RemovesOnlyLists) {
  const TemporaryFolder folder;
  write_file_atomically(folder / "text", "not a list, and not to be removed by mistake");
  EXPECT_TRUE(throws_error(ErrorKind::File, folder / "text", {},
                           [&] { ScenarioList::remove_file(folder / "text"); }));
  ScenarioList::create(folder / "a.scenarios");
  ScenarioList::remove_file(folder / "a.scenarios");
  EXPECT_EQ(files_in(folder), 1U);
}

TEST(ListFile, OtherVersionsAreRefused) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.scenarios";
  ScenarioList::create(path);
  for (const int version : {0, 2, 4}) {
    SQLite::Database(path, SQLite::OPEN_READWRITE)
        .exec("PRAGMA user_version = " + std::to_string(version));
    EXPECT_TRUE(throws_error(ErrorKind::File, path,
                             {"version " + std::to_string(version),
                              "expected a scenario list (.scenarios) of version 3"},
                             [&] { ScenarioList::open(path); }));
  }
}

TEST(ListFile, DamagedRowsAreNamed) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.scenarios";
  std::vector<SampleRow> rows;
  sample_list(path, 5, 1, rows);
  const auto keys = sample_view().at("density");
  std::string hash, other;  // with and without a damaged value
  for (const SampleRow& row : rows)
    if (ScenarioList::open(path).find(row.hash, keys)) (hash.empty() ? hash : other) = row.hash;
  ASSERT_FALSE(other.empty());
  const auto execute = [&](const std::string& sql) {
    SQLite::Database(path, SQLite::OPEN_READWRITE).exec(sql + " WHERE hash = '" + hash + "'");
  };
  EXPECT_TRUE(ScenarioList::open(path).find_entry(hash).hash == hash);
  execute("UPDATE descriptor_values SET value = coalesce(value, 0) + 0.5, reason = NULL");
  EXPECT_TRUE(throws_error(ErrorKind::File, path + ": density of scenario " + hash + ": ",
                           {"is damaged"}, [&] { ScenarioList::open(path).find(hash, keys); }));
  ScenarioList::open(path).find(other, keys);
  for (const char* change : {"name = name || 'x'", "generator = 'forest'", "seed = 77",
                             "representation = 'grid'", "hash = 'f' || substr(hash, 2)"}) {
    const TemporaryFolder copies;
    std::filesystem::copy_file(path, copies / "b.scenarios");
    SQLite::Database(copies / "b.scenarios", SQLite::OPEN_READWRITE)
        .exec(std::string("UPDATE scenarios SET ") + change + " WHERE hash = '" + hash + "'");
    const ScenarioList list = ScenarioList::open(copies / "b.scenarios");
    EXPECT_TRUE(throws_error(ErrorKind::File, copies / "b.scenarios: scenario '", {"is damaged"},
                             [&] { list.entries(); }))
        << change;
    EXPECT_EQ(list.find_entry(other).hash, other);
  }
}

TEST(ListFile, DamagedTagsAreNamed) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.scenarios";
  const Scenario tagged = sample_scenario(1), other = sample_scenario(2);
  {
    ScenarioList list = ScenarioList::create(path);
    list.add(tagged, {"", {}, {"hard", "maze"}});
    list.add(other, {"", {}, {"easy"}});
    list.add(tagged, {"", {}, {"again"}});  // known scenario, one more tag
    list.tag({}, {"all"}, {"maze"});
    list.rename(tagged.hash(), "renamed");
  }
  const std::string hash = ScenarioList::open(path).find_entry("renamed").hash;
  EXPECT_EQ(ScenarioList::open(path).find_entry(hash).tags,
            (std::vector<std::string>{"again", "all", "hard"}));
  for (const char* change :
       {"UPDATE tags SET tag = 'hart' WHERE tag = 'hard'", "DELETE FROM tags WHERE tag = 'hard'",
        "UPDATE tags SET hash = 'f' || substr(hash, 2) WHERE tag = 'hard'"}) {
    const TemporaryFolder copies;
    const std::string copy = copies / "b.scenarios";
    std::filesystem::copy_file(path, copy);
    SQLite::Database(copy, SQLite::OPEN_READWRITE).exec(change);
    ScenarioList list = ScenarioList::open(copy);
    const auto is_refused = [&](const std::function<void()>& use) {
      return throws_error(ErrorKind::File, copy + ": scenario '" + hash + "'", {"is damaged"}, use);
    };
    EXPECT_TRUE(is_refused([&] { list.find_entry(hash); })) << change;
    // No change makes the damage valid.
    EXPECT_TRUE(is_refused([&] { list.tag({}, {"new"}, {}); })) << change;
    EXPECT_TRUE(is_refused([&] { list.rename(hash, "other"); })) << change;
    EXPECT_TRUE(is_refused([&] { list.add(list.read(hash), {"", {}, {"new"}}); })) << change;
    EXPECT_TRUE(is_refused([&] { list.find_entry(hash); })) << change;
    EXPECT_EQ(list.find_entry(other.hash()).tags, (std::vector<std::string>{"all", "easy"}));
  }
}

TEST(ListFile, TagsOfEarlierVersionsAreRead) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.scenarios";
  const Scenario scenario = sample_scenario(1);
  {
    ScenarioList list = ScenarioList::create(path);
    list.add(scenario, {});
  }
  // An earlier version did not change the checksum of the row when it added a tag.
  SQLite::Database(path, SQLite::OPEN_READWRITE)
      .exec("INSERT INTO tags SELECT hash, 'old' FROM scenarios");
  ScenarioList list = ScenarioList::open(path);
  EXPECT_EQ(list.find_entry(scenario.hash()).tags, std::vector<std::string>{"old"});
  EXPECT_EQ(list.tag({}, {"new"}, {}), 1U);
  EXPECT_EQ(list.find_entry(scenario.hash()).tags, (std::vector<std::string>{"new", "old"}));
  SQLite::Database(path, SQLite::OPEN_READWRITE).exec("DELETE FROM tags WHERE tag = 'old'");
  EXPECT_TRUE(throws_error(ErrorKind::File, path, {"is damaged"},
                           [&] { list.find_entry(scenario.hash()); }));
}

TEST(ListFile, AReadOnlyFileCanBeRead) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.scenarios";
  std::vector<SampleRow> rows;
  sample_list(path, 5, 1, rows);
  std::filesystem::permissions(folder / "", std::filesystem::perms(0555));
  std::filesystem::permissions(path, std::filesystem::perms(0444));
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    constexpr uid_t kNobody = 65534;
    if (geteuid() == 0 && setuid(kNobody) != 0) _exit(2);  // root ignores permissions
    std::size_t seen = 0;
    ScenarioList list = ScenarioList::open(path);
    list.in_transaction([&] { seen = list.select({}).size(); });
    const std::string refusal = error_text(ErrorKind::Job, [&] { list.add(sample_scenario(99)); });
    _exit(seen == 5 && refusal.find(path + ": cannot be written (") == 0 ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  std::filesystem::permissions(folder / "", std::filesystem::perms(0755));
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

}  // namespace
}  // namespace slalom
