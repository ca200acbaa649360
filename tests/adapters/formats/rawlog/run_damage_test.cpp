// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "gzip.h"
#include "recorded_runs.h"

#include <slalom/core/read_file.h>

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/io/CFileOutputStream.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/serialization/CArchive.h>

#include <fstream>

namespace slalom {
namespace {

using mrpt::obs::CObservation2DRangeScan;
using mrpt::obs::CObservationComment;
using mrpt::obs::CObservationOdometry;

class DamagedRun : public testing::RecordedRunTest {
 protected:
  void SetUp() override {
    RecordedRunTest::SetUp();
    auto method = testing::constant_method(0.4, 0.05);
    RunSetup setup;
    setup.simulation.max_time = 2;
    testing::simulate_run(path("run.rawlog"), method, setup);
    load("run.rawlog");
  }

  /// The error of reading the log in its current state.
  std::string error() {
    save<mrpt::io::CFileGZOutputStream>("changed.rawlog");
    return error_of("changed.rawlog");
  }
  std::string error_of(const std::string& name) const {
    return error_text(ErrorKind::File, [&] { read_run(path(name)); });
  }
  void load(const std::string& name) {
    mrpt::io::CFileGZInputStream file(path(name));
    auto archive = mrpt::serialization::archiveFrom(file);
    try {
      while (true) log_.push_back(archive.ReadObject());
    } catch (const mrpt::serialization::CExceptionEOF&) {
      ASSERT_GT(log_.size(), 80U);  // the complete file: four objects in each of 20 cycles
    }
  }
  template <typename File>
  void save(const std::string& name) const {
    File file(path(name));
    auto archive = mrpt::serialization::archiveFrom(file);
    for (const auto& object : log_) archive << *object;
  }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
  }
  static std::string unpacked(const std::string& gzip) {
    return gunzip(gzip, std::size_t{1} << 20, "test");
  }
  CObservationComment& comment(std::size_t index) {
    return dynamic_cast<CObservationComment&>(*log_.at(index));
  }
  /// Removes the line of `key` from a comment, with the indented lines that follow it.
  static void remove_key(CObservationComment& comment, const std::string& key) {
    std::string& text = comment.text;
    const std::size_t begin = ("\n" + text).find("\n" + key + " =");
    ASSERT_NE(begin, std::string::npos) << key;
    std::size_t end = text.find('\n', begin) + 1;
    while (text.compare(end, 2, "  ") == 0) end = text.find('\n', end) + 1;
    text.erase(begin, end - begin);
  }

  std::vector<mrpt::serialization::CSerializable::Ptr> log_;
};

TEST_F(DamagedRun, ReadsAnUnchangedCopy) {
  EXPECT_EQ(error(), "(no error)");
}

TEST_F(DamagedRun, RejectsTruncatedFiles) {
  const std::string content = read_file(path("run.rawlog"));
  for (std::size_t size = 0; size < content.size(); size += 1 + content.size() / 97) {
    write("cut.rawlog", content.substr(0, size));
    const std::string text = error_of("cut.rawlog");
    EXPECT_TRUE(mentions(text, {"cut.rawlog"})) << size << ": " << text;
  }
}

TEST_F(DamagedRun, RejectsChangedBytes) {
  const std::string content = read_file(path("run.rawlog"));
  RandomEngine random(1);
  for (int i = 0; i < 200; ++i) {
    std::string bytes = content;
    // The rest of the gzip header (time, hints, system) has no effect.
    const int at = uniform_int(random, 10, static_cast<int>(content.size()) - 1);
    bytes[static_cast<std::size_t>(at)] ^= static_cast<char>(1 << uniform_int(random, 0, 7));
    write("flipped.rawlog", bytes);
    const std::string text = error_of("flipped.rawlog");
    if (text == "(no error)")  // padding, or a reference to an equal earlier text
      EXPECT_EQ(unpacked(bytes), unpacked(content)) << at;
    else
      EXPECT_TRUE(mentions(text, {"flipped.rawlog"})) << at << ": " << text;
  }
}

#if defined(SLALOM_SANITIZE)
constexpr bool kMemoryIsLimited = false;  // its shadow memory cannot be limited
#else
constexpr bool kMemoryIsLimited = true;
#endif

TEST_F(DamagedRun, AnExcessiveRayCountAllocatesNoMemory) {
  save<mrpt::io::CFileOutputStream>("plain.rawlog");
  std::string bytes = read_file(path("plain.rawlog"));
  const std::string rays("\xb5\0\0\0", 4);  // 181
  bytes.replace(bytes.find(rays, bytes.find("CObservation2DRangeScan")), 4, "\xff\xff\xff\x7f");
  write("plain.rawlog", bytes);
  EXPECT_TRUE(mentions(error_of("plain.rawlog"), {"ray count", "size of the file"}))
      << error_of("plain.rawlog");
}

TEST_F(DamagedRun, AnExcessiveTextLengthAllocatesNoMemory) {
  if (!kMemoryIsLimited) GTEST_SKIP() << "memory cannot be limited under sanitizers";
  save<mrpt::io::CFileOutputStream>("plain.rawlog");
  std::string bytes = read_file(path("plain.rawlog"));
  const std::string name = "CObservationComment";
  // The version, one byte, is between the name and the length of the text.
  bytes.replace(bytes.find(name) + name.size() + 1, 4, "\xff\xff\xff\x7f");
  write("plain.rawlog", bytes);
  EXPECT_TRUE(mentions(error_of("plain.rawlog"), {"more memory"})) << error_of("plain.rawlog");
}

/// Uncompressed logs have no checksum: any change must be rejected or read, without a crash and
/// without exhausting memory.
TEST_F(DamagedRun, ChangedBytesWithoutAChecksumAreHandled) {
  if (!kMemoryIsLimited) GTEST_SKIP() << "memory cannot be limited under sanitizers";
  save<mrpt::io::CFileOutputStream>("plain.rawlog");
  ASSERT_EQ(error_of("plain.rawlog"), "(no error)");
  const std::string content = read_file(path("plain.rawlog"));
  RandomEngine random(2);
  int rejected = 0;
  for (int i = 0; i < 400; ++i) {
    std::string bytes = content;
    const auto at =
        static_cast<std::size_t>(uniform_int(random, 0, static_cast<int>(content.size()) - 1));
    bytes[at] = static_cast<char>(uniform_int(random, 0, 255));
    write("plain.rawlog", bytes);
    rejected += error_of("plain.rawlog") != "(no error)" ? 1 : 0;
  }
  EXPECT_GT(rejected, 20);
}

TEST_F(DamagedRun, RejectsOtherFiles) {
  write("text.rawlog", "[campaign]\nmethods = nd\n");
  EXPECT_TRUE(mentions(error_of("text.rawlog"), {"object 1"})) << error_of("text.rawlog");
  write("a.bag", "#ROSBAG V2.0\nE");
  EXPECT_TRUE(mentions(error_of("a.bag"), {"a.bag: ", "ROS 1 (.bag)", "slalom-replay info"}));
  write("a.mcap", "\x89MCAP0\r\n");
  EXPECT_TRUE(mentions(error_of("a.mcap"), {"a.mcap: ", "ROS 2 (.mcap)", "slalom-replay info"}));
  write("empty.rawlog", "");
  EXPECT_TRUE(mentions(error_of("empty.rawlog"), {"is empty"}));
  EXPECT_TRUE(mentions(error_of("missing.rawlog"), {"cannot be read"}));
  EXPECT_TRUE(mentions(error_of("."), {"cannot be read"}));
  const std::string other = error_text(
      ErrorKind::File, [] { read_run("/usr/share/mrpt/datasets/localization_demo.rawlog"); });
  EXPECT_TRUE(mentions(other, {"was not recorded by Slalom", "slalom-replay openloop"})) << other;
}

TEST_F(DamagedRun, ReportsAMissingKeyOfTheManifest) {
  const std::string manifest = comment(0).text;
  for (const std::string key : {"slalom_run", "campaign.ini", "scenario.yaml", "scenario.hash",
                                "method", "repetition", "seed", "task.goal", "task.seed"}) {
    comment(0).text = manifest;
    remove_key(comment(0), key);
    EXPECT_TRUE(mentions(error(), {"missing key", "'" + key + "'"})) << key << ": " << error();
  }
}

TEST_F(DamagedRun, ReportsAMissingKeyOfTheResult) {
  CObservationComment& result = comment(log_.size() - 1);
  const std::string text = result.text;
  for (const std::string key : {"outcome", "outcome_detail", "trajectory", "trajectory.hash"}) {
    result.text = text;
    remove_key(result, key);
    EXPECT_TRUE(mentions(error(), {"missing key", "'" + key + "'"})) << key << ": " << error();
  }
}

TEST_F(DamagedRun, RejectsOtherFormatVersions) {
  std::string& text = comment(0).text;
  text.replace(text.find("slalom_run = 1"), 14, "slalom_run = 2");
  EXPECT_TRUE(mentions(error(), {"format version 1"})) << error();
}

TEST_F(DamagedRun, RejectsInvalidNumbers) {
  std::string& text = comment(0).text;
  const std::string before = text;
  text.replace(text.find("seed = 7"), 8, "seed = -7");
  EXPECT_TRUE(mentions(error(), {"'seed'"})) << error();
  text = before;
  text.replace(text.find("task.goal = 9 5"), 15, "task.goal = nan 5");
  EXPECT_TRUE(mentions(error(), {"'task.goal'"})) << error();
}

TEST_F(DamagedRun, RejectsACommandThatDiffersFromTheTrajectory) {
  auto& command = dynamic_cast<CObservationOdometry&>(*log_.at(4));
  ASSERT_EQ(command.sensorLabel, "command");
  command.velocityLocal.vx = std::nextafter(command.velocityLocal.vx, 1);
  EXPECT_TRUE(mentions(error(), {"object 5", "unexpected"})) << error();
}

TEST_F(DamagedRun, RejectsAScanOfAnotherSize) {
  auto& scan = dynamic_cast<CObservation2DRangeScan&>(*log_.at(5));
  scan.resizeScan(3);
  EXPECT_TRUE(mentions(error(), {"same number of rays"})) << error();
}

TEST_F(DamagedRun, RejectsAMissingObject) {
  log_.erase(log_.begin() + 6);
  EXPECT_TRUE(mentions(error(), {"missing or extra"})) << error();
}

}  // namespace
}  // namespace slalom
