// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "list_sample.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

class DeletedScenarios : public testing::Test {
 protected:
  static constexpr int kCount = 30;

  static ListSelection of(const std::vector<std::string>& hashes) {
    ListSelection selection;
    selection.hashes = hashes;
    return selection;
  }
  std::string hash(int row) const { return rows_[static_cast<std::size_t>(row)].hash; }
  void execute(const std::string& sql) const {
    SQLite::Database(path_, SQLite::OPEN_READWRITE).exec(sql);
  }
  /// The names of deleted scenarios, with one line for each deletion.
  static std::string names(const ScenarioList& list) {
    std::string text;
    for (const auto& deletion : list.deletions()) {
      for (const auto& entry : deletion) text += entry.name + " ";
      text.back() = '\n';
    }
    return text;
  }
  /// The complete file without what is kept of deleted scenarios.
  std::string dump() const {
    const std::string whole = dump_list(path_);
    return whole.substr(0, whole.find("sqlite_master\n"));
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_ / "a.scenarios";
  std::vector<SampleRow> rows_;
  ScenarioList list_ = sample_list(path_, kCount, 5, rows_);
};

TEST_F(DeletedScenarios, AreRestoredInAnotherProgramWhereTheyWereWithTagsAndValues) {
  EXPECT_FALSE(list_.has_deletions());
  EXPECT_TRUE(list_.deletions().empty());
  EXPECT_EQ(list_.restore({hash(1)}), 0U);
  const std::string before = dump();
  list_.remove(of({hash(7), hash(3)}));
  list_.remove(hash(29));
  ScenarioList other = ScenarioList::open(path_);
  EXPECT_TRUE(other.has_deletions());
  EXPECT_EQ(names(other), "room_29\nroom_3 room_7\n");
  EXPECT_EQ(other.deletions()[1][0].tags, std::vector<std::string>(rows_[3].tags));
  EXPECT_EQ(other.restore({hash(3), hash(29), "no such hash", hash(3)}), 2U);
  EXPECT_EQ(names(other), "room_7\n");
  EXPECT_EQ(other.restore({hash(7)}), 1U);
  EXPECT_FALSE(other.has_deletions());
  EXPECT_EQ(dump(), before);
}

TEST_F(DeletedScenarios, AreStillKeptWhenTheyAreRemovedAgain) {
  EXPECT_FALSE(list_.remove("0123"));
  EXPECT_FALSE(list_.has_deletions());
  EXPECT_TRUE(list_.remove(hash(3)));
  EXPECT_FALSE(list_.remove(hash(3)));
  EXPECT_EQ(list_.restore({hash(3)}), 1U);
}

TEST_F(DeletedScenarios, ComeLastWhereAnotherOneTookTheirPlace) {
  list_.remove(of({hash(28), hash(29)}));
  list_.add(sample_scenario(1, "new"));
  list_.restore({hash(28), hash(29)});
  std::vector<std::string> last;
  for (const auto& entry : list_.entries()) last.push_back(entry.name);
  last.erase(last.begin(), last.end() - 3);
  EXPECT_EQ(last, (std::vector<std::string>{"new", "room_28", "room_29"}));
}

TEST_F(DeletedScenarios, AreNotOfferedWhileTheListContainsThem) {
  const Scenario scenario = list_.read(hash(4));
  list_.remove(hash(4));
  list_.add(scenario.renamed("again"));
  EXPECT_FALSE(list_.has_deletions());
  EXPECT_TRUE(list_.deletions().empty());
  EXPECT_EQ(list_.restore({hash(4)}), 0U);
  EXPECT_EQ(list_.size(), rows_.size());
  list_.remove(hash(4));
  EXPECT_EQ(names(list_), "again\n") << "the latest state";
}

TEST_F(DeletedScenarios, StayInTheirFile) {
  list_.remove(of({hash(1), hash(2)}));
  list_.save_as(folder_ / "saved.scenarios");
  ScenarioList::write(folder_ / "written.scenarios", [&](ScenarioList& target) {
    list_.for_each({}, [&](const auto& entry) { return target.copy_from(list_, entry); });
    target.remove(hash(3));
    target.remove(of({hash(4)}));
  });
  for (const char* name : {"saved.scenarios", "written.scenarios"}) {
    EXPECT_FALSE(ScenarioList::open(folder_ / name).has_deletions()) << name;
    EXPECT_EQ(dump_list(folder_ / name).find("room_1|"), std::string::npos) << name;
    EXPECT_FALSE(SQLite::Database(folder_ / name).tableExists("deleted_values")) << name;
  }
  EXPECT_EQ(list_.remove(of({hash(5)}), false), 1U);  // moved, for example
  EXPECT_EQ(names(list_), "room_1 room_2\n");
}

TEST_F(DeletedScenarios, AreKeptUpToTheirLargestNumber) {
  const auto count = static_cast<int>(ScenarioList::kMaxDeleted);
  std::vector<Scenario> more;
  for (int i = 0; i < count; ++i)
    more.push_back(sample_scenario(80000 + static_cast<std::uint64_t>(i), "more"));
  list_.remove(hash(0));
  const std::vector<std::string> added = list_.add_all(more);
  list_.remove(of({added.begin() + 1, added.end()}));
  ASSERT_EQ(list_.deletions().size(), 2U) << "1,000 of two deletions";
  list_.remove(hash(1));
  ASSERT_EQ(list_.deletions().size(), 2U);
  EXPECT_EQ(list_.deletions()[0][0].name, "room_1");
  EXPECT_EQ(list_.deletions()[1].size(), added.size() - 1);
  list_.restore({added.begin() + 1, added.end()});
  EXPECT_EQ(list_.remove(ListSelection{}), rows_.size() - 2 + added.size());
  ASSERT_EQ(list_.deletions().size(), 1U);
  EXPECT_EQ(list_.deletions()[0].size(), ScenarioList::kMaxDeleted) << "the last of the list";
  EXPECT_EQ(SQLite::Database(path_)
                .execAndGet("SELECT count(DISTINCT hash) FROM deleted_values WHERE hash NOT IN "
                            "(SELECT hash FROM deleted_scenarios)")
                .getInt(),
            0);
}

TEST_F(DeletedScenarios, AreKeptUpToTheirLargestSize) {
  list_.remove(hash(0));
  list_.remove(hash(1));
  execute("UPDATE deleted_scenarios SET content = zeroblob(67108864) WHERE name = 'room_0'");
  list_.remove(hash(2));
  EXPECT_EQ(names(list_), "room_2\nroom_1\n");
}

TEST_F(DeletedScenarios, OfADamagedFileAreNotRestored) {
  list_.remove(of({hash(1), hash(2)}));
  list_.tag(of({hash(3)}), {"kept"}, {});
  list_.remove(hash(3));
  for (const char* change :
       {"UPDATE deleted_scenarios SET name = 'x'", "UPDATE deleted_scenarios SET checksum = 'y'",
        "UPDATE deleted_scenarios SET representation = 7", "DELETE FROM deleted_tags",
        "UPDATE deleted_scenarios SET content = x'00'",
        "UPDATE deleted_scenarios SET content = (SELECT content FROM scenarios LIMIT 1)",
        "UPDATE deleted_scenarios SET position = 'here'", "DROP TABLE deleted_tags",
        "DROP TABLE deleted_scenarios; CREATE TABLE deleted_scenarios (x, y)",
        "DROP TABLE deleted_values; CREATE TABLE deleted_values (hash, hash2, x)"}) {
    const TemporaryFolder copies;
    const std::string copy = copies / "b.scenarios";
    std::filesystem::copy_file(path_, copy);
    SQLite::Database database(copy, SQLite::OPEN_READWRITE);
    database.exec(change);
    ScenarioList list = ScenarioList::open(copy);
    const std::string before = dump_list(copy);
    EXPECT_THROW(list.restore({hash(3)}), Error) << change;
    EXPECT_EQ(dump_list(copy), before) << change;
    EXPECT_EQ(list.entries().size(), rows_.size() - 3) << change;
  }
  execute("UPDATE deleted_scenarios SET name = 'x' WHERE name = 'room_2'");
  EXPECT_TRUE(throws_error(ErrorKind::File, path_ + ": scenario '" + hash(2) + "'", {"is damaged"},
                           [&] { list_.deletions(); }));
  EXPECT_EQ(list_.restore({hash(1)}), 1U) << "is undamaged";
  execute("DROP TABLE deleted_scenarios; CREATE TABLE deleted_scenarios (x, y)");
  EXPECT_TRUE(throws_error(ErrorKind::File, path_, {}, [&] { list_.has_deletions(); }));
  EXPECT_TRUE(throws_error(ErrorKind::Job, path_, {}, [&] { list_.remove(hash(5)); }));
  EXPECT_EQ(list_.find_entry(hash(5)).name, "room_5");
}

}  // namespace
}  // namespace slalom
