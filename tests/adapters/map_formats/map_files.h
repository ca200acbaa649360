#pragma once

#include "error_text.h"

#include <mrpt/io/CFileGZInputStream.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdlib.h>
#include <string>
#include <vector>

namespace slalom {

/// A temporary folder for the files of one test.
class MapFolder {
 public:
  MapFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "slalom-maps-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no folder " + pattern);
    folder_ = pattern;
  }
  ~MapFolder() { std::filesystem::remove_all(folder_); }
  MapFolder(const MapFolder&) = delete;
  MapFolder& operator=(const MapFolder&) = delete;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

 private:
  std::filesystem::path folder_;
};

inline std::string bytes_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The decompressed content of a file.
inline std::string decompressed(const std::string& path) {
  mrpt::io::CFileGZInputStream file(path);
  std::string all, part(1 << 16, '\0');
  while (const std::size_t got = file.Read(part.data(), part.size())) all.append(part, 0, got);
  return all;
}

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace slalom
