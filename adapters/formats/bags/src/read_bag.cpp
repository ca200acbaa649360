// SPDX-License-Identifier: BSD-3-Clause
#include "bag_readers.h"
#include "chunk_data.h"

#include <slalom/core/error.h>
#include <slalom/core/read_file.h>
#include <slalom/core/temporary_file.h>
#include <slalom/core/text.h>

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

namespace slalom {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMetadata = "metadata.yaml";
constexpr const char* kExpected = "a bag of ROS (.bag, .mcap, .db3, or the folder of a .db3)";

struct Container {
  const char* begin;  ///< of the file
  const char* format;
  std::vector<BagTopic> (*read)(const std::string& path, const UseMessage& use);
};

constexpr std::array<Container, 3> kContainers = {{
    {"#ROS", "bag of ROS 1", read_ros1_bag},  // versions before 2.0: #ROSRECORD
    {"\x89MCAP", "MCAP", read_mcap_bag},
    {"SQLite format 3", "rosbag2 in SQLite", read_sqlite_bag},
}};

/// Also false for a path that cannot be looked up.
bool is_folder(const std::string& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

/// The first bytes of a file, "" if it cannot be read.
std::string first_bytes(const std::string& path) {
  std::string bytes(16, '\0');
  std::ifstream file;
  std::error_code error;
  if (fs::is_regular_file(path, error)) file.open(path, std::ios::binary);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return bytes;
}

/// The same, of a file that is compressed by zstd those of its content.
std::string begin_of(const std::string& path) {
  std::string bytes = first_bytes(path);
  if (!is_zstd(bytes)) return bytes;
  try {
    decompress_zstd_file(path, [&](std::string_view part) {
      bytes = part.substr(0, bytes.size());
      return false;
    });
  } catch (const Error&) {  // no bag
  }
  return bytes;
}

const Container* container_of(const std::string& path) {
  const std::string begin = begin_of(path);
  for (const Container& container : kContainers)
    if (starts_with(begin, container.begin)) return &container;
  return nullptr;
}

/// The files that metadata.yaml lists, in order. Old recorders wrote the folder before the name.
std::vector<std::string> listed_files(const std::string& folder) {
  const std::string path = (fs::path(folder) / kMetadata).string();
  std::vector<std::string> files;
  try {
    const YAML::Node root = YAML::Load(read_utf8(path, "the list of a bag", kMaxConfigSize));
    for (const YAML::Node& file : root["rosbag2_bagfile_information"]["relative_file_paths"])
      files.push_back((fs::path(folder) / fs::path(file.as<std::string>()).filename()).string());
  } catch (const YAML::Exception& error) {
    throw file_error(path + ":" + std::to_string(error.mark.line + 1),
                     "cannot be read (" + error.msg + ")",
                     "rosbag2_bagfile_information with relative_file_paths");
  }
  if (files.empty())
    throw file_error(path, "lists no file", "rosbag2_bagfile_information with relative_file_paths");
  return files;
}

/// Reads a bag that is compressed as a whole by way of a temporary file, which errors do not name.
std::vector<BagTopic> read_compressed_bag(const std::string& path, const Container& container,
                                          const UseMessage& use) {
  const fs::path folder = fs::temp_directory_path();
  const TemporaryFile copy((folder / fs::path(path).stem()).string());
  std::ofstream file(copy.name(), std::ios::binary);
  decompress_zstd_file(path, [&](std::string_view part) {
    file.write(part.data(), static_cast<std::streamsize>(part.size()));
    return static_cast<bool>(file);
  });
  file.close();
  if (!file) throw job_error(copy.name(), "cannot be written", "room for " + path);
  try {
    return container.read(copy.name(), use);
  } catch (const Error& error) {
    std::string message = error.what();
    const std::size_t at = message.find(copy.name());
    if (at != std::string::npos) message.replace(at, copy.name().size(), path);
    throw Error(error.kind(), message);
  }
}

std::vector<BagTopic> read_bag_file(const std::string& path, const UseMessage& use) {
  require_regular_file(path, kExpected);
  const Container* container = container_of(path);
  const bool is_compressed = is_zstd(first_bytes(path));
  if (container == nullptr) {
    if (is_compressed)  // throws if that is why
      decompress_zstd_file(path, [](std::string_view) { return true; });
    throw file_error(path, "is not a bag", kExpected);
  }
  return is_compressed ? read_compressed_bag(path, *container, use) : container->read(path, use);
}

bool is_same(const BagTopic& a, const BagTopic& b) {
  return a.name == b.name && a.type == b.type && a.encoding == b.encoding;
}

}  // namespace

Error BagPlace::error(const std::string& what, const std::string& expected) const {
  return file_error(file + ": " + unit + " " + std::to_string(position), what, expected);
}

BagFile::BagFile(const std::string& path)
    : file_(path, std::ios::binary), size_(fs::file_size(path)), place_{path} {}

std::string BagFile::take(std::uint64_t size) {
  const BagPlace begin = place_;
  advance(size);
  if (size > kMaxChunkSize)
    throw begin.error("a record of " + std::to_string(size) + " bytes",
                      "at most " + std::to_string(kMaxChunkSize));
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (!file_.read(bytes.data(), static_cast<std::streamsize>(size)))
    throw begin.error("cannot be read");
  return bytes;
}

void BagFile::skip(std::uint64_t size) {
  advance(size);
  file_.seekg(static_cast<std::streamoff>(place_.position));
}

void BagFile::advance(std::uint64_t size) {
  if (size > size_ - place_.position) throw place_.error("the file is cut off or damaged");
  place_.position += size;
}

std::string type_of_ros1(std::string_view type) {
  std::string short_type(type);
  const auto middle = short_type.find("/msg/");
  if (middle != std::string::npos) short_type.erase(middle, 4);
  return short_type;
}

bool is_bag(const std::string& path) {
  std::error_code error;
  return is_folder(path) ? fs::exists(fs::path(path) / kMetadata, error)
                         : container_of(path) != nullptr;
}

std::string bag_format(const std::string& path) {
  const Container* container = container_of(is_folder(path) ? listed_files(path).front() : path);
  return container == nullptr ? "" : container->format;
}

std::vector<BagTopic> read_bag(const std::string& path, const UseMessage& use) {
  if (!is_folder(path)) return read_bag_file(path, use);
  if (!is_bag(path))
    throw file_error(path, "a folder without metadata.yaml",
                     "a folder of rosbag2, or its files one by one");
  std::vector<BagTopic> topics;
  for (const std::string& file : listed_files(path))
    for (BagTopic& topic : read_bag_file(file, use))
      if (std::none_of(topics.begin(), topics.end(),
                       [&](const BagTopic& known) { return is_same(known, topic); }))
        topics.push_back(std::move(topic));
  return topics;
}

}  // namespace slalom
