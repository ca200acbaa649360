// SPDX-License-Identifier: BSD-3-Clause
#include "mcap_format.h"
#include "wire_writer.h"

#include <slalom/bags/bag_writer.h>
#include <slalom/bags/ros_encoding.h>
#include <slalom/core/version.h>

#include <new>
#include <zlib.h>
#include <zstd.h>

namespace slalom {
namespace {

constexpr std::size_t kChunkSize = std::size_t(1) << 20;  ///< bytes, uncompressed

std::uint32_t checksum_of(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

/// "sensor_msgs/msg/LaserScan" of "sensor_msgs/LaserScan".
std::string type_of_ros2(std::string type) {
  return type.insert(type.find('/'), "/msg");
}

std::string record(McapRecord kind, const WireWriter& content) {
  return WireWriter()
      .add(kind)
      .add(static_cast<std::uint64_t>(content.bytes().size()))
      .raw(content.bytes())
      .bytes();
}

/// An array or a map, which begins with its number of bytes.
void add_list(WireWriter& writer, const WireWriter& list) {
  writer.text(list.bytes());
}

/// One frame of zstd.
std::string compress_zstd(std::string_view bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), ZSTD_CLEVEL_DEFAULT);
  if (ZSTD_isError(size) != 0) throw std::bad_alloc();
  packed.resize(size);
  return packed;
}

}  // namespace

class BagWriter::Impl {
 public:
  Impl() : file_(kMcapMagic) {
    file_ += record(McapRecord::Header, WireWriter().text("ros2").text("slalom " + version()));
  }

  std::uint16_t add_topic(const std::string& name, const std::string& type) {
    const auto found = schemas_.try_emplace(type, static_cast<std::uint16_t>(schemas_.size() + 1));
    const std::uint16_t schema = found.first->second;
    std::string records;
    if (found.second)
      records = record(McapRecord::Schema, WireWriter()
                                               .add(schema)
                                               .text(type_of_ros2(type))
                                               .text("ros2msg")
                                               .text(definition_of(type)));
    schema_records_ += records;
    const auto id = static_cast<std::uint16_t>(counts_.size());
    counts_.push_back(0);
    const std::string channel =
        record(McapRecord::Channel,
               WireWriter().add(id).add(schema).text(name).text("cdr").add(std::uint32_t{0}));
    channel_records_ += channel;
    chunk_ += records + channel;
    return id;
  }

  void write(std::uint16_t topic, std::int64_t time, const std::string& message) {
    const auto at = static_cast<std::uint64_t>(time);
    index_[topic].add(at).add(static_cast<std::uint64_t>(chunk_.size()));
    chunk_ += record(McapRecord::Message, WireWriter()
                                              .add(topic)
                                              .add(static_cast<std::uint32_t>(counts_[topic]))
                                              .add(at)
                                              .add(at)
                                              .raw(message));
    ++counts_[topic];
    times_.add(at);
    chunk_times_.add(at);
    if (chunk_.size() >= kChunkSize) end_chunk();
  }

  void add_metadata(const std::string& name, const std::map<std::string, std::string>& texts) {
    WireWriter list, content;
    for (const auto& [key, text] : texts) list.text(key).text(text);
    content.text(name);
    add_list(content, list);
    end_chunk();
    const std::string bytes = record(McapRecord::Metadata, content);
    metadata_indexes_ +=
        record(McapRecord::MetadataIndex,
               WireWriter().add(position()).add(std::uint64_t(bytes.size())).text(name));
    ++metadata_;
    file_ += bytes;
  }

  std::string finish() {
    end_chunk();
    file_ += record(McapRecord::DataEnd, WireWriter().add(checksum_of(file_)));
    const std::uint64_t begin = position();
    std::string offsets;
    add_group(McapRecord::Schema, schema_records_, offsets);
    add_group(McapRecord::Channel, channel_records_, offsets);
    add_group(McapRecord::Statistics, statistics(), offsets);
    add_group(McapRecord::ChunkIndex, chunk_indexes_, offsets);
    add_group(McapRecord::MetadataIndex, metadata_indexes_, offsets);
    const std::uint64_t offsets_begin = position();
    file_ += offsets;
    const std::string footer = record(
        McapRecord::Footer, WireWriter().add(begin).add(offsets_begin).add(std::uint32_t{0}));
    // The checksum covers the summary and the footer without itself.
    file_ += footer.substr(0, footer.size() - sizeof(std::uint32_t));
    file_ += WireWriter().add(checksum_of(std::string_view(file_).substr(begin))).bytes();
    return std::move(file_) + kMcapMagic;
  }

 private:
  /// The first and the last time of messages, ns; 0 of none.
  struct TimeRange {
    std::uint64_t first = 0, last = 0;
    bool empty = true;

    void add(std::uint64_t time) {
      first = empty ? time : std::min(first, time);
      last = empty ? time : std::max(last, time);
      empty = false;
    }
  };

  std::uint64_t position() const { return file_.size(); }

  void end_chunk() {
    if (chunk_.empty()) return;
    const std::string packed = compress_zstd(chunk_);
    const std::uint64_t begin = position();
    file_ += record(McapRecord::Chunk, WireWriter()
                                           .add(chunk_times_.first)
                                           .add(chunk_times_.last)
                                           .add(std::uint64_t(chunk_.size()))
                                           .add(checksum_of(chunk_))
                                           .text("zstd")
                                           .add(std::uint64_t(packed.size()))
                                           .raw(packed));
    const std::uint64_t end = position();
    WireWriter offsets;
    for (const auto& [topic, entries] : index_) {
      offsets.add(topic).add(position());
      WireWriter content;
      content.add(topic);
      add_list(content, entries);
      file_ += record(McapRecord::MessageIndex, content);
    }
    WireWriter content;
    content.add(chunk_times_.first).add(chunk_times_.last).add(begin).add(end - begin);
    add_list(content, offsets);
    content.add(position() - end).text("zstd");
    content.add(std::uint64_t(packed.size())).add(std::uint64_t(chunk_.size()));
    chunk_indexes_ += record(McapRecord::ChunkIndex, content);
    ++chunks_;
    chunk_.clear();
    index_.clear();
    chunk_times_ = {};
  }

  /// Appends records of one kind to the summary.
  void add_group(McapRecord kind, const std::string& records, std::string& offsets) {
    if (records.empty()) return;
    offsets += record(McapRecord::SummaryOffset,
                      WireWriter().add(kind).add(position()).add(std::uint64_t(records.size())));
    file_ += records;
  }

  std::string statistics() const {
    std::uint64_t messages = 0;
    WireWriter counts, content;
    for (std::size_t topic = 0; topic < counts_.size(); ++topic) {
      messages += counts_[topic];
      counts.add(static_cast<std::uint16_t>(topic)).add(counts_[topic]);
    }
    content.add(messages)
        .add(static_cast<std::uint16_t>(schemas_.size()))
        .add(static_cast<std::uint32_t>(counts_.size()))
        .add(std::uint32_t{0})  // attachments
        .add(metadata_)
        .add(chunks_)
        .add(times_.first)
        .add(times_.last);
    add_list(content, counts);
    return record(McapRecord::Statistics, content);
  }

  std::string file_, chunk_;
  std::string schema_records_, channel_records_, chunk_indexes_, metadata_indexes_;
  std::map<std::string, std::uint16_t> schemas_;  ///< numbers from 1 on, by type
  std::vector<std::uint64_t> counts_;             ///< messages of each topic
  std::map<std::uint16_t, WireWriter> index_;     ///< times and positions of the chunk's messages
  TimeRange times_, chunk_times_;
  std::uint32_t chunks_ = 0, metadata_ = 0;
};

BagWriter::BagWriter() : impl_(std::make_unique<Impl>()) {}
BagWriter::~BagWriter() = default;

std::uint16_t BagWriter::add_topic(const std::string& name, const std::string& type) {
  return impl_->add_topic(name, type);
}

void BagWriter::write(std::uint16_t topic, std::int64_t time, const std::string& message) {
  impl_->write(topic, time, message);
}

void BagWriter::add_metadata(const std::string& name,
                             const std::map<std::string, std::string>& texts) {
  impl_->add_metadata(name, texts);
}

std::string BagWriter::finish() {
  return impl_->finish();
}

}  // namespace slalom
