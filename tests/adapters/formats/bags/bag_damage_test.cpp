// SPDX-License-Identifier: BSD-3-Clause
#include "compressions.h"
#include "message_bytes.h"
#include "sqlite_bag_writer.h"

#include <slalom/bags/bag_info.h>

#include <gtest/gtest.h>

#include <error_text.h>
#include <random>
#include <temporary_folder.h>
#include <zlib.h>

namespace slalom {
namespace {

using testing::ByteList;
using testing::kSecond;
using testing::Layout;
using testing::McapWriter;
using testing::Ros1BagWriter;
using testing::WrittenMessage;

std::vector<WrittenMessage> scans(Layout layout) {
  std::vector<WrittenMessage> messages;
  for (int i = 0; i < 8; ++i)
    messages.push_back({"/scan", "sensor_msgs/LaserScan", i * kSecond,
                        testing::scan_bytes(layout, i * kSecond, "laser", -1, 0.1F, 10,
                                            std::vector<float>(21, 2.0F + float(i)))});
  return messages;
}

class BagDamage : public ::testing::Test {
 protected:
  BagDamage() {
    for (const auto& message : scans(Layout::CdrLittle)) mcap_.add(message);
    for (const auto& message : scans(Layout::Packed)) bag_.add(message);
  }

  std::string write(const std::string& name, const std::string& bytes) const {
    testing::write_bytes(folder_ / name, bytes);
    return folder_ / name;
  }
  ::testing::AssertionResult refuses(const std::string& name, const std::string& bytes,
                                     const std::string& where,
                                     std::initializer_list<std::string> words) const {
    const std::string path = write(name, bytes);
    return throws_error(ErrorKind::File, path + ": " + where, words, [&] { read_bag_info(path); });
  }

  TemporaryFolder folder_;
  McapWriter mcap_{{"zstd", testing::zstd}};
  Ros1BagWriter bag_{{"lz4", testing::lz4}};
};

TEST_F(BagDamage, EveryCutIsNoticed) {
  for (const auto& [name, bytes] : {std::pair{"a.mcap", mcap_.bytes()}, {"a.bag", bag_.bytes()}}) {
    // Nothing is lost without MCAP's footer or the repeated connections of ROS 1.
    const std::size_t data_end =
        name[2] == 'm' ? bytes.size() - 8 - 29 - 13 : bytes.rfind("op=\4") - 8;
    for (std::size_t size = 13; size < data_end; ++size) {
      const std::string path = write(name, bytes.substr(0, size));
      EXPECT_TRUE(throws_error(ErrorKind::File, path, {"byte"}, [&] { read_bag_info(path); }))
          << size << " of " << bytes.size();
    }
  }
}

TEST_F(BagDamage, ErrorsNameTheByteOfTheChunk) {
  const std::string mcap = mcap_.bytes();
  std::string bytes = mcap;
  const std::size_t frame = bytes.find("\x28\xb5\x2f\xfd");
  bytes[frame + 9] = char(bytes[frame + 9] ^ 0x40);
  const std::size_t chunk = frame - 8 - 4 - 4 - 4 - 8 - 8 - 8 - 9;  // begin of its record
  EXPECT_TRUE(refuses("a.mcap", bytes, "byte " + std::to_string(chunk), {"decompressed"}));
  mcap_.checksum = 17;
  EXPECT_TRUE(refuses("a.mcap", mcap_.bytes(), "byte " + std::to_string(chunk), {"checksum"}));
  mcap_.checksum = std::uint32_t(
      crc32_z(0, reinterpret_cast<const Bytef*>(mcap_.chunk().data()), mcap_.chunk().size()));
  EXPECT_EQ(read_bag_info(write("a.mcap", mcap_.bytes())).messages, 8U);
}

TEST_F(BagDamage, StatedSizesAreCheckedBeforeMemoryIsAllocated) {
  const std::string huge(8, '\x7f');
  std::string bytes = mcap_.bytes();
  const std::size_t frame = bytes.find("\x28\xb5\x2f\xfd");
  bytes.replace(frame - 8 - 4 - 4 - 4 - 8, 8, huge);  // uncompressed size of the chunk
  EXPECT_TRUE(refuses("a.mcap", bytes, "byte", {"9187201950435737471", "268435456"}));
  const std::string record = std::string("\x89MCAP0\r\n", 8) + "\x06" + huge;
  EXPECT_TRUE(refuses("a.mcap", record, "byte 17", {"cut off"}));
  EXPECT_TRUE(refuses("a.bag", "#ROSBAG V2.0\n\xff\xff\xff\x7f", "byte 17", {"cut off"}));
  std::string bag = bag_.bytes();
  bag.replace(bag.find("size=") + 5, 4, "\xff\xff\xff\x7f");
  EXPECT_TRUE(refuses("a.bag", bag, "byte", {"2147483647", "268435456"}));
}

TEST_F(BagDamage, ElementsOfAMessageAreCountedAgainstItsBytes) {
  auto message = scans(Layout::CdrLittle)[0];
  const std::size_t count = message.data.size() - 4 - std::size_t{21} * 4 - 4;
  message.data.replace(count, 4, "\xff\xff\xff\xff");
  McapWriter writer;
  writer.add(message);
  const std::string path = write("a.mcap", writer.bytes());
  EXPECT_TRUE(throws_error(ErrorKind::File, path + ": byte", {"number of elements"}, [&] {
    read_bag(path, [](const BagMessage& read) { decode_scan(read); });
  }));
}

TEST_F(BagDamage, ChunksThatAreMissingAreNoticed) {
  bag_.chunk_count = 2;
  EXPECT_TRUE(refuses("a.bag", bag_.bytes(), "byte", {"after 1 chunk", "expected 2"}));
}

TEST_F(BagDamage, DatabasesAreRefusedThatAreDamagedOrExecuteSomething) {
  const auto messages = scans(Layout::CdrLittle);
  const auto refused = [&](const std::string& sql, std::initializer_list<std::string> words) {
    const std::string path = folder_ / "a.db3";
    std::remove(path.c_str());
    testing::write_sqlite_bag(path, messages, sql);
    return throws_error(ErrorKind::File, path, words, [&] { read_bag_info(path); });
  };
  EXPECT_TRUE(refused("ALTER TABLE messages RENAME TO m; CREATE VIEW messages AS SELECT * FROM m",
                      {"view", "rosbag2"}));
  EXPECT_TRUE(refused("DROP TABLE topics", {"no such table", "rosbag2"}));
  EXPECT_TRUE(refused("DELETE FROM topics", {"message 1", "no topic"}));
}

/// Any byte of any container may be wrong: the bag is read or refused by an Error.
TEST_F(BagDamage, AnyBytesAreReadOrRefused) {
  std::mt19937 random(5);
  testing::write_sqlite_bag(folder_ / "a.db3", scans(Layout::CdrBig));
  std::ifstream database(folder_ / "a.db3", std::ios::binary);
  const std::string db3{std::istreambuf_iterator<char>(database), {}};
  for (const auto& [name, bytes] :
       {std::pair{"a.mcap", mcap_.bytes()}, {"a.bag", bag_.bytes()}, {"a.db3", db3}})
    for (int i = 0; i < 300; ++i) {
      std::string damaged = bytes;
      for (unsigned n = 1 + random() % 8; n > 0; --n)
        damaged[random() % damaged.size()] = char(random() % 3 == 0 ? 0xff : random());
      const std::string path = write(name, damaged);
      try {
        read_bag(path, [](const BagMessage& message) {
          if (message.topic.type == "sensor_msgs/LaserScan") decode_scan(message);
        });
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::File) << error.what();
        EXPECT_EQ(std::string(error.what()).compare(0, path.size(), path), 0) << error.what();
      }
    }
}

}  // namespace
}  // namespace slalom
