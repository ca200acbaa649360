// SPDX-License-Identifier: BSD-3-Clause
#include "address_text.h"
#include "registry.h"

#include <slalom/analysis/data_table.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/analysis/paired_comparison.h>
#include <slalom/analysis/summary.h>
#include <slalom/app/output_folder.h>
#include <slalom/app/program.h>
#include <slalom/app/testbeds.h>
#include <slalom/campaign/campaign_options.h>
#include <slalom/campaign/shards.h>
#include <slalom/core/error.h>
#include <slalom/core/hash.h>
#include <slalom/core/ini_file.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/core/version.h>
#include <slalom/io/campaign_identity.h>
#include <slalom/io/list_hash.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>
#include <slalom/ompl/ompl_planner.h>
#include <slalom/report/report.h>
#include <slalom/results/method_failures.h>
#include <slalom/results/privileged.h>
#include <slalom/results/recorded_ini.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>

namespace slalom {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct RegistryArguments {
  std::string folder, output, title = "Registry", verifications;
  bool reports = true;
};

/// A bundle in the folder.
struct Entry {
  std::string path, place;  ///< place: the path in the folder
  std::string name;         ///< in the site, from the hash of the bundle
  ResultTable runs;
  std::string scenarios;  ///< hash
  std::string list;       ///< "slalom-small", else the first digits of the hash
  std::string settings;   ///< what differs from the defaults, without the methods
  std::map<std::string, std::string> verified;  ///< what was executed again, by method
};

/// A method of an entry, a row of a table.
struct Row {
  const Entry* entry = nullptr;
  std::string method;
  std::size_t best = 1, worst = 1;  ///< ranks that the comparisons leave
  const MethodSummary* summary = nullptr;
  std::string contradicts = {};  ///< the entry with other values of the same method; "": none
};

/// Methods over the same scenarios with the same settings.
struct Group {
  std::string title;
  std::vector<const Entry*> entries;
  std::vector<SummaryTable> summaries;  ///< parallel to `entries`
  std::vector<Row> rows;                ///< by success
};

constexpr const char* kMetrics[] = {"success", "optimality", "safety"};

/// Whether a limit of time or memory, or anything else that a method did, ended a run.
bool has_method_failure(const ResultTable& runs) {
  return std::any_of(runs.outcome.begin(), runs.outcome.end(), [&](std::uint32_t outcome) {
    return is_method_failure(runs.outcomes[outcome]);
  });
}

/// The values of the campaign that are not the defaults, without names and methods: those decide
/// which results stand in one table. What a process may take does not count where it ended no run:
/// the results would be the same with more.
std::string settings_of(const ResultTable& runs, const std::string& path) {
  const Manifest& manifest = runs.manifest;
  const auto text = manifest.find(kEffectiveKey);
  if (text == manifest.end()) throw file_error(path, "does not state its settings");
  const IniFile ini = IniFile::from_text(text->second, path);
  IniFile defaults = campaign_ini(CampaignOptions(), "");
  write_options(defaults, "reference", OmplOptions(), "");
  const std::vector<std::string> unused =
      has_method_failure(runs)
          ? std::vector<std::string>()
          : std::vector<std::string>{"limits.run_wall_time", "limits.run_cpu_time",
                                     "limits.memory_mb"};
  std::vector<std::string> settings;
  for (const std::string& section : ini.sections())
    for (const std::string& key : ini.keys(section)) {
      if (starts_with(section, "method.") || section == "analysis" || section == "metrics" ||
          section == "record" || (section == "campaign" && key != "repetitions") ||
          contains(unused, section + "." + key))
        continue;
      const std::string value = ini.get(section, key).value_or("");
      if (value != defaults.get(section, key).value_or(""))
        settings.push_back(section + "." + key + " = " + value);
    }
  return join(settings, ", ");
}

/// The effective settings follow from the .ini of the file. Throws Error (File) for a statement
/// that contradicts it, also by leaving out a key, and Error for an .ini that is invalid.
void require_own_settings(const Manifest& manifest, const std::string& path) {
  const IniFile effective = campaign_ini(read_campaign_options(recorded_ini(manifest, path)), "");
  const IniFile stated = IniFile::from_text(manifest.at(kEffectiveKey), path);
  for (const char* section : {"robot", "sensor", "odometry", "simulation", "people", "limits"})
    for (const std::string& key : effective.keys(section))
      if (const auto value = effective.get(section, key);
          key != "method_errors" && stated.get(section, key) != value)
        throw file_error(path, std::string("its .ini has ") + section + "." + key + " = " +
                                   value.value_or("") + ", its manifest states " +
                                   stated.get(section, key).value_or("nothing"));
}

std::size_t count_runs(const ResultTable& runs, const std::string& method) {
  return static_cast<std::size_t>(
      std::count_if(runs.method.begin(), runs.method.end(),
                    [&](std::uint32_t index) { return runs.methods[index] == method; }));
}

/// Verifications by the registry itself, by method, from the file of the bundle in their folder. A
/// file beside the bundle may be its author's.
std::map<std::string, std::string> verification_of(const Entry& entry, const std::string& hash,
                                                   const std::string& folder) {
  const std::string path = (fs::path(folder) / (hash + "_" + version() + ".json")).string();
  if (folder.empty() || !fs::exists(path)) return {};
  const Json json = Json::parse(read_text(path, "a verification"), nullptr, false);
  std::map<std::string, std::string> verified;
  try {
    if (json.at("color") == "red") throw file_error(entry.path, "is different: " + path);
    const std::string when =
        json.at("date").get<std::string>() + ", " + json.at("processor").get<std::string>();
    for (const auto& [method, runs] : json.at("methods").items())
      verified[method] = std::to_string(runs.at("identical").get<std::size_t>()) + " of " +
                         count_text(count_runs(entry.runs, method), "run") + " verified, " + when;
  } catch (const Json::exception&) {
    throw file_error(path, "is not a verification", "what slalom-simulate verify --badge writes");
  }
  return verified;
}

Entry read_entry(const fs::path& place, const RegistryArguments& arguments) {
  const std::string path = (fs::path(arguments.folder) / place).string();
  const std::string file_hash = Hasher().add(read_file(path, "a bundle")).hex();
  Entry entry{path, place.string(), file_hash.substr(0, 16), read_results(path), "", "", "", {}};
  if (!entry.runs.damaged.empty()) throw file_error(path, "is damaged");
  const Manifest& manifest = entry.runs.manifest;
  if (manifest.count("until") > 0)
    throw file_error(path, "is of a campaign whose number of runs depends on its results",
                     "a campaign without --until");
  if (manifest.count("quick") > 0)
    throw file_error(path, "is of a sample of scenarios", "a campaign without --quick");
  const RunPlan plan = plan_of(manifest, path);
  if (plan.shard.count > 1 || entry.runs.size() != plan.runs())
    throw file_error(path, "has " + count_text(entry.runs.size(), "run"),
                     "all " + std::to_string(plan.runs()) + " of its campaign");
  const std::string hash = content_hash(entry.runs.scenario_hashes), bed = testbed_of(hash);
  entry.scenarios = hash;
  entry.list = bed.empty() ? "list " + hash.substr(0, 8) : bed;
  entry.settings = settings_of(entry.runs, path);
  require_own_settings(manifest, path);
  entry.verified = verification_of(entry, file_hash, arguments.verifications);
  mark_privileged(entry.runs);
  return entry;
}

/// The keys of a method in its campaign and the hashes of its files: two entries with the same ones
/// contain the same runs, or one of them is wrong.
std::string identity_of(const Entry& entry, const std::string& method) {
  const std::string section = "method." + unmarked_name(method) + ".";
  std::string identity = method;
  for (const auto& [key, value] : identity_parts(entry.runs.manifest))
    if (starts_with(key, section)) identity += "\n" + key + "=" + value;
  return identity;
}

/// Hash of the outcomes and metrics of a method, which are the same in the same runs.
std::string values_of(const Entry& entry, const std::string& method) {
  const ResultTable& runs = entry.runs;
  std::map<std::pair<std::string, std::uint32_t>, std::string> lines;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    if (runs.methods[runs.method[run]] != method) continue;
    Hasher hasher;
    hasher.add(runs.outcomes[runs.outcome[run]]);
    for (const ValueColumn& metric : runs.metrics)
      if (!metric.wall_clock)
        hasher.add(metric.info().id)
            .add(metric.is_na(run) ? metric.reason(run) : format_number(metric.number(run)));
    lines[{runs.scenario_hashes[runs.scenario[run]], runs.repetition[run]}] = hasher.hex();
  }
  Hasher hasher;
  for (const auto& [key, line] : lines) hasher.add(key.first).add(line);
  return hasher.hex();
}

std::vector<std::string> known_metrics(const ResultTable& runs) {
  std::vector<std::string> known;
  for (const char* id : kMetrics)
    if (id == std::string("success") || find_metric(runs, id) != nullptr) known.emplace_back(id);
  return known;
}

/// The success of two rows of one group, over the same scenarios.
PairedComparison compare_rows(const Row& a, const Row& b) {
  return compare_pair({&a.entry->runs, a.method, a.method}, {&b.entry->runs, b.method, b.method},
                      "success", {});
}

/// Sorts the rows by success, and finds the ranks that the comparisons of all pairs leave.
void rank_rows(std::vector<Row>& rows) {
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
    return a.summary->cells[0].estimate > b.summary->cells[0].estimate;
  });
  std::vector<PairedComparison> pairs;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = i + 1; k < rows.size(); ++k)
      pairs.push_back(compare_rows(rows[k], rows[i]));
  finish_families(pairs);
  for (Row& row : rows) row.worst = rows.size();
  auto pair = pairs.begin();
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = i + 1; k < rows.size(); ++k, ++pair)
      if (pair->verdict == Verdict::Better) {
        --rows[i].worst;
        ++rows[k].best;
      }
}

Group make_group(const std::vector<const Entry*>& entries) {
  Group group{"", entries, {}, {}};
  const Entry& first = *entries.front();
  group.title = first.list + ", " + count_text(first.runs.scenario_hashes.size(), "scenario") +
                (first.settings.empty() ? "" : ": " + first.settings);
  for (const Entry* entry : entries)
    group.summaries.push_back(build_summary(entry->runs, known_metrics(entry->runs), {}));
  std::map<std::string, std::vector<Row>> rows;
  for (std::size_t i = 0; i < entries.size(); ++i)
    for (const MethodSummary& method : group.summaries[i].methods)
      rows[identity_of(*entries[i], method.method)].push_back(
          {entries[i], method.method, 1, 1, &method});
  std::vector<Row> contradicting;
  for (auto& [identity, same] : rows) {
    const std::string values = values_of(*same.front().entry, same.front().method);
    const auto other = std::find_if(same.begin(), same.end(), [&](const Row& row) {
      return values_of(*row.entry, row.method) != values;
    });
    if (other == same.end()) {
      // Prefers the copy that was verified.
      const auto best = std::find_if(same.begin(), same.end(), [](const Row& row) {
        return row.entry->verified.count(unmarked_name(row.method)) > 0;
      });
      group.rows.push_back(best == same.end() ? same.front() : *best);
      continue;
    }
    for (Row& row : same) row.contradicts = (&row == &*other ? same.front() : *other).entry->place;
    std::move(same.begin(), same.end(), std::back_inserter(contradicting));
  }
  rank_rows(group.rows);
  std::move(contradicting.begin(), contradicting.end(), std::back_inserter(group.rows));
  return group;
}

std::string rank_text(const Row& row) {
  if (!row.contradicts.empty()) return "contradicts " + row.contradicts;
  return std::to_string(row.best) + (row.best == row.worst ? "" : "-" + std::to_string(row.worst));
}

Field number(const std::optional<double>& value) {
  return value ? Field(*value) : Field();
}

DataTable table_of(const Group& group) {
  DataTable table;
  table.name = table.title = group.title;
  table.columns = {"rank", "method", "success", "success.low", "success.high", "runs"};
  for (const char* id : {"optimality", "safety"}) table.columns.emplace_back(id);
  for (const char* column : {"verified", "bundle", "report"}) table.columns.emplace_back(column);
  table.rows = group.rows.size();
  table.at = [&group, columns = table.columns](std::size_t i, std::size_t column) -> Field {
    const Row& row = group.rows[i];
    const Cell& success = row.summary->cells[0];
    const std::string& id = columns[column];
    if (id == "rank") return rank_text(row);
    if (id == "method") return row.method;
    if (id == "success") return number(success.estimate);
    if (id == "success.low") return success.interval ? Field(success.interval->low) : Field();
    if (id == "success.high") return success.interval ? Field(success.interval->high) : Field();
    if (id == "runs") return static_cast<std::int64_t>(row.summary->n);
    if (id == "verified") {
      const auto verified = row.entry->verified.find(unmarked_name(row.method));
      return verified == row.entry->verified.end() ? "no" : verified->second;
    }
    if (id == "bundle") return row.entry->place;
    if (id == "report") return row.entry->name;
    const std::vector<std::string> metrics = known_metrics(row.entry->runs);
    const auto found = std::find(metrics.begin(), metrics.end(), id);
    if (found == metrics.end()) return {};
    return number(row.summary->cells[static_cast<std::size_t>(found - metrics.begin())].estimate);
  };
  return table;
}

/// The bundles of a folder and of those in it but the site, by their paths below it, in
/// alphabetical order.
std::vector<fs::path> bundles_in(const std::string& folder, const std::string& site) {
  std::vector<fs::path> paths;
  std::error_code error, ignored;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (fs::equivalent(entry->path(), site, ignored)) entry.disable_recursion_pending();
    if (entry->path().extension() == ".slalom")
      paths.push_back(entry->path().lexically_relative(folder));
  }
  if (error) throw file_error(folder, "cannot be read (" + error.message() + ")", "a folder");
  if (paths.empty()) throw file_error(folder, "contains no bundles", "files (.slalom)");
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::string without(std::string text, const std::string& beginning) {
  if (starts_with(text, beginning)) text.erase(0, beginning.size());
  return text;
}

void publish(const Entry& entry, const RegistryArguments& arguments) {
  const fs::path site(arguments.output), bundle = site / "bundles" / (entry.name + ".slalom");
  make_output_folder(bundle.parent_path().string());
  write_file_atomically(bundle.string(), read_file(entry.path));
  if (!arguments.reports) return;
  const fs::path report = site / "reports" / entry.name;
  make_output_folder(report.string());
  write_report(entry.path, entry.runs, report_options(entry.runs), report.string());
}

void registry(const RegistryArguments& arguments) {
  std::vector<Entry> entries;
  Interpretation page;
  page.remarks.emplace_back(
      "Rank by success: 2-4 means that one method is better, and that two others are not told "
      "apart "
      "from it in the same scenarios (McNemar's or Wilcoxon's test, Holm over all pairs of a "
      "table, "
      "0.05)");
  page.remarks.emplace_back(
      "Each row is repeated by: slalom-simulate verify BUNDLE --fraction 1. Verified: how many "
      "runs "
      "were executed again with identical values, by whoever made this site");
  for (const fs::path& path : bundles_in(arguments.folder, arguments.output)) {
    try {
      Entry entry = read_entry(path, arguments);
      publish(entry, arguments);
      entries.push_back(std::move(entry));
    } catch (const Error& error) {
      print_notice(std::string("left out: ") + error.what());
      page.remarks.push_back("Left out: " + without(error.what(), arguments.folder + "/"));
      page.passed = false;
    }
  }
  std::map<std::pair<std::string, std::string>, std::vector<const Entry*>> sets;
  for (const Entry& entry : entries) sets[{entry.scenarios, entry.settings}].push_back(&entry);
  std::vector<Group> groups;
  for (const auto& [key, members] : sets) groups.push_back(make_group(members));
  for (const Group& group : groups) page.tables.push_back(table_of(group));
  PrivilegedMethods privileged;
  for (const Entry& entry : entries) privileged.add(privileged_methods(entry.runs.manifest));
  page.footnote = privileged_footnote(privileged);
  std::map<std::string, std::string> names;  // by place
  for (const Entry& entry : entries) names[entry.place] = entry.name;
  const auto address_of = [&](const std::string& column, const std::string& field) {
    if (column == "bundle") return "bundles/" + names.at(field) + ".slalom";
    if (column == "report" && arguments.reports)
      return "reports/" + address_text(field) + "/index.html";
    return std::string();
  };
  const fs::path site(arguments.output);
  make_output_folder(site.string());
  write_file_atomically((site / "registry.json").string(), render_json(page));
  write_file_atomically((site / "index.html").string(),
                        render_html(page, arguments.title, address_of));
  std::cout << (site / "index.html").string() << ": " << count_text(groups.size(), "table")
            << " of " << count_text(entries.size(), "bundle") << "\n";
  if (!page.passed) throw job_error(arguments.folder, "some bundles were left out");
}

}  // namespace

void define_registry(CLI::App& app) {
  static RegistryArguments arguments;
  CLI::App* verb = app.add_subcommand(
      "registry",
      "Write a site with the results of the bundles in a folder: a table for each set "
      "of scenarios and settings");
  verb->add_option("folder", arguments.folder, "A folder with bundles (.slalom)")->required();
  verb->add_option("-o,--output", arguments.output, "Folder to write to")->required();
  verb->add_option("--verifications", arguments.verifications,
                   "Folder with what slalom-simulate verify --badge wrote there for the registry");
  verb->add_option("--title", arguments.title, "Title of the site")->capture_default_str();
  verb->add_flag("!--no-reports", arguments.reports, "Without a report of each bundle");
  verb->callback([] { registry(arguments); });
}

}  // namespace slalom
