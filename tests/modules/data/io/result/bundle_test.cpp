// SPDX-License-Identifier: BSD-3-Clause
#include "compression.h"
#include "error_text.h"
#include "io_sample.h"

#include <slalom/core/read_file.h>
#include <slalom/io/bundle.h>
#include <slalom/io/merge_results.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>

namespace slalom {
namespace {

/// A result file with `count` scenarios, in which "a" succeeds in the even ones, "b" in all but the
/// last.
class BundleFiles : public ::testing::Test {
 protected:
  void fill(int count) const {
    ResultFile file = ResultFile::create(results_, {{"campaign", "c"}}, {}, {});
    for (int i = 0; i < count; ++i) {
      const Scenario scenario =
          sample_scenario(static_cast<std::uint64_t>(i) + 1, "s" + std::to_string(i));
      References references;
      references.shortest = ShortestPath{{{1, 1}, {9, 9}}, 11.5, {11, 12}, "exact", "", 11.5};
      file.add_scenario({scenario.hash(), scenario.name(), {}}, scenario, references);
      for (const std::string method : {"a", "b"}) {
        RunRecord run;
        run.scenario_hash = scenario.hash();
        run.scenario_name = scenario.name();
        run.method = method;
        run.outcome = (method == "a" ? i % 2 == 0 : i < count - 1) ? "success" : "stuck";
        Trajectory trajectory;
        trajectory.samples.resize(3);
        file.add_run(run, {0.5, {{"cycle_time_p50", 1}}}, trajectory);
      }
    }
    file.commit();
  }

  std::vector<std::string> with_trajectory() const {
    const ResultFile file = ResultFile::open(bundle_);
    std::vector<std::string> names;
    file.for_each_run([&](const RunRecord& run) {
      if (!file.read_trajectory(run).samples.empty())
        names.push_back(run.scenario_name + run.method);
    });
    return names;
  }

  TemporaryFolder folder_;
  std::string results_ = folder_ / "a.results", bundle_ = folder_ / "a.slalom";
};

TEST_F(BundleFiles, HaveTheFailuresOfEachMethodThatMostOthersSolve) {
  fill(8);
  write_bundle(results_, bundle_, {{}, 2});
  // "a" fails in 1, 3, 5, 7; in the last one "b" fails too, for the first time.
  EXPECT_EQ(with_trajectory(), (std::vector<std::string>{"s1a", "s1b", "s3a", "s3b", "s7b"}));
  write_bundle(results_, bundle_, {{}, 0});
  EXPECT_TRUE(with_trajectory().empty());
}

TEST_F(BundleFiles, AreReadLikeResultFilesWithoutWallClockFigures) {
  fill(3);
  write_bundle(results_, bundle_);
  EXPECT_TRUE(is_bundle(bundle_));
  EXPECT_FALSE(is_bundle(results_));
  EXPECT_TRUE(is_result_input(bundle_));
  EXPECT_EQ(find_metric(read_results(results_), "cycle_time_p50")->number(0), 1);
  const ResultTable table = read_results(bundle_);
  EXPECT_EQ(table.size(), 6U);
  EXPECT_TRUE(table.damaged.empty());
  EXPECT_EQ(find_metric(table, "cycle_time_p50"), nullptr);
  EXPECT_EQ(count_results(bundle_).runs, 6U);
  // A bundle of a bundle is the same bundle.
  const std::string again = folder_ / "again.slalom";
  write_bundle(bundle_, again);
  EXPECT_EQ(read_file(again), read_file(bundle_));
}

TEST_F(BundleFiles, AreNotChanged) {
  fill(1);
  write_bundle(results_, bundle_);
  const std::string before = read_file(bundle_);
  EXPECT_TRUE(throws_error(ErrorKind::Usage, bundle_ + ": ", {"is a bundle"},
                           [&] { MergedResults(folder_ / "all.results", bundle_).add(bundle_); }));
  EXPECT_TRUE(throws_error(ErrorKind::File, bundle_ + ": ", {"different kind"},
                           [&] { ResultFile::create(bundle_, {}, {}, {}); }));
  ResultFile file = ResultFile::open(bundle_);
  EXPECT_TRUE(throws_error(ErrorKind::Job, bundle_ + ": ", {"cannot be written"}, [&] {
    file.replace_manifest({});
    file.commit();
  }));
  EXPECT_EQ(read_file(bundle_), before);
}

TEST_F(BundleFiles, ThatAreDamagedOrSomethingElseAreRefused) {
  fill(2);
  write_bundle(results_, bundle_);
  const std::string bundle = read_file(bundle_), pages = decompress(bundle, "");
  const auto expect_refused = [&](const std::string& bytes, const std::string& words) {
    write_file_atomically(bundle_, bytes);
    EXPECT_TRUE(
        throws_error(ErrorKind::File, bundle_ + ": ", {words}, [&] { ResultFile::open(bundle_); }));
  };
  for (const std::size_t size : {bundle.size() - 1, bundle.size() / 2, std::size_t{40}})
    expect_refused(bundle.substr(0, size), "is ");
  expect_refused(compress("scenario,method\n" + std::string(100, 'a')), "unzstd");
  expect_refused(compress(pages.substr(0, 4096)), "is damaged");
  std::string other = pages;
  other[68] ^= 1;  // the application id of SQLite's header
  expect_refused(compress(other), "is a different kind of file");
  std::string claims = bundle;
  claims[5] = static_cast<char>(claims[5] ^ 0x7f);  // the size that the frame announces
  expect_refused(claims, "is ");
}

}  // namespace
}  // namespace slalom
