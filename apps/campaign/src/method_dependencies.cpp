// SPDX-License-Identifier: BSD-3-Clause
#include "onnx_external_data.h"

#include <slalom/app/adapters.h>
#include <slalom/app/method_dependencies.h>
#include <slalom/core/child_process.h>
#include <slalom/core/error.h>
#include <slalom/core/program_path.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/library/library_method.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

namespace slalom {
namespace {

namespace fs = std::filesystem;

/// Prints the files that a Python file imports from its own folder, also in functions.
constexpr const char* kFindImports =
    "import os, sys\n"
    "from modulefinder import ModuleFinder\n"
    "path = os.path.abspath(sys.argv[1])\n"
    "finder = ModuleFinder([os.path.dirname(path)])\n"
    "finder.run_script(path)\n"
    "for module in finder.modules.values():\n"
    "    if module.__file__: print(os.path.abspath(module.__file__))\n";

/// Absolute, also if the path has no folder, whose parent is "".
fs::path whole_path(const std::string& path) {
  return fs::absolute(path).lexically_normal();
}

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

/// Whether the file is of the system or of Slalom: its version is known otherwise.
bool is_of_system(const fs::path& path) {
  std::error_code ignored;
  const std::string file = fs::canonical(path, ignored).string();
  const auto is_below = [&](const std::string& folder) {
    return !folder.empty() && starts_with(file, folder + "/");
  };
  return (is_below("/usr") && !is_below("/usr/local")) || is_below(shipped_folder()) ||
         is_below(program_folder());
}

/// Separators of the words of an option, also of a command line with quotes, assignments and
/// several commands.
constexpr const char* kSeparators = " '\"();&|<>=,";

std::vector<std::string> words_of(std::string text) {
  for (char& c : text)
    if (std::string(kSeparators).find(c) != std::string::npos) c = ' ';
  return split(text, ' ');
}

std::string find_program(const std::string& name) {
  const char* const path = std::getenv("PATH");
  if (path == nullptr || name.find('/') != std::string::npos) return "";
  for (const std::string& folder : split(path, ':'))
    if (is_file(fs::path(folder) / name)) return (fs::path(folder) / name).string();
  return "";
}

/// The lines that a program prints; none if it fails, which those who load the file will explain.
std::vector<std::string> output_of(const std::vector<std::string>& command) {
  std::vector<std::string> lines;
  try {
    execute_program(
        command, [&](const std::string& line) { lines.push_back(line); }, [] {});
  } catch (const Error&) {  // not installed
    return {};
  }
  return lines;
}

std::vector<std::string> linked_libraries(const std::string& path) {
  std::vector<std::string> libraries;
  for (const std::string& line : output_of({"ldd", path})) {  // "NAME => PATH (ADDRESS)"
    const std::size_t begin = line.find("=> /"), end = line.rfind(" (");
    if (begin != std::string::npos && end != std::string::npos && end > begin + 3)
      libraries.push_back(line.substr(begin + 3, end - begin - 3));
  }
  return libraries;
}

std::vector<std::string> imported_modules(const std::string& path) {
  return output_of({"python3", "-I", "-S", "-W", "ignore", "-c", kFindImports, path});
}

/// The files of tensors outside of a model that are below its folder, also behind links: a model
/// may be a stranger's, and must not name private files.
std::vector<std::string> external_data(const std::string& path) {
  const fs::path folder = whole_path(path).parent_path();
  std::vector<std::string> files;
  for (const std::string& location : onnx_external_data(read_file(path, "a model"))) {
    std::error_code error;
    const fs::path file = fs::weakly_canonical(folder / location, error);
    const fs::path below = file.lexically_relative(fs::weakly_canonical(folder, error));
    if (!error && fs::path(location).is_relative() && !below.empty() && *below.begin() != "..")
      files.push_back((folder / location).string());
  }
  return files;
}

/// The kinds of files that depend on others; those of one kind are found all at once.
enum class FileKind { Binary, Python, Model, Other };

FileKind kind_of(const std::string& path) {
  std::string head(4, ' ');
  std::ifstream(path, std::ios::binary).read(head.data(), 4);
  if (head ==
      "\x7f"
      "ELF")
    return FileKind::Binary;
  const std::string extension = fs::path(path).extension().string();
  if (extension == ".py") return FileKind::Python;
  return extension == ".onnx" ? FileKind::Model : FileKind::Other;
}

std::vector<std::string> dependencies_of(const std::string& path, FileKind kind) {
  switch (kind) {
    case FileKind::Binary:
      return linked_libraries(path);
    case FileKind::Python:
      return imported_modules(path);
    case FileKind::Model:
      return external_data(path);
    default:
      return {};
  }
}

/// The file that a word of an option names, relative to the current folder or to that of the .ini;
/// in a command line also a program in PATH. Empty: none.
std::string find_named_file(bool is_command, const std::string& word, const fs::path& folder) {
  if (word.empty()) return "";
  if (!is_command && word.find_first_of("./") == std::string::npos) return "";
  for (const fs::path& path : {fs::path(word), folder / word})
    if (is_file(path)) return path.string();
  return is_command ? find_program(word) : "";
}

/// Collects the files of one option of a method.
class FilesOfOption {
 public:
  FilesOfOption(std::string option, std::map<std::string, std::string>& files)
      : option_(std::move(option)), files_(files) {}

  /// Adds what the file, which is known itself, depends on.
  void add_dependencies(const std::string& path) {
    const fs::path file = whole_path(path);
    known_.insert(file);
    const FileKind kind = kind_of(path);
    for (const std::string& other : dependencies_of(path, kind))
      add(other, file.parent_path(), kind);
  }

  /// Adds a file that an option names, if there is one, and what it depends on.
  void add_named(const std::string& path) {
    if (!path.empty()) add(path, whole_path(path).parent_path(), FileKind::Other);
  }

 private:
  /// Adds a file and what it depends on, unless that is known from one of the kind `parent`. Its
  /// name is relative to `folder`.
  void add(const std::string& path, const fs::path& folder, FileKind parent) {
    if (!is_file(path) || is_of_system(path)) return;
    const fs::path file = whole_path(path);
    if (!known_.insert(file).second) return;
    const std::string name = file.lexically_relative(folder).string();
    // Other folders may be elsewhere on another machine.
    const bool is_below = !name.empty() && !starts_with(name, "..");
    std::string key = option_ + "/" + (is_below ? name : file.filename().string());
    while (files_.count(key) > 0) key += "+";
    files_[key] = path;
    if (kind_of(path) != parent) add_dependencies(path);
  }

  std::string option_;
  std::map<std::string, std::string>& files_;
  std::set<fs::path> known_;
};

}  // namespace

std::map<std::string, std::string> dependencies_of_methods(
    const IniFile& ini, const std::vector<std::string>& sections,
    const std::map<std::string, std::string>& files) {
  std::map<std::string, std::string> found;
  for (const auto& [option, path] : files)
    if (!is_of_system(path)) FilesOfOption(option, found).add_dependencies(path);
  const fs::path folder = ini.folder();
  for (const std::string& section : sections)
    for (const std::string& key : ini.keys(section)) {
      if (files.count(section + "." + key) > 0) continue;
      const bool is_command = external_use(ini, section, key) == External::Command;
      FilesOfOption option(section + "." + key, found);
      for (const std::string& word : words_of(ini.get(section, key).value_or("")))
        option.add_named(find_named_file(is_command, word, folder));
    }
  return found;
}

std::string with_named_file(const std::string& text, const std::string& path) {
  const fs::path name = fs::path(path).filename();
  std::string replaced;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(kSeparators, at), text.size());
    const std::string word = text.substr(at, end - at);
    replaced += fs::path(word).filename() == name ? path : word;
    if (end < text.size()) replaced += text[end];
    at = end + 1;
  }
  return replaced;
}

}  // namespace slalom
