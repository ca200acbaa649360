// SPDX-License-Identifier: BSD-3-Clause
#include "dump_text.h"
#include "error_text.h"
#include "io_sample.h"

#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>
#include <slalom/references/reference_codec.h>

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>

namespace slalom {
namespace {

/// Everything that can be read from a result file, by the name under which damage is reported.
struct Content {
  std::map<std::string, std::string> runs;  ///< lines of the dump
  std::map<std::string, std::string> table, details, figures, descriptors;
  std::map<std::string, std::string> trajectories, references, scenarios;
  std::vector<std::string> damaged;
};

std::string text_of(const ValueColumn& column, std::size_t row) {
  return column.is_na(row) ? "NA " + column.reason(row) : format_number(column.number(row));
}

template <typename Read>
void read_part(std::map<std::string, std::string>& parts, std::vector<std::string>& damaged,
               const std::string& name, Read read) {
  try {
    parts[name] = read();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::File);
    EXPECT_TRUE(mentions(error.what(), {".results"}));
    damaged.push_back(name);
  }
}

void read_table(const std::string& path, Content& content) {
  const ResultTable table = read_detailed_results(path);
  for (std::size_t run = 0; run < table.size(); ++run) {
    const std::string id = "run " + run_id(table, run);
    content.table[id] =
        table.scenario_names[table.scenario[run]] + " " + table.outcomes[table.outcome[run]];
    for (const ValueColumn& metric : table.metrics)
      (metric.wall_clock ? content.figures["wall-clock figures of " + id] : content.table[id]) +=
          " " + metric.info().id + " " + text_of(metric, run);
    const RunDetails& details = table.details[run];
    content.details[id] =
        std::to_string(details.seed) + details.outcome_detail + details.trajectory_hash;
  }
  for (std::size_t i = 0; i < table.scenario_hashes.size(); ++i)
    for (const ValueColumn& descriptor : table.descriptors)
      content.descriptors["scenario " + table.scenario_hashes[i]] += text_of(descriptor, i) + " ";
  content.damaged.insert(content.damaged.end(), table.damaged.begin(), table.damaged.end());
}

Content read_content(const std::string& path) {
  Content content;
  const auto report = [&](const std::string& what) { content.damaged.push_back(what); };
  const ResultFile file = ResultFile::open(path);
  std::vector<std::string> hashes;
  file.for_each_run(
      [&](const RunRecord& run) {
        const std::string id = run_id(run);
        read_part(content.trajectories, content.damaged, "trajectory of " + id,
                  [&] { return file.read_trajectory(run).hash(); });
        hashes.push_back(run.scenario_hash);
      },
      report);
  for (const std::string& hash : hashes) {
    read_part(content.references, content.damaged, "references of " + hash,
              [&] { return to_bytes(file.read_references(hash)); });
    read_part(content.scenarios, content.damaged, "content of " + hash,
              [&] { return file.read_scenario(hash).hash(); });
  }
  const std::string text = dump_text(file, report);
  for (std::size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1) {
    const std::string line = text.substr(begin, text.find('\n', begin) - begin);
    content.runs[line] = line;
  }
  read_table(path, content);
  return content;
}

/// Whether every part is that of the original, or missing while damage is reported.
::testing::AssertionResult is_part_of(const std::map<std::string, std::string>& parts,
                                      const std::map<std::string, std::string>& original,
                                      const std::vector<std::string>& damaged) {
  for (const auto& [name, text] : parts) {
    const auto found = original.find(name);
    const bool reported = std::find(damaged.begin(), damaged.end(), name) != damaged.end();
    if (!reported && (found == original.end() || found->second != text))
      return ::testing::AssertionFailure() << name << " became " << text;
  }
  if (parts.size() < original.size() && damaged.empty())
    return ::testing::AssertionFailure() << original.size() - parts.size() << " are missing";
  return ::testing::AssertionSuccess();
}

class ResultDamageTest : public testing::Test {
 protected:
  static constexpr int kScenarios = 3, kRuns = 4;

  ResultDamageTest() : path_(folder_ / "runs.results") {
    ResultFile file = ResultFile::create(
        path_, {{"campaign", "test"}, {"seed", "1"}},
        {{"density", 1, "Density", "-", Direction::None},
         {"clearness", 2, "Clearness", "m", Direction::None}},
        {{"spl", 2, "SPL", "-", Direction::Up}, {"time", 1, "Time", "s", Direction::Down}});
    for (std::uint64_t seed = 1; seed <= kScenarios; ++seed) {
      const Scenario scenario = sample_scenario(seed, "scenario" + std::to_string(seed));
      ScenarioRecord record{scenario.hash(), scenario.name(), {}};
      record.descriptors["density"] = {1, Value::of(0.1 * static_cast<double>(seed), 0.01)};
      record.descriptors["clearness"] = {2, Value::na("no free space")};
      References references;
      references.shortest = ShortestPath{{{0, 0}, {3, 4}}, 5, {4.9, 5}, "BITstar", "", 5.1, 5.0};
      references.timing = {0.1, 0.2, 0.3};
      file.add_scenario(record, scenario, references);
      for (int repetition = 0; repetition < kRuns; ++repetition) add_run(file, record, repetition);
    }
    file.commit();
  }

  static void add_run(ResultFile& file, const ScenarioRecord& scenario, int repetition) {
    Trajectory trajectory;
    for (int i = 0; i < 5; ++i)
      trajectory.samples.push_back({0.1 * i, {1.0 * repetition, 2, 3}, 4, 5, 6, 7});
    RunRecord run;
    run.scenario_hash = scenario.hash;
    run.scenario_name = scenario.name;
    run.method = "nd";
    run.repetition = repetition;
    run.seed = 0xfedcba9876543210ULL;
    run.outcome = "success";
    run.outcome_detail = "detail " + std::to_string(repetition);
    run.trajectory_hash = trajectory.hash();
    run.metrics["spl"] = {2, Value::of(0.25 * repetition, 0.125)};
    run.metrics["time"] = {1, Value::na("not a success")};
    file.add_run(run, {1.5 + repetition, {{"cycle_time_mean", 0.5 * repetition}}}, trajectory);
  }

  void execute(const std::string& sql) const {
    SQLite::Database(path_, SQLite::OPEN_READWRITE).exec(sql);
  }

  TemporaryFolder folder_;
  std::string path_;
};

TEST_F(ResultDamageTest, ADamagedRunIsNamedAndTheOthersAreRead) {
  const Content before = read_content(path_);
  EXPECT_TRUE(before.damaged.empty());
  const ResultFile file = ResultFile::open(path_);
  const std::string hash = sample_scenario(1, "scenario1").hash();
  const std::string id = "run " + hash.substr(0, 8) + "/nd/2";
  execute("UPDATE runs SET m_spl = 0.75 WHERE scenario = '" + hash + "' AND repetition = 2");
  EXPECT_TRUE(throws_error(ErrorKind::File, path_ + ": " + id + ": ", {"is damaged"},
                           [&] { file.read_run(hash, "nd", 2); }));
  EXPECT_TRUE(throws_error(ErrorKind::File, path_ + ": " + id + ": ", {"is damaged"},
                           [&] { file.read_runs(hash); }));
  EXPECT_TRUE(throws_error(ErrorKind::File, path_ + ": " + id + ": ", {"is damaged"},
                           [&] { dump_text(file); }));
  EXPECT_TRUE(file.read_run(hash, "nd", 1));
  const ResultTable table = read_results(path_);
  EXPECT_EQ(table.size(), kScenarios * kRuns - 1U);
  EXPECT_EQ(table.damaged, std::vector<std::string>{id});
  std::vector<std::string> damaged;
  const std::string text =
      dump_text(file, [&](const std::string& what) { damaged.push_back(what); });
  EXPECT_EQ(damaged, std::vector<std::string>{id});
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), kScenarios * kRuns - 1);
}

TEST_F(ResultDamageTest, ADamagedScenarioCostsItsDescriptors) {
  const std::string hash = sample_scenario(2, "scenario2").hash();
  execute("UPDATE descriptors SET value = 0.7 WHERE id = 'density' AND hash = '" + hash + "'");
  const ResultTable table = read_results(path_);
  EXPECT_EQ(table.size(), 1U * kScenarios * kRuns);
  EXPECT_EQ(table.damaged, std::vector<std::string>{"scenario " + hash});
  const auto row = std::find(table.scenario_hashes.begin(), table.scenario_hashes.end(), hash) -
                   table.scenario_hashes.begin();
  for (std::size_t i = 0; i < table.scenario_hashes.size(); ++i)
    EXPECT_EQ(table.descriptors[1].is_na(i), i == static_cast<std::size_t>(row));  // density
  EXPECT_TRUE(throws_error(ErrorKind::File, path_ + ": scenario " + hash, {"is damaged"},
                           [&] { ResultFile::open(path_).read_record(hash); }));
}

/// A row cannot be passed off as that of another run either.
TEST_F(ResultDamageTest, RowsOfAnotherRunAreNotTaken) {
  execute("UPDATE trajectories SET run = -run; UPDATE trajectories SET run = 13 + run");
  execute("UPDATE run_timings SET run = -run; UPDATE run_timings SET run = 13 + run");
  const Content content = read_content(path_);
  EXPECT_TRUE(content.trajectories.empty());
  EXPECT_EQ(content.runs.size(), 1U * kScenarios * kRuns);
  EXPECT_EQ(content.damaged.size(), 2U * kScenarios * kRuns);
}

TEST_F(ResultDamageTest, AMissingRunIsNoticed) {
  SQLite::Database database(path_, SQLite::OPEN_READWRITE);
  database.exec("CREATE TABLE copy AS SELECT * FROM runs WHERE run <> 5");
  database.exec("PRAGMA writable_schema = ON");
  database.exec(
      "UPDATE sqlite_master SET rootpage = (SELECT rootpage FROM sqlite_master WHERE "
      "name = 'copy') WHERE name = 'runs'");
  EXPECT_TRUE(throws_error(ErrorKind::File, path_ + ": ", {"is damaged", "11 runs", "12"},
                           [&] { read_results(path_); }));
}

TEST_F(ResultDamageTest, ADamagedManifestIsRefused) {
  execute("UPDATE manifest SET text = 'tesu' WHERE key = 'campaign'");
  EXPECT_TRUE(throws_error(ErrorKind::File, path_ + ": ", {"is damaged", "manifest"},
                           [&] { ResultFile::open(path_); }));
}

TEST_F(ResultDamageTest, NoFlippedBitChangesAValueUnnoticed) {
  const Content original = read_content(path_);
  ASSERT_EQ(original.runs.size(), 1U * kScenarios * kRuns);
  const std::string bytes = read_file(path_);
  const std::string damaged_path = folder_ / "damaged.results";
  RandomEngine engine(1);
  constexpr int kFlips = 300;
  int refused = 0, partial = 0;
  for (int i = 0; i < kFlips; ++i) {
    const auto at =
        static_cast<std::size_t>(uniform_real(engine, 0, static_cast<double>(bytes.size())));
    const int bit = i % 8;
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
    write_file_atomically(damaged_path, damaged);
    try {
      const Content content = read_content(damaged_path);
      SCOPED_TRACE("bit " + std::to_string(bit) + " of byte " + std::to_string(at));
      EXPECT_TRUE(is_part_of(content.runs, original.runs, content.damaged));
      EXPECT_TRUE(is_part_of(content.table, original.table, content.damaged));
      EXPECT_TRUE(is_part_of(content.details, original.details, content.damaged));
      EXPECT_TRUE(is_part_of(content.figures, original.figures, content.damaged));
      EXPECT_TRUE(is_part_of(content.descriptors, original.descriptors, content.damaged));
      EXPECT_TRUE(is_part_of(content.trajectories, original.trajectories, content.damaged));
      EXPECT_TRUE(is_part_of(content.references, original.references, content.damaged));
      EXPECT_TRUE(is_part_of(content.scenarios, original.scenarios, content.damaged));
      if (!content.damaged.empty()) ++partial;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::File) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
  EXPECT_GT(partial, 0);
}

}  // namespace
}  // namespace slalom
