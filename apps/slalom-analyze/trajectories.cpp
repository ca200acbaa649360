// SPDX-License-Identifier: BSD-3-Clause
#include "output.h"
#include "trajectories.h"
#include "warnings.h"

#include <slalom/analysis/data_table.h>
#include <slalom/app/output_folder.h>
#include <slalom/app/program.h>
#include <slalom/core/error.h>
#include <slalom/io/find_run.h>
#include <slalom/io/rawlog_path.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>
#include <slalom/metrics/metric.h>
#include <slalom/report/report.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <optional>

namespace slalom {
namespace {

struct TrajectoryArguments {
  std::string results, format = "csv", run, output;
  bool quiet = false;
};

/// The columns of a file, and the number of a sample in each but the last.
constexpr std::array<const char*, 12> kColumns = {
    "t",  "x",         "y",         "phi",        "v",        "w",
    "vy", "command_v", "command_w", "command_vy", "traveled", "clearance"};

std::array<double, kColumns.size() - 1> numbers_of(const Sample& s) {
  return {s.t,  s.pose.x,    s.pose.y,    s.pose.phi,   s.v,       s.w,
          s.vy, s.command_v, s.command_w, s.command_vy, s.traveled};
}

/// The samples of runs of a result file with their clearances; keeps the world of the last
/// scenario.
class TrajectorySource {
 public:
  explicit TrajectorySource(const std::string& path)
      : file_(ResultFile::open(path)), options_(report_options(read_results(path))) {}

  const ResultFile& file() const { return file_; }

  std::string text(const RunRecord& run, bool json) {
    if (!world_ || scenario_ != run.scenario_hash)
      world_.emplace(file_.read_scenario(run.scenario_hash), options_.simulation.resolution);
    scenario_ = run.scenario_hash;
    const std::vector<Sample> samples = file_.read_trajectory(run).samples;
    DataTable table;
    table.name = run_id(run);
    table.title = run.scenario_name + ", " + run.method + ": " + run.outcome;
    table.columns.assign(kColumns.begin(), kColumns.end());
    table.rows = samples.size();
    table.at = [&](std::size_t row, std::size_t column) {
      const Sample& sample = samples[row];
      const double number = column + 1 < kColumns.size()
                                ? numbers_of(sample)[column]
                                : footprint_clearance(*world_, options_.robot.shape(), sample.pose);
      return std::isnan(number) ? Field() : Field(number);
    };
    return json ? render_json(table) : render_csv(table);
  }

 private:
  ResultFile file_;
  ReportOptions options_;
  std::string scenario_;
  std::optional<World> world_;
};

/// The file of a run, named as its rawlog.
std::string file_name(const RunRecord& run, const std::string& format) {
  const std::string rawlog = rawlog_path("", run.scenario_hash, run.method, run.repetition);
  return std::filesystem::path(rawlog).filename().replace_extension(format).string();
}

void write_all(TrajectorySource& source, const TrajectoryArguments& arguments) {
  if (arguments.output.empty() || arguments.output == "-")
    throw usage_error("--output", "missing", "a folder, or --run for a single run");
  const std::filesystem::path folder = arguments.output;
  make_output_folder(arguments.output);
  std::size_t count = 0;
  std::vector<std::string> damaged;
  source.file().for_each_run(
      [&](const RunRecord& run) {
        const std::string name = file_name(run, arguments.format);
        write_file_atomically((folder / name).string(),
                              source.text(run, arguments.format == "json"));
        ++count;
      },
      [&](const std::string& what) { damaged.push_back(what); });
  warn_of_damage(arguments.results, damaged);
  if (!arguments.quiet) std::cerr << arguments.output << ": " << count << " trajectories\n";
}

void run(const TrajectoryArguments& arguments) {
  TrajectorySource source(arguments.results);
  if (arguments.run.empty()) return write_all(source, arguments);
  const RunRecord found = find_run(source.file(), arguments.run);
  print_or_write(source.text(found, arguments.format == "json"), arguments.output);
}

}  // namespace

void define_trajectories(CLI::App& app) {
  static TrajectoryArguments arguments;
  CLI::App* verb = app.add_subcommand(
      "trajectories", "Export the trajectories of runs with poses, commands and clearances");
  verb->add_option("results", arguments.results, "A result file (.results)")->required();
  verb->add_option("--format", arguments.format, "csv, or json")
      ->check(CLI::IsMember({"csv", "json"}))
      ->capture_default_str();
  verb->add_option("--run", arguments.run, "Only this run: SCENARIO/METHOD/REPETITION");
  verb->add_option("-o,--output", arguments.output,
                   "Folder for a file per run; with --run the file, instead of standard output");
  verb->add_flag("--quiet", arguments.quiet, "No messages");
  verb->callback([] { run(arguments); });
}

}  // namespace slalom
