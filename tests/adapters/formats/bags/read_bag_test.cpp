// SPDX-License-Identifier: BSD-3-Clause
#include "bag_writers.h"
#include "compressions.h"
#include "sqlite_bag_writer.h"

#include <slalom/bags/bag.h>
#include <slalom/core/read_file.h>

#include <gtest/gtest.h>

#include <error_text.h>
#include <filesystem>
#include <temporary_folder.h>
#include <zlib.h>

namespace slalom {
namespace {

using testing::ByteList;
using testing::Compression;
using testing::McapWriter;
using testing::Ros1BagWriter;
using testing::WrittenMessage;

const std::string kCdrHead("\0\1\0\0", 4);

/// Messages of two topics in order of time.
std::vector<WrittenMessage> some_messages(std::size_t count = 20) {
  std::vector<WrittenMessage> messages;
  for (std::size_t i = 0; i < count; ++i)
    messages.push_back({i % 3 == 0 ? "/scan" : "/odom",
                        i % 3 == 0 ? "sensor_msgs/LaserScan" : "nav_msgs/Odometry",
                        1'700'000'000'000'000'000 + 7'000'003 * std::int64_t(i),
                        kCdrHead + std::string(i % 7, char(i))});
  return messages;
}

std::string line(const std::string& topic, const std::string& type, std::int64_t time,
                 const std::string& data) {
  return topic + " " + type + " " + std::to_string(time) + " " + data;
}

std::vector<std::string> lines_of(const std::vector<WrittenMessage>& messages) {
  std::vector<std::string> lines;
  for (const auto& m : messages) lines.push_back(line(m.topic, m.type, m.time, m.data));
  return lines;
}

std::vector<std::string> read_lines(const std::string& path) {
  std::vector<std::string> lines;
  read_bag(path, [&](const BagMessage& m) {
    lines.push_back(line(m.topic.name, m.topic.type, m.time, std::string(m.data)));
  });
  return lines;
}

template <typename Writer>
std::string bag_of(const std::vector<WrittenMessage>& messages, Compression compression = {}) {
  Writer writer(std::move(compression));
  for (const auto& message : messages) writer.add(message);
  return writer.bytes();
}

class ReadBag : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& bytes) const {
    testing::write_bytes(folder_ / name, bytes);
    return folder_ / name;
  }
  TemporaryFolder folder_;
};

TEST_F(ReadBag, EveryContainerHasTheSameMessages) {
  const auto messages = some_messages();
  const auto expected = lines_of(messages);
  for (const Compression& method :
       {Compression{}, Compression{"lz4", testing::lz4}, Compression{"bz2", testing::bz2}})
    EXPECT_EQ(read_lines(write("a.bag", bag_of<Ros1BagWriter>(messages, method))), expected);
  for (const Compression& method :
       {Compression{}, Compression{"lz4", testing::lz4}, Compression{"zstd", testing::zstd}})
    EXPECT_EQ(read_lines(write("a.mcap", bag_of<McapWriter>(messages, method))), expected);
  testing::write_sqlite_bag(folder_ / "a.db3", messages);
  EXPECT_EQ(read_lines(folder_ / "a.db3"), expected);
}

TEST_F(ReadBag, ADatabaseIsReadInTheOrderOfTimes) {
  auto messages = some_messages();
  const auto expected = lines_of(messages);
  std::swap(messages[3], messages[11]);
  testing::write_sqlite_bag(folder_ / "a.db3", messages);
  EXPECT_EQ(read_lines(folder_ / "a.db3"), expected);
}

TEST_F(ReadBag, NothingIsMadeBesideADatabaseWithALog) {
  for (const char* name : {"a.db3", "100%? #1.db3"}) {
    const std::string path = folder_ / name;
    testing::write_sqlite_bag(path, some_messages(), "PRAGMA journal_mode = WAL");
    std::vector<std::string> lines;
    read_bag(path, [&](const BagMessage&) {
      lines.emplace_back();
      EXPECT_FALSE(std::filesystem::exists(path + "-wal"));
      EXPECT_FALSE(std::filesystem::exists(path + "-shm"));
    });
    EXPECT_EQ(lines.size(), some_messages().size());
  }
}

TEST_F(ReadBag, MessagesThatRosbag2HasCompressedAreDecompressed) {
  const auto messages = some_messages();
  auto packed = messages;
  for (auto& message : packed) message.data = testing::zstd(message.data);
  testing::write_sqlite_bag(folder_ / "a.db3", packed);
  EXPECT_EQ(read_lines(folder_ / "a.db3"), lines_of(messages));
  EXPECT_EQ(read_lines(write("a.mcap", bag_of<McapWriter>(packed))), lines_of(messages));
}

/// The bytes of mcap.dev/spec: magic, Schema (id, name, encoding, data), Channel (id, schema,
/// topic, encoding, metadata), Message (channel, sequence, log time, publish time, data), Data End.
TEST_F(ReadBag, ReadsTheBytesOfMcapsSpecification) {
  const std::string magic("\x89MCAP0\r\n", 8);
  const std::string bytes = magic +
                            std::string(
                                "\x03\x12\0\0\0\0\0\0\0"
                                "\x01\0"
                                "\x04\0\0\0a/bc"
                                "\0\0\0\0"
                                "\0\0\0\0",
                                27) +
                            std::string(
                                "\x04\x15\0\0\0\0\0\0\0"
                                "\x05\0"
                                "\x01\0"
                                "\x02\0\0\0/t"
                                "\x03\0\0\0"
                                "cdr"
                                "\0\0\0\0",
                                30) +
                            std::string(
                                "\x05\x18\0\0\0\0\0\0\0"
                                "\x05\0"
                                "\x09\0\0\0"
                                "\x01\x02\0\0\0\0\0\0"
                                "\x03\0\0\0\0\0\0\0"
                                "hi",
                                33) +
                            std::string("\x0f\x04\0\0\0\0\0\0\0\0\0\0\0", 13) + magic;
  EXPECT_EQ(read_lines(write("a.mcap", bytes)), std::vector<std::string>{"/t a/bc 513 hi"});
}

/// The bytes of wiki.ros.org/Bags/Format/2.0: records of a header with fields "name=value" and of
/// data, each with its length: the bag's header, a connection and a message outside of chunks.
TEST_F(ReadBag, ReadsTheBytesOfTheFormatOfRos1) {
  const std::string zero(4, '\0'), conn = "\x09" + std::string(3, '\0') + "conn=" + zero;
  const std::string bytes =
      "#ROSBAG V2.0\n" + std::string("\x1c\0\0\0\x04\0\0\0op=\x03", 12) +
      std::string("\x10\0\0\0chunk_count=", 16) + zero + zero +
      std::string("\x21\0\0\0\x04\0\0\0op=\x07", 12) + conn +
      std::string("\x08\0\0\0topic=/t", 12) + std::string("\x0d\0\0\0\x09\0\0\0type=a/bc", 17) +
      std::string("\x26\0\0\0\x04\0\0\0op=\x02", 12) + conn +
      std::string("\x0d\0\0\0time=\x02\0\0\0\x03\0\0\0", 17) + std::string("\x02\0\0\0hi", 6);
  EXPECT_EQ(read_lines(write("a.bag", bytes)), std::vector<std::string>{"/t a/bc 2000000003 hi"});
}

TEST_F(ReadBag, AFolderIsReadInTheOrderOfItsList) {
  const auto messages = some_messages();
  const std::vector<WrittenMessage> first(messages.begin(), messages.begin() + 8),
      second(messages.begin() + 8, messages.end());
  write("run_0.mcap", bag_of<McapWriter>(first));
  write("run_1.mcap", bag_of<McapWriter>(second));
  EXPECT_TRUE(throws_error(ErrorKind::File, folder_ / "", {"metadata.yaml"},
                           [&] { read_lines(folder_ / ""); }));
  // Recorders of 2019 listed files with the name of the folder.
  write("metadata.yaml",
        "rosbag2_bagfile_information:\n  version: 4\n  relative_file_paths:\n"
        "    - run_0.mcap\n    - run/run_1.mcap\n");
  EXPECT_EQ(read_lines(folder_ / ""), lines_of(messages));
  EXPECT_TRUE(is_bag(folder_ / ""));
  EXPECT_EQ(bag_format(folder_ / ""), "MCAP");
  std::size_t topics = read_bag(folder_ / "", [](const BagMessage&) {}).size();
  EXPECT_EQ(topics, 2U);
}

TEST_F(ReadBag, AFolderIsRefusedWhoseListIsDamaged) {
  const std::string list = folder_ / "metadata.yaml";
  for (const char* text : {"", "[", "rosbag2_bagfile_information: 3", "a: {b",
                           "rosbag2_bagfile_information: {relative_file_paths: [[a]]}"}) {
    write("metadata.yaml", text);
    EXPECT_TRUE(throws_error(ErrorKind::File, list, {"relative_file_paths"}, [&] {
      read_lines(folder_ / "");
    })) << text;
  }
  write("metadata.yaml", "\xff\xfe");
  EXPECT_TRUE(
      throws_error(ErrorKind::File, list, {":1", "not UTF-8"}, [&] { read_lines(folder_ / ""); }));
  write("metadata.yaml",
        "rosbag2_bagfile_information: {relative_file_paths: [../../../etc/passwd]}");
  EXPECT_TRUE(throws_error(ErrorKind::File, folder_ / "passwd", {"cannot be read"},
                           [&] { read_lines(folder_ / ""); }));
}

TEST_F(ReadBag, FilesThatAreCompressedAsAWholeAreReadAsTheirContent) {
  const auto messages = some_messages(200);
  testing::write_sqlite_bag(folder_ / "run_0.db3", messages);
  const std::string bytes = read_text(folder_ / "run_0.db3", "a bag");
  std::filesystem::remove(folder_ / "run_0.db3");
  const std::string packed = testing::zstd(bytes);
  const std::string path = write("run_0.db3.zstd", packed);
  EXPECT_TRUE(is_bag(path));
  EXPECT_EQ(bag_format(path), "rosbag2 in SQLite");
  EXPECT_EQ(read_lines(path), lines_of(messages));
  write("metadata.yaml", "rosbag2_bagfile_information:\n  relative_file_paths: [run_0.db3.zstd]\n");
  EXPECT_EQ(read_lines(folder_ / ""), lines_of(messages));
  // Two frames, as programs write that compress in parallel.
  write("run_0.db3.zstd", testing::zstd(bytes.substr(0, 5000)) + testing::zstd(bytes.substr(5000)));
  EXPECT_EQ(read_lines(path), lines_of(messages));
  write("a.mcap.zstd", testing::zstd(bag_of<McapWriter>(messages)));
  EXPECT_EQ(read_lines(folder_ / "a.mcap.zstd"), lines_of(messages));

  write("run_0.db3.zstd", packed.substr(0, packed.size() / 2));
  EXPECT_TRUE(throws_error(ErrorKind::File, path, {"is cut off"}, [&] { read_lines(path); }));
  std::string damaged = packed;
  damaged[damaged.size() / 2] ^= 0x55;
  write("run_0.db3.zstd", damaged);
  EXPECT_THROW(read_lines(path), Error);
  write("run_0.db3.zstd", testing::zstd("t,x,y\n"));
  EXPECT_FALSE(is_bag(path));
  EXPECT_TRUE(throws_error(ErrorKind::File, path, {"is not a bag"}, [&] { read_lines(path); }));
  // Errors name the file, not the temporary one.
  write("run_0.db3.zstd", testing::zstd(bytes.substr(0, bytes.size() / 2)));
  EXPECT_TRUE(throws_error(ErrorKind::File, path, {}, [&] { read_lines(path); }));
}

TEST_F(ReadBag, OtherFilesAreRefused) {
  for (const char* bytes : {"", "t,x,y\n", "#RO", "\x89MCA"}) {
    const std::string path = write("a.bag", bytes);
    EXPECT_FALSE(is_bag(path));
    EXPECT_TRUE(
        throws_error(ErrorKind::File, path, {"is not a bag", ".mcap"}, [&] { read_lines(path); }));
  }
  EXPECT_TRUE(throws_error(ErrorKind::File, folder_ / "none", {"cannot be read"},
                           [&] { read_lines(folder_ / "none"); }));
  EXPECT_TRUE(throws_error(ErrorKind::File, folder_ / "a.bag", {"version 2.0", "rosbag fix"},
                           [&] { read_lines(write("a.bag", "#ROSRECORD V1.2\n")); }));
}

TEST_F(ReadBag, APathThatCannotBeLookedUpIsNoBag) {
  const std::string path = folder_ / std::string(5000, 'a');
  EXPECT_FALSE(is_bag(path));
  EXPECT_TRUE(throws_error(ErrorKind::File, path, {"cannot be read"}, [&] { read_lines(path); }));
}

TEST_F(ReadBag, TopicsWithoutMessagesAreReturned) {
  McapWriter writer;
  writer.add_channel("/json", "a/b", "json");
  writer.add(some_messages()[0]);
  const auto topics = read_bag(write("a.mcap", writer.bytes()), [](const BagMessage&) {});
  ASSERT_EQ(topics.size(), 2U);
  EXPECT_EQ(topics[0].name, "/json");
  EXPECT_EQ(topics[0].type, "a/b");
  EXPECT_EQ(topics[0].encoding, "json");
}

/// The public bag laser_scan_matcher/demo/demo.bag states 5,560 bytes for an index of 278 entries,
/// of which 3,336 follow.
TEST_F(ReadBag, IndexesOfOldBagsThatStateAWrongSizeAreSkipped) {
  Ros1BagWriter writer;
  for (const auto& message : some_messages()) writer.add(message);
  writer.index_surplus = 2224;
  EXPECT_EQ(read_lines(write("a.bag", writer.bytes())), lines_of(some_messages()));
}

}  // namespace
}  // namespace slalom
