// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/io/rawlog_path.h>

#include <filesystem>

namespace slalom {
namespace {

std::string file_name(const std::string& scenario_hash, const std::string& method, int repetition) {
  return "/" + scenario_hash.substr(0, 8) + "_" + method + "_" + std::to_string(repetition);
}

}  // namespace

std::string rawlog_folder(const std::string& results_path) {
  return std::filesystem::path(results_path).replace_extension(".rawlogs").string();
}

std::string rawlog_path(const std::string& results_path, const std::string& scenario_hash,
                        const std::string& method, int repetition) {
  return rawlog_folder(results_path) + file_name(scenario_hash, method, repetition) + ".rawlog";
}

std::string bag_folder(const std::string& results_path) {
  return std::filesystem::path(results_path).replace_extension(".bags").string();
}

std::string bag_path(const std::string& results_path, const std::string& scenario_hash,
                     const std::string& method, int repetition) {
  return bag_folder(results_path) + file_name(scenario_hash, method, repetition) + ".mcap";
}

}  // namespace slalom
