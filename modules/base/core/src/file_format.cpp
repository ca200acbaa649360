// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/file_format.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

namespace slalom {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kHead = 65536;  // bytes of a file that are looked at

constexpr const char* kBagWay =
    "slalom-analyze metrics --trajectory and slalom-replay info read bags";
constexpr const char* kSheetWay = "the sheet saved as CSV";
constexpr const char* kArrowWay = "CSV, with pandas.read_feather(FILE).to_csv(NAME)";

struct Magic {
  std::string_view begin;
  const char *name, *way_in;
};

constexpr std::array kMagics = {
    Magic{"#ROSBAG"sv, "a bag of ROS 1 (.bag)", kBagWay},
    Magic{"\x89MCAP"sv, "a bag of ROS 2 (.mcap)", kBagWay},
    Magic{"\x89HDF\r\n\x1a\n"sv, "an HDF5 file", "CSV, with h5dump or pandas.read_hdf"},
    Magic{"PAR1"sv, "a Parquet file", "CSV, with pandas.read_parquet(FILE).to_csv(NAME)"},
    Magic{"ARROW1"sv, "an Arrow file", kArrowWay},
    Magic{"FEA1"sv, "a Feather file", kArrowWay},
    Magic{"\xd0\xcf\x11\xe0"sv, "an old Excel file (.xls)", kSheetWay},
    Magic{"\x1f\x8b"sv, "compressed by gzip, as rawlogs of MRPT are",
          "gunzip first; slalom-replay metrics reads rawlogs"},
    Magic{"\x28\xb5\x2f\xfd"sv, "compressed by zstd", "unzstd first"},
    Magic{"BZh"sv, "compressed by bzip2", "bunzip2 first"},
    Magic{"\xfd\x37zXZ"sv, "compressed by xz", "unxz first"},
    Magic{"\x04\x22\x4d\x18"sv, "compressed by lz4", "unlz4 first"},
    Magic{"MATLAB 5.0 MAT-file"sv, "a file of MATLAB (.mat)", "writematrix or writetable to CSV"},
    Magic{"\x93NUMPY"sv, "an array of NumPy (.npy)", "numpy.savetxt(NAME, numpy.load(FILE))"},
    Magic{"ULog\x01\x12\x35"sv, "a log of PX4 (.ulg)", "CSV, with ulog2csv"},
    Magic{"\xed\xa1\xda\x01"sv, "a log of LCM", "CSV, with lcm-logger's Python reader"},
    Magic{"%PDF"sv, "a PDF file", "CSV"},
    Magic{"\x89PNG"sv, "an image (PNG)", "CSV"},
    Magic{"\xff\xfe"sv, "a text in UTF-16", "the text saved as UTF-8"},
    Magic{"\xfe\xff"sv, "a text in UTF-16", "the text saved as UTF-8"},
    Magic{"\x7f\x45LF"sv, "a program or library (ELF)", "CSV"},
    Magic{"OMPL version"sv, "a benchmark log of OMPL",
          "ompl_benchmark_statistics.py LOG -d FILE.db, which slalom-analyze reads"},
};

bool has(const std::string& content, std::string_view part) {
  return content.find(part) != std::string::npos;
}

/// Whether a text begins with a short word that is a magic number, as a column PAR1 would.
bool is_header(const std::string& content, std::string_view begin) {
  constexpr std::size_t kShort = 6;
  return begin.size() <= kShort && begin[0] >= 'A' && begin[0] <= 'Z' &&
         is_text(content.substr(0, kHead));
}

FileFormat zip_format(const std::string& content) {
  if (has(content, "xl/"))
    return {"a workbook (.xlsx)", "slalom-analyze import reads tables of it"};
  if (has(content, "opendocument.spreadsheet"))
    return {"an OpenDocument spreadsheet (.ods)", kSheetWay};
  if (has(content, ".npy")) return {"arrays of NumPy (.npz)", "numpy.savetxt of one of them"};
  return {"a zip archive", "unzip first"};
}

std::optional<FileFormat> sqlite_format(const std::string& content) {
  if (has(content, "CREATE TABLE plannerConfigs"))
    return FileFormat{"a benchmark database of OMPL",
                      "slalom-analyze table reads it, as all verbs that take CSV do"};
  if (has(content, "CREATE TABLE topics") && has(content, "CREATE TABLE messages"))
    return FileFormat{"a bag of ROS 2 (.db3)", kBagWay};
  return std::nullopt;
}

/// Empty if it cannot be read.
std::string head_of(const std::string& path) {
  std::string head(kHead, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return head;
}

/// JSON and XML by their first characters.
std::optional<FileFormat> markup_format(const std::string& content) {
  const std::size_t first = content.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) return std::nullopt;
  const std::size_t second = content.find_first_not_of(" \t\r\n", first + 1);
  const char c = content[first], next = second == std::string::npos ? ' ' : content[second];
  if ((c == '{' && (next == '"' || next == '}')) || (c == '[' && (next == '{' || next == '['))) {
    if (has(content, "\"plans\""))
      return FileFormat{"JSON, as Bench-MR writes", "slalom-analyze table NAME.json"};
    return FileFormat{"JSON",
                      "a table NAME.json: an array of rows or arrays by column, or CSV, with "
                      "pandas.json_normalize(...).to_csv(NAME)"};
  }
  const std::string begin = lower_case(content.substr(first, 16));
  if (starts_with(begin, "<?xml") || starts_with(begin, "<!doctype") || starts_with(begin, "<html"))
    return FileFormat{"XML or HTML", "CSV, with pandas.read_xml or pandas.read_html"};
  return std::nullopt;
}

}  // namespace

std::optional<FileFormat> recognize_format(const std::string& content) {
  for (const auto& [begin, name, way_in] : kMagics)
    if (starts_with(content, begin) && !is_header(content, begin)) return FileFormat{name, way_in};
  if (starts_with(content, "PK\x03\x04")) return zip_format(content);
  if (starts_with(content, "SQLite format 3")) return sqlite_format(content);
  if (content.size() > 2 && content[0] == '\x80' && content[1] >= 2 && content[1] <= 5)
    return FileFormat{"a pickle of Python", "CSV, with pandas.read_pickle(FILE).to_csv(NAME)"};
  return markup_format(content);
}

void refuse_foreign_format(const std::string& content, const std::string& path,
                           const std::string& expected, bool text) {
  if (const auto format = recognize_format(content))
    throw file_error(path, "is " + format->name, expected + "; way in: " + format->way_in);
  if (text && starts_with(content, "SQLite format 3"))
    throw file_error(path, "is an SQLite file, as bags of ROS 2 (.db3) are",
                     expected + "; way in: " + kBagWay);
  if (text && !is_text(content.substr(0, kHead)))
    throw file_error(path, "has an unknown format", expected);
}

std::optional<FileFormat> recognize_file(const std::string& path) {
  return recognize_format(head_of(path));
}

void refuse_foreign_file(const std::string& path, const std::string& expected) {
  refuse_foreign_format(head_of(path), path, expected, false);
}

}  // namespace slalom
