// SPDX-License-Identifier: BSD-3-Clause
#include "verbs.h"

#include <slalom/app/program.h>
#include <slalom/campaign/merge_campaign.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/merge_results.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace slalom {
namespace {

struct MergeArguments {
  std::vector<std::string> inputs;
  std::string output;
  bool allow_incomplete = false, quiet = false;
};

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return std::filesystem::equivalent(a, b, ignored);
}

/// The files, and those in the folders. The output may be in such a folder.
std::vector<std::string> input_files(const MergeArguments& arguments) {
  std::vector<std::string> files;
  for (const std::string& input : arguments.inputs) {
    if (!std::filesystem::is_directory(input)) {
      if (is_same_file(input, arguments.output))
        throw usage_error("-o " + arguments.output, "is one of the files to merge", "another file");
      files.push_back(input);
      continue;
    }
    for (const std::string& file : campaign_files(input))
      if (!is_same_file(file, arguments.output)) files.push_back(file);
  }
  if (files.empty())
    throw file_error(arguments.inputs.front(), "contains no result files", "shards (.results)");
  return files;
}

void merge(const MergeArguments& arguments) {
  const auto progress = make_terminal_progress(arguments.quiet);
  const MergeReport report = merge_campaign(input_files(arguments), arguments.output,
                                            arguments.allow_incomplete, *progress);
  if (arguments.quiet) return;
  std::cerr << arguments.output << ": " << report.runs << " of " << report.planned << " runs from "
            << count_text(report.files, "file");
  if (report.duplicates > 0) std::cerr << ", " << report.duplicates << " equal duplicates";
  std::cerr << (report.missing.empty() ? "; complete" : "; missing: " + report.missing) << "\n";
}

}  // namespace

void define_merge(CLI::App& app) {
  static MergeArguments arguments;
  CLI::App* verb = app.add_subcommand("merge", "Merge the shards of a campaign into one file");
  verb->add_option("shards", arguments.inputs,
                   "Result files (.results), or folders that contain them")
      ->required();
  verb->add_option("-o,--output", arguments.output, "The result file (.results) to write")
      ->required();
  verb->add_flag("--allow-incomplete", arguments.allow_incomplete,
                 "Also merge if runs are missing");
  verb->add_flag("--quiet", arguments.quiet, "No progress and no messages, except errors");
  verb->callback([] { merge(arguments); });
}

}  // namespace slalom
