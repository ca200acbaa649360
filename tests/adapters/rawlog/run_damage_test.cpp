#include "recorded_runs.h"

#include <slalom/io/result_file.h>

#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/io/CFileOutputStream.h>
#include <mrpt/obs/CObservationComment.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/serialization/CArchive.h>

#include <error_text.h>
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
    testing::make_run(path("run.rawlog"), method, setup);
    load("run.rawlog");
  }

  /// How the log, as it now is in memory, is refused.
  std::string refusal() {
    save<mrpt::io::CFileGZOutputStream>("changed.rawlog");
    return refusal_of("changed.rawlog");
  }
  std::string refusal_of(const std::string& name) const {
    return error_text(Culprit::File, [&] { read_run(path(name)); });
  }
  void load(const std::string& name) {
    mrpt::io::CFileGZInputStream file(path(name));
    auto archive = mrpt::serialization::archiveFrom(file);
    try {
      while (true) log_.push_back(archive.ReadObject());
    } catch (const mrpt::serialization::CExceptionEOF&) {
      ASSERT_GT(log_.size(), 80U);  // the whole file is read: four objects in each of 20 cycles
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
  CObservationComment& comment(std::size_t index) {
    return dynamic_cast<CObservationComment&>(*log_.at(index));
  }
  /// Takes the line of `key` out of a comment, with the indented lines that follow it.
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

bool has(const std::string& text, const std::string& word) {
  return text.find(word) != std::string::npos;
}

TEST_F(DamagedRun, AnUntouchedCopyIsRead) {
  EXPECT_EQ(refusal(), "(no error)");
}

TEST_F(DamagedRun, ATruncatedFileIsRefusedWhereverItIsCut) {
  const std::string whole = read_file(path("run.rawlog"));
  for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 97) {
    write("cut.rawlog", whole.substr(0, size));
    const std::string text = refusal_of("cut.rawlog");
    EXPECT_TRUE(has(text, "cut.rawlog")) << size << ": " << text;
  }
}

TEST_F(DamagedRun, AChangedByteIsRefused) {
  const std::string whole = read_file(path("run.rawlog"));
  RandomEngine random(1);
  for (int i = 0; i < 200; ++i) {
    std::string bytes = whole;
    // The header's last eight bytes (time, hints) and the names of systems mean nothing.
    const int at = uniform_int(random, 10, static_cast<int>(whole.size()) - 1);
    bytes[static_cast<std::size_t>(at)] ^= static_cast<char>(1 << uniform_int(random, 0, 7));
    write("flipped.rawlog", bytes);
    const std::string text = refusal_of("flipped.rawlog");
    EXPECT_TRUE(has(text, "flipped.rawlog")) << at << ": " << text;
  }
}

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kMemoryIsLimited = false;  // its shadow memory cannot be
#else
constexpr bool kMemoryIsLimited = true;
#endif

TEST_F(DamagedRun, AScanThatClaimsBillionsOfRaysTakesNoMemory) {
  save<mrpt::io::CFileOutputStream>("plain.rawlog");
  std::string bytes = read_file(path("plain.rawlog"));
  const std::string rays("\xb5\0\0\0", 4);  // 181
  bytes.replace(bytes.find(rays, bytes.find("CObservation2DRangeScan")), 4, "\xff\xff\xff\x7f");
  write("plain.rawlog", bytes);
  EXPECT_TRUE(has(refusal_of("plain.rawlog"), "more rays than the file has bytes"))
      << refusal_of("plain.rawlog");
}

TEST_F(DamagedRun, ATextThatClaimsGigabytesTakesNoMemory) {
  if (!kMemoryIsLimited) GTEST_SKIP();
  save<mrpt::io::CFileOutputStream>("plain.rawlog");
  std::string bytes = read_file(path("plain.rawlog"));
  const std::string name = "CObservationComment";
  // Its version, one byte, stands between the name and the length of the text.
  bytes.replace(bytes.find(name) + name.size() + 1, 4, "\xff\xff\xff\x7f");
  write("plain.rawlog", bytes);
  EXPECT_TRUE(has(refusal_of("plain.rawlog"), "asks for more memory"))
      << refusal_of("plain.rawlog");
}

/// Uncompressed there is no checksum: whatever is changed, it is refused or read, without a crash
/// and without taking all memory.
TEST_F(DamagedRun, ChangedBytesWithoutAChecksumDoNoHarm) {
  if (!kMemoryIsLimited) GTEST_SKIP();
  save<mrpt::io::CFileOutputStream>("plain.rawlog");
  ASSERT_EQ(refusal_of("plain.rawlog"), "(no error)");
  const std::string whole = read_file(path("plain.rawlog"));
  RandomEngine random(2);
  int refused = 0;
  for (int i = 0; i < 400; ++i) {
    std::string bytes = whole;
    const auto at =
        static_cast<std::size_t>(uniform_int(random, 0, static_cast<int>(whole.size()) - 1));
    bytes[at] = static_cast<char>(uniform_int(random, 0, 255));
    write("plain.rawlog", bytes);
    refused += refusal_of("plain.rawlog") != "(no error)" ? 1 : 0;
  }
  EXPECT_GT(refused, 20);
}

TEST_F(DamagedRun, WhatIsNoRawlogIsRefused) {
  write("text.rawlog", "[campaign]\nmethods = nd\n");
  EXPECT_TRUE(has(refusal_of("text.rawlog"), "object 1")) << refusal_of("text.rawlog");
  write("empty.rawlog", "");
  EXPECT_TRUE(has(refusal_of("empty.rawlog"), "is empty"));
  EXPECT_TRUE(has(refusal_of("missing.rawlog"), "cannot be read"));
  EXPECT_TRUE(has(refusal_of("."), "cannot be read"));
  const std::string other = error_text(
      Culprit::File, [] { read_run("/usr/share/mrpt/datasets/localization_demo.rawlog"); });
  EXPECT_TRUE(has(other, "not what a recorded run has")) << other;
}

TEST_F(DamagedRun, AManifestThatLacksAKeyIsRefusedByItsName) {
  const std::string manifest = comment(0).text;
  for (const std::string key : {"slalom_run", "campaign.ini", "scenario.yaml", "scenario.hash",
                                "method", "repetition", "seed", "task.goal", "task.seed"}) {
    comment(0).text = manifest;
    remove_key(comment(0), key);
    EXPECT_TRUE(has(refusal(), "lacks '" + key + "'")) << key << ": " << refusal();
  }
}

TEST_F(DamagedRun, AResultThatLacksAKeyIsRefusedByItsName) {
  CObservationComment& result = comment(log_.size() - 1);
  const std::string text = result.text;
  for (const std::string key : {"outcome", "outcome_detail", "trajectory", "trajectory.hash"}) {
    result.text = text;
    remove_key(result, key);
    EXPECT_TRUE(has(refusal(), "lacks '" + key + "'")) << key << ": " << refusal();
  }
}

TEST_F(DamagedRun, AnotherFormatVersionIsRefused) {
  std::string& text = comment(0).text;
  text.replace(text.find("slalom_run = 1"), 14, "slalom_run = 2");
  EXPECT_TRUE(has(refusal(), "format version 1")) << refusal();
}

TEST_F(DamagedRun, NumbersThatAreNoneAreRefused) {
  std::string& text = comment(0).text;
  const std::string before = text;
  text.replace(text.find("seed = 7"), 8, "seed = -7");
  EXPECT_TRUE(has(refusal(), "'seed'")) << refusal();
  text = before;
  text.replace(text.find("task.goal = 9 5"), 15, "task.goal = nan 5");
  EXPECT_TRUE(has(refusal(), "'task.goal'")) << refusal();
}

TEST_F(DamagedRun, ACommandThatIsNotTheTrajectorysIsRefused) {
  auto& command = dynamic_cast<CObservationOdometry&>(*log_.at(4));
  ASSERT_EQ(command.sensorLabel, "command");
  command.velocityLocal.vx = std::nextafter(command.velocityLocal.vx, 1);
  EXPECT_TRUE(has(refusal(), "object 5")) << refusal();
}

TEST_F(DamagedRun, AScanOfAnotherSizeIsRefused) {
  auto& scan = dynamic_cast<CObservation2DRangeScan&>(*log_.at(5));
  scan.resizeScan(3);
  EXPECT_TRUE(has(refusal(), "as many rays")) << refusal();
}

TEST_F(DamagedRun, AnObjectTakenOutIsMissed) {
  log_.erase(log_.begin() + 6);
  EXPECT_TRUE(has(refusal(), "missing or added")) << refusal();
}

}  // namespace
}  // namespace slalom
