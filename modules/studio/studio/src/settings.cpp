// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/io/result_file.h>
#include <slalom/studio/settings.h>

#include <algorithm>
#include <filesystem>

namespace slalom {
namespace {

constexpr const char* kWindowSection = "window";

}  // namespace

void remember_file(RecentFiles& files, const std::string& path) {
  const std::filesystem::path file(path);
  if (file.extension() != ".scenarios" && file.extension() != ".results") return;
  std::error_code error;
  const std::string absolute = std::filesystem::absolute(file, error).lexically_normal().string();
  if (error || !IniFile::can_hold(absolute)) return;
  auto* place = std::find(files.begin(), files.end(), absolute);
  if (place == files.end()) --place;
  std::rotate(files.begin(), place, place + 1);
  files.front() = absolute;
}

void StudioSettings::visit(OptionVisitor& v) {
  v.option("scale", scale, "-",
           "screen pixels per pixel of the window, 0.5 to 4; 0: that of the desktop",
           Range::between(0, kMaxScale));
  v.option("width", width, "pixels", "of the window", Range::between(640, 8192));
  v.option("height", height, "pixels", "of the window", Range::between(480, 8192));
  v.option("list_width", list_width, "pixels", "of list and descriptors at the left",
           Range::between(0, 8192));
  v.option("descriptors_height", descriptors_height, "pixels", "of the descriptors",
           Range::between(0, 8192));
  v.option("results_height", results_height, "pixels", "of the results", Range::between(0, 8192));
  v.option("theme", theme, "colors of the window");
  v.option("grid", grid, "whether the list is a grid of pictures");
  v.option("legend", legend, "whether the list of layers is open");
  v.option("layers", layers, "visible layers, comma separated");
  for (std::size_t i = 0; i < recent.size(); ++i)
    v.option("recent_" + std::to_string(i + 1), recent[i], "a file of the menu File");
}

StudioSettings read_studio_settings(const std::string& path) {
  if (!std::filesystem::exists(path)) return {};
  const IniFile ini = IniFile::load(path);
  ini.reject_unknown_sections({kWindowSection});
  return read_options<StudioSettings>(ini, kWindowSection);
}

void write_studio_settings(const StudioSettings& settings, const std::string& path) {
  IniFile ini = IniFile::from_text("", path);
  write_options(ini, kWindowSection, settings, path);
  std::error_code error;
  const auto folder = std::filesystem::path(path).parent_path();
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  if (error) throw job_error(folder.string(), "cannot be created: " + error.message());
  write_file_atomically(path, ini.canonical_text());
}

}  // namespace slalom
