// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "list_sample.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <sys/resource.h>
#include <sys/wait.h>

namespace slalom {
namespace {

/// Modifies the list in all ways in an endless loop.
[[noreturn]] void write_forever(const std::string& path) {
  for (std::uint64_t i = 0;; ++i) {
    if (i % 7 == 6) {
      ScenarioList::write(path, [&](ScenarioList& list) {
        for (std::uint64_t j = 0; j < 20; ++j)
          list.add(sample_scenario(i * 100 + j), {"maze", j, {"t"}});
      });
    }
    ScenarioList list = ScenarioList::open(path);
    list.record([&] {
      for (std::uint64_t j = 0; j < 10; ++j)
        list.add(sample_as(Representation::Grid, 1000000 + i * 100 + j), {"grid", j, {"t", "u"}});
      const auto entries = list.entries();
      list.remove(entries.front().hash);
      list.rename(entries.back().hash, "renamed");
      list.store_value(entries.back().hash, {{"density", 1, ""}, Value::of(0.5)});
    });
    if (list.indexes().empty())
      list.create_index({"by_density", "density", sample_view().at("density"), {0, 1}});
    else
      list.drop_index("by_density");
  }
}

/// Checks that a list is consistent.
void expect_consistent(const std::string& path) {
  ScenarioList list = ScenarioList::open(path);
  EXPECT_GT(list.size(), 0U);
  for (const auto& entry : list.entries()) {
    EXPECT_EQ(list.read(entry.hash).hash(), entry.hash);
    EXPECT_FALSE(entry.tags.empty()) << "added without its tags";
  }
  EXPECT_EQ(list.indexes().size() == 1,
            dump_list(path).find("|index_by_density|") != std::string::npos);
  SQLite::Database database(path);
  EXPECT_EQ(database.execAndGet("PRAGMA integrity_check").getString(), "ok");
}

TEST(ListDurability, AListIsConsistentWheneverItsProgramIsKilled) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.scenarios";
  ScenarioList::write(path, [](ScenarioList& list) {
    list.add(sample_scenario(1), {"", {}, {"t"}});
  });
  RandomEngine engine(4);
  for (int round = 0; round < 60; ++round) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) write_forever(path);
    usleep(static_cast<useconds_t>(uniform_int(engine, 500, 40000)));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "not ended by the signal";
    expect_consistent(path);
    if (HasFailure()) return;
  }
}

TEST(ListDurability, TheOldListIsKeptWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.scenarios";
  std::vector<SampleRow> rows;
  sample_list(path, 50, 1, rows);
  const std::string before = dump_list(path);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    // Limit the file size to simulate a full disk.
    signal(SIGXFSZ, SIG_IGN);
    const auto size = static_cast<rlim_t>(std::filesystem::file_size(path));
    const rlimit limit = {size, size};
    setrlimit(RLIMIT_FSIZE, &limit);
    const auto add_many = [](ScenarioList& list) {
      list.in_transaction([&] {
        for (std::uint64_t i = 0; i < 2000; ++i) list.add(sample_scenario(900000 + i));
      });
    };
    const std::string in_place = error_text(ErrorKind::Job, [&] {
      ScenarioList list = ScenarioList::open(path);
      add_many(list);
    });
    const std::string replaced =
        error_text(ErrorKind::Job, [&] { ScenarioList::write(path, add_many); });
    const bool reported = in_place.find(path + ": cannot be written (") == 0 &&
                          replaced.find(path + ": cannot be written (") == 0;
    _exit(reported ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  EXPECT_EQ(dump_list(path), before);
}

TEST(ListDurability, ConcurrentWritersWaitForEachOther) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.scenarios";
  ScenarioList::create(path);
  constexpr int kPrograms = 3;
  constexpr std::uint64_t kEach = 15;
  std::vector<pid_t> children;
  for (int program = 0; program < kPrograms; ++program) {
    children.push_back(fork());
    if (children.back() == 0) {
      ScenarioList list = ScenarioList::open(path);
      for (std::uint64_t i = 0; i < kEach; ++i)
        list.in_transaction([&] {
          list.size();
          list.add(sample_scenario(static_cast<std::uint64_t>(program) * 1000 + i));
        });
      _exit(0);
    }
  }
  for (const pid_t child : children) {
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  }
  EXPECT_EQ(ScenarioList::open(path).size(), kPrograms * kEach);
}

}  // namespace
}  // namespace slalom
