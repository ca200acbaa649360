// SPDX-License-Identifier: BSD-3-Clause
#include "badge.h"

#include <slalom/app/output_folder.h>
#include <slalom/core/hash.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/core/version.h>
#include <slalom/io/result_file.h>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <ctime>
#include <filesystem>

namespace slalom {
namespace {

struct Badge {
  std::string message, color;
};

/// The color is that of the worst method.
Badge badge_of(const VerifyReport& report) {
  if (!report.differences.empty()) return {"different", "red"};
  if (report.identical_runs() == 0) return {"not verifiable", "lightgrey"};
  const bool is_whole =
      report.unchecked.empty() &&
      std::all_of(report.methods.begin(), report.methods.end(),
                  [](const auto& one) { return one.second.identical == one.second.runs; });
  return {std::to_string(report.identical_runs()) + " of " + std::to_string(report.total_runs) +
              " runs verified",
          is_whole ? "brightgreen" : "yellow"};
}

/// A badge of two fields; its widths are those of a sans serif of 11 pixels, roughly.
std::string svg_of(const std::string& label, const Badge& badge) {
  constexpr std::size_t kCharacter = 7, kMargin = 10;
  const std::size_t left = kCharacter * label.size() + kMargin,
                    right = kCharacter * badge.message.size() + kMargin;
  const char* const color = badge.color == "red"           ? "#b62324"
                            : badge.color == "brightgreen" ? "#1a7f37"
                            : badge.color == "yellow"      ? "#9a6700"
                                                           : "#6e7781";
  return fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="20" role="img" aria-label="{4}: {5}">
<title>{4}: {5}</title>
<rect width="{0}" height="20" rx="3" fill="#3d444d"/>
<path d="M{1} 0h{2}a3 3 0 0 1 3 3v14a3 3 0 0 1-3 3h-{2}z" fill="{3}"/>
<g fill="#fff" text-anchor="middle" font-family="Verdana,DejaVu Sans,sans-serif" font-size="11">
<text x="{6}" y="14" textLength="{7}">{4}</text>
<text x="{8}" y="14" textLength="{9}">{5}</text>
</g>
</svg>
)",
      left + right, left, right - 3, color, label, badge.message, left / 2, left - kMargin,
      left + right / 2, right - kMargin);
}

std::string hash_of(const std::string& results) {
  return Hasher().add(read_file(results, "a result file or bundle")).hex();
}

std::string path_in(const std::string& folder, const std::string& hash) {
  return folder + "/" + hash + "_" + version();
}

}  // namespace

bool has_badge(const std::string& results, const std::string& folder) {
  return std::filesystem::exists(path_in(folder, hash_of(results)) + ".json");
}

void write_badge(const std::string& results, const std::string& folder, const VerifySample& sample,
                 const VerifyReport& report) {
  const std::string hash = hash_of(results);
  const std::string path = folder.empty() ? results + ".verified" : path_in(folder, hash);
  const Badge badge = badge_of(report);
  nlohmann::json methods = nlohmann::json::object();
  for (const auto& [method, verified] : report.methods)
    methods[method] = {{"runs", verified.runs}, {"identical", verified.identical}};
  const nlohmann::json json = {
      {"schemaVersion", 1},
      {"label", "slalom"},
      {"message", badge.message},
      {"color", badge.color},
      {"file_hash", hash},
      {"scenario_set", report.scenario_set},
      {"fraction", sample.fraction},
      {"seed", sample.seed ? nlohmann::json(*sample.seed) : nlohmann::json()},
      {"methods", std::move(methods)},
      {"scenarios", report.scenarios},
      {"runs", report.runs},
      {"total_runs", report.total_runs},
      {"differences", report.differences},
      {"time_limits", report.time_limits},
      {"not_repeatable", report.not_repeatable},
      {"unchecked", report.unchecked},
      {"environment", report.environment},
      {"version", version()},
      {"processor", processor_name()},
      {"date", fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)))}};
  if (!folder.empty()) make_output_folder(folder);
  write_file_atomically(path + ".json", json.dump(1) + "\n");
  write_file_atomically(path + ".svg", svg_of("slalom", badge));
}

}  // namespace slalom
