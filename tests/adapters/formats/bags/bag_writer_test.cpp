// SPDX-License-Identifier: BSD-3-Clause
#include "bag_writers.h"

#include <slalom/bags/bag.h>
#include <slalom/bags/bag_writer.h>
#include <slalom/bags/ros_encoding.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <zlib.h>
#include <zstd.h>

namespace slalom {
namespace {

using testing::ByteList;
using testing::write_bytes;

std::uint64_t number(const std::string& bytes, std::size_t at, std::size_t size) {
  std::uint64_t value = 0;
  std::memcpy(&value, bytes.data() + at, size);
  return value;
}

std::uint32_t checksum(const std::string& bytes) {
  return std::uint32_t(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

/// A record of MCAP, with its position in the bytes around it.
struct Record {
  std::size_t begin = 0, end = 0;
  int code = 0;
  std::string content;
};

std::vector<Record> records_of(const std::string& bytes, std::size_t begin, std::size_t end) {
  std::vector<Record> records;
  for (std::size_t at = begin; at < end; at = records.back().end) {
    const auto size = std::size_t(number(bytes, at + 1, 8));
    records.push_back({at, at + 9 + size, int(number(bytes, at, 1)), bytes.substr(at + 9, size)});
  }
  EXPECT_EQ(records.back().end, end);
  return records;
}

/// The records of a chunk (times, size, checksum, method, bytes), after a check of its numbers.
std::string records_in(const Record& chunk) {
  const std::size_t method = 28 + 4, size = number(chunk.content, 16, 8);
  EXPECT_EQ(chunk.content.substr(method, 4), "zstd");
  std::string records(size, '\0');
  const std::string packed = chunk.content.substr(method + 4 + 8);
  EXPECT_EQ(packed.size(), number(chunk.content, method + 4, 8));
  EXPECT_EQ(ZSTD_decompress(records.data(), size, packed.data(), packed.size()), size);
  EXPECT_EQ(checksum(records), number(chunk.content, 24, 4));
  return records;
}

constexpr std::int64_t kStart = 1'700'000'000'000'000'000;  // ns

/// Three topics, the last one without a message, in several chunks of 1 MiB.
std::string some_bag() {
  BagWriter writer;
  const auto scans = writer.add_topic("/scan", "sensor_msgs/LaserScan");
  const auto twists = writer.add_topic("/cmd_vel", "geometry_msgs/TwistStamped");
  writer.add_topic("/other", "sensor_msgs/LaserScan");
  RosScan scan;
  scan.ranges.assign(100'000, 2.5F);
  for (int i = 0; i < 7; ++i) {
    writer.write(scans, kStart + i, encode(scan));
    writer.write(twists, kStart + i, encode(RosTwist{RosHeader{kStart, "base"}, i / 3.0, 0, 0}));
  }
  writer.add_metadata("about", {{"method", "nd"}, {"seed", "7"}});
  return writer.finish();
}

class BagFileRecords : public ::testing::Test {
 protected:
  const Record& first(int code) const {
    for (const Record& one : records_)
      if (one.code == code) return one;
    throw std::runtime_error("no record " + std::to_string(code));
  }
  std::string group_at(std::size_t begin, std::size_t size) const {
    return bag_.substr(begin, size);
  }

  std::string bag_ = some_bag();
  std::vector<Record> records_ = records_of(bag_, 8, bag_.size() - 8);
};

TEST_F(BagFileRecords, BeginAndEndAsTheFormatDemands) {
  const std::string magic("\x89MCAP0\r\n", 8);
  EXPECT_EQ(bag_.substr(0, 8), magic);
  EXPECT_EQ(bag_.substr(bag_.size() - 8), magic);
  EXPECT_EQ(records_.front().code, 0x01);
  EXPECT_EQ(records_.front().content.substr(0, 8), ByteList().text("ros2").bytes());
  EXPECT_EQ(records_.back().code, 0x02);
}

TEST_F(BagFileRecords, HaveTheChecksumsOfTheDataAndOfTheSummary) {
  const Record& end = first(0x0f);
  EXPECT_EQ(number(end.content, 0, 4), checksum(bag_.substr(0, end.begin)));
  const Record& footer = records_.back();
  const auto begin = std::size_t(number(footer.content, 0, 8));
  EXPECT_EQ(begin, end.end) << "the summary follows the data";
  EXPECT_EQ(number(footer.content, 16, 4),
            checksum(bag_.substr(begin, footer.end - sizeof(std::uint32_t) - begin)));
}

TEST_F(BagFileRecords, LeadFromTheChunkIndexesToEachMessage) {
  std::size_t messages = 0, chunks = 0;
  for (const Record& index : records_) {
    if (index.code != 0x08) continue;
    ++chunks;
    const auto begin = std::size_t(number(index.content, 16, 8));
    const auto chunk = records_of(bag_, begin, begin + number(index.content, 24, 8)).at(0);
    ASSERT_EQ(chunk.code, 0x06);
    const std::string inner = records_in(chunk);
    EXPECT_EQ(index.content.substr(0, 16), chunk.content.substr(0, 16)) << "the same times";
    const std::size_t topics = number(index.content, 32, 4) / 10;
    for (std::size_t i = 0; i < topics; ++i) {
      const auto topic = number(index.content, 36 + 10 * i, 2);
      const auto at = std::size_t(number(index.content, 38 + 10 * i, 8));
      ASSERT_EQ(bag_[at], 0x07);
      ASSERT_EQ(number(bag_, at + 9, 2), topic);
      for (std::size_t k = 0; k < number(bag_, at + 11, 4) / 16; ++k, ++messages) {
        const auto message = std::size_t(number(bag_, at + 15 + 16 * k + 8, 8));
        EXPECT_EQ(inner[message], 0x05);
        EXPECT_EQ(number(inner, message + 9, 2), topic);
        EXPECT_EQ(number(inner, message + 15, 8), number(bag_, at + 15 + 16 * k, 8)) << "its time";
      }
    }
  }
  EXPECT_GT(chunks, 1U);
  EXPECT_EQ(messages, 14U);
}

TEST_F(BagFileRecords, CountMessagesTopicsAndChunks) {
  const std::string& statistics = first(0x0b).content;
  EXPECT_EQ(number(statistics, 0, 8), 14U);  // messages
  EXPECT_EQ(number(statistics, 8, 2), 2U);   // types
  EXPECT_EQ(number(statistics, 10, 4), 3U);  // topics
  EXPECT_EQ(number(statistics, 18, 4), 1U);  // metadata
  std::size_t chunks = 0;
  for (const Record& one : records_) chunks += one.code == 0x06;
  EXPECT_EQ(number(statistics, 22, 4), chunks);
  EXPECT_EQ(number(statistics, 26, 8), std::uint64_t(kStart));
  EXPECT_EQ(number(statistics, 34, 8), std::uint64_t(kStart + 6));
}

TEST_F(BagFileRecords, HaveOffsetsOfTheGroupsOfTheSummary) {
  const auto offsets = std::size_t(number(records_.back().content, 8, 8));
  std::size_t at = std::size_t(number(records_.back().content, 0, 8));
  for (const Record& one : records_of(bag_, offsets, records_.back().begin)) {
    ASSERT_EQ(one.code, 0x0e);
    EXPECT_EQ(number(one.content, 1, 8), at);
    at += number(one.content, 9, 8);
    for (const Record& member : records_of(bag_, number(one.content, 1, 8), at))
      EXPECT_EQ(member.code, one.content[0]);
  }
  EXPECT_EQ(at, offsets) << "no record without an offset";
  const std::string& index = first(0x0d).content;
  EXPECT_EQ(bag_[std::size_t(number(index, 0, 8))], 0x0c);
  EXPECT_EQ(index.substr(16), ByteList().text("about").bytes());
}

TEST(BagWriting, TheSameCallsGiveTheSameBytesThatAreReadBack) {
  const std::string bag = some_bag();
  EXPECT_EQ(bag, some_bag());
  const std::string path = ::testing::TempDir() + "slalom_written.mcap";
  write_bytes(path, bag);
  std::vector<double> velocities;
  std::size_t scans = 0;
  const auto topics = read_bag(path, [&](const BagMessage& message) {
    if (message.topic.name == "/cmd_vel") velocities.push_back(decode_twist(message).vx);
    if (message.topic.name == "/scan") scans += decode_scan(message).ranges.size();
    EXPECT_EQ(message.time - kStart, message.topic.name == "/scan"
                                         ? std::int64_t(scans / 100'000) - 1
                                         : std::int64_t(velocities.size()) - 1);
  });
  std::filesystem::remove(path);
  EXPECT_EQ(scans, 700'000U);
  EXPECT_EQ(velocities, (std::vector<double>{0, 1 / 3.0, 2 / 3.0, 1, 4 / 3.0, 5 / 3.0, 2}));
  ASSERT_EQ(topics.size(), 3U);
  EXPECT_EQ(topics[2].name, "/other");
  EXPECT_EQ(topics[2].type, "sensor_msgs/LaserScan");
}

TEST(BagWriting, DefinitionsContainThoseOfTheirMembersOnce) {
  const std::string line(80, '=');
  EXPECT_EQ(definition_of("geometry_msgs/TwistStamped"),
            "std_msgs/Header header\ngeometry_msgs/Twist twist\n" + line +
                "\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" + line +
                "\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n" + line +
                "\nMSG: geometry_msgs/Twist\ngeometry_msgs/Vector3 linear\n"
                "geometry_msgs/Vector3 angular\n" +
                line + "\nMSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n");
  EXPECT_THROW(definition_of("std_msgs/String"), std::invalid_argument);
}

}  // namespace
}  // namespace slalom
