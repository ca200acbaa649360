// SPDX-License-Identifier: BSD-3-Clause
#include "pages.h"
#include "report_data.h"

#include <slalom/core/read_file.h>
#include <slalom/report/report.h>

#include <filesystem>
#include <map>

namespace slalom {
namespace {

namespace fs = std::filesystem;

bool belongs_to_pages(const fs::path& file) {
  const std::string extension = file.extension().string();
  return extension == ".html" || extension == ".js" || extension == ".css";
}

}  // namespace

std::string packed_report(const std::string& directory) {
  std::map<std::string, std::string> files = {{"packed.js", report_pages().at("packed.js")}};
  for (const auto& entry : fs::recursive_directory_iterator(directory))
    if (belongs_to_pages(entry.path()))
      files[fs::relative(entry.path(), directory).generic_string()] =
          read_file(entry.path().string());
  // A script of any type ends at "</script", wherever that stands.
  std::string json;
  for (const char c : json_text(files)) {
    if (c == '<')
      json += "\\u003c";
    else
      json += c;
  }
  const std::string page = report_pages().at("packed.html"), key = "{{files}}";
  const std::size_t at = page.find(key);
  return page.substr(0, at) + json + page.substr(at + key.size());
}

}  // namespace slalom
