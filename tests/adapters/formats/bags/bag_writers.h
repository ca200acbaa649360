// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace slalom::testing {

/// The bytes of numbers and texts as messages have them: of ROS 1 and of the containers without
/// gaps, of CDR aligned, little- or big-endian.
class ByteList {
 public:
  enum class Layout { Packed, CdrLittle, CdrBig };

  explicit ByteList(Layout layout = Layout::Packed) : layout_(layout) {
    if (layout != Layout::Packed)
      bytes_ = std::string({0, char(layout == Layout::CdrLittle), 0, 0});
  }

  template <typename T>
  ByteList& add(T value) {
    if (layout_ != Layout::Packed)
      while ((bytes_.size() - 4) % sizeof(T) != 0) bytes_ += '\0';
    std::string bytes(sizeof(T), '\0');
    std::memcpy(bytes.data(), &value, sizeof(T));
    if (layout_ == Layout::CdrBig) bytes = std::string(bytes.rbegin(), bytes.rend());
    bytes_ += bytes;
    return *this;
  }
  ByteList& text(const std::string& text) {
    const std::string end = layout_ == Layout::Packed ? "" : std::string(1, '\0');
    return add(std::uint32_t(text.size() + end.size())).raw(text + end);
  }
  ByteList& raw(const std::string& bytes) {
    bytes_ += bytes;
    return *this;
  }
  ByteList& doubles(const std::vector<double>& values) {
    for (const double value : values) add(value);
    return *this;
  }
  ByteList& floats(const std::vector<float>& values) {
    for (const float value : values) add(value);
    return *this;
  }
  ByteList& header(std::int64_t stamp, const std::string& frame) {
    if (layout_ == Layout::Packed) add(std::uint32_t{7});  // the number of ROS 1
    return add(std::int32_t(stamp / 1'000'000'000))
        .add(std::uint32_t(stamp % 1'000'000'000))
        .text(frame);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  Layout layout_;
  std::string bytes_;
};

/// A message to write, with its topic.
struct WrittenMessage {
  std::string topic, type;  ///< "sensor_msgs/LaserScan"
  std::int64_t time = 0;    ///< ns
  std::string data;
};

/// How to compress a chunk, with the name of the method.
struct Compression {
  std::string name;
  std::function<std::string(const std::string&)> compress;
};

inline void write_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// "sensor_msgs/msg/LaserScan"
inline std::string type_of_ros2(std::string type) {
  return type.insert(type.find('/'), "/msg");
}

/// A file of MCAP (mcap.dev/spec): one chunk, and records that readers skip.
class McapWriter {
 public:
  explicit McapWriter(Compression compression = {}) : compression_(std::move(compression)) {}

  void add(const WrittenMessage& message) {
    if (channels_.count(message.topic) == 0) add_channel(message.topic, message.type);
    record(chunk_, 0x05,
           ByteList()
               .add(channels_[message.topic])
               .add(std::uint32_t{1})
               .add(message.time)
               .add(message.time)
               .raw(message.data));
  }
  void add_channel(const std::string& topic, const std::string& type,
                   const std::string& encoding = "cdr") {
    const auto id = static_cast<std::uint16_t>(channels_.size() + 1);
    channels_[topic] = id;
    record(chunk_, 0x03, ByteList().add(id).text(type_of_ros2(type)).text("ros2msg").text(""));
    record(chunk_, 0x04,
           ByteList().add(id).add(id).text(topic).text(encoding).add(std::uint32_t{0}));
  }

  std::uint32_t checksum = 0;  ///< of the chunk; 0: none

  const std::string& chunk() const { return chunk_.bytes(); }
  std::string bytes() const {
    ByteList file;
    file.raw(std::string("\x89MCAP0\r\n", 8));
    record(file, 0x01, ByteList().text("ros2").text("test"));
    const std::string packed =
        compression_.compress ? compression_.compress(chunk_.bytes()) : chunk_.bytes();
    record(file, 0x06,
           ByteList()
               .add(std::int64_t{0})
               .add(std::int64_t{0})
               .add(std::uint64_t(chunk_.bytes().size()))
               .add(checksum)
               .text(compression_.name)
               .add(std::uint64_t(packed.size()))
               .raw(packed));
    record(file, 0x0c, ByteList().text("rosbag2").add(std::uint32_t{0}));  // metadata
    record(file, 0x0f, ByteList().add(std::uint32_t{0}));
    record(file, 0x02, ByteList().raw(std::string(20, '\0')));
    return file.raw(std::string("\x89MCAP0\r\n", 8)).bytes();
  }

 private:
  static void record(ByteList& file, std::uint8_t code, const ByteList& data) {
    file.add(code).add(std::uint64_t(data.bytes().size())).raw(data.bytes());
  }

  Compression compression_;
  ByteList chunk_;
  std::map<std::string, std::uint16_t> channels_;
};

/// A bag of ROS 1 (wiki.ros.org/Bags/Format/2.0): one chunk, its index, and the final records.
class Ros1BagWriter {
 public:
  explicit Ros1BagWriter(Compression compression = {}) : compression_(std::move(compression)) {}

  void add(const WrittenMessage& message) {
    if (connections_.count(message.topic) == 0) {
      const auto id = static_cast<std::uint32_t>(connections_.size());
      connections_[message.topic] = id;
      const std::string connection =
          record({code(7), {"conn", number(id)}, {"topic", message.topic}},
                 fields({{"topic", message.topic}, {"type", message.type}, {"md5sum", "*"}}));
      chunk_ += connection;
      final_ += connection;
    }
    const std::string time = number(std::uint32_t(message.time / 1'000'000'000)) +
                             number(std::uint32_t(message.time % 1'000'000'000));
    chunk_ += record({code(2), {"conn", number(connections_[message.topic])}, {"time", time}},
                     message.data);
  }

  std::uint32_t chunk_count = 1;    ///< as stated in the header
  std::uint32_t index_surplus = 0;  ///< stated bytes of the index record that do not follow

  std::string bytes() const {
    const bool is_packed = static_cast<bool>(compression_.compress);
    const std::string packed = is_packed ? compression_.compress(chunk_) : chunk_;
    const std::string chunk = record({code(5),
                                      {"compression", is_packed ? compression_.name : "none"},
                                      {"size", number(std::uint32_t(chunk_.size()))}},
                                     packed);
    std::string index =
        record({code(4), {"ver", number(1)}, {"conn", number(0)}, {"count", number(1)}}, "");
    index.resize(index.size() - 4);
    index += number(12 + index_surplus) + std::string(12, '\1');
    const std::string head = record({code(3),
                                     {"index_pos", std::string(8, '\1')},
                                     {"conn_count", number(1)},
                                     {"chunk_count", number(chunk_count)}},
                                    std::string(64, ' '));
    return "#ROSBAG V2.0\n" + head + chunk + index + final_;
  }

 private:
  using Field = std::pair<std::string, std::string>;

  static std::string number(std::uint32_t value) { return ByteList().add(value).bytes(); }
  static Field code(std::uint8_t value) { return {"op", std::string(1, char(value))}; }
  static std::string fields(const std::vector<Field>& fields) {
    ByteList list;
    for (const auto& [name, value] : fields) list.text(name + "=" + value);
    return list.bytes();
  }
  static std::string record(const std::vector<Field>& header, const std::string& data) {
    return ByteList().text(fields(header)).text(data).bytes();
  }

  Compression compression_;
  std::string chunk_, final_;
  std::map<std::string, std::uint32_t> connections_;
};

}  // namespace slalom::testing
