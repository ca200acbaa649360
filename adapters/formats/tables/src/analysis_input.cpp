// SPDX-License-Identifier: BSD-3-Clause
#include "foreign_table.h"

#include <slalom/core/error.h>
#include <slalom/core/file_format.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/io/read_results.h>
#include <slalom/io/scenario_list.h>
#include <slalom/metrics/metric.h>
#include <slalom/tables/analysis_input.h>

namespace slalom {

namespace {

CsvColumnOptions with_known_columns(CsvColumnOptions options) {
  options.known_conditional = reached_metric_ids();
  for (const Metric& metric : all_metrics()) options.known.push_back(metric.info);
  for (const Descriptor& descriptor : all_descriptors()) options.known.push_back(descriptor.info);
  return options;
}

std::string text_of_table(const std::string& path) {
  const std::string expected = "a result file (.results) or a table as CSV";
  refuse_foreign_file(path, expected);
  const std::string text = read_text(path, "a table (.csv)");
  refuse_foreign_format(text, path, expected);
  return text;
}

}  // namespace

ResultTable read_analysis_input(const std::string& path,
                                const std::optional<std::vector<std::string>>& ids, bool csv,
                                const CsvColumnOptions& options) {
  const bool is_table = !is_result_input(path) && (csv || !ends_with(path, ".results"));
  if (!is_table) return read_results(path, ids);
  return read_analysis_tables({path}, options);
}

ResultTable read_analysis_tables(const std::vector<std::string>& paths,
                                 const CsvColumnOptions& options) {
  CsvColumnOptions with_known = with_known_columns(options);
  std::vector<CsvFile> files;
  for (const std::string& path : paths) {
    const auto table = read_foreign_table(path, options.sheet);
    if (table && options.success_words.empty())
      for (const std::string& word : table->success_words) with_known.success_words.push_back(word);
    files.push_back({table ? table->csv : text_of_table(path), path});
  }
  if (files.size() == 1) return columns_from_csv(files[0].text, files[0].name, with_known);
  return columns_from_csv(files, with_known);
}

std::vector<BinSpec> resolve_indexes(std::vector<BinSpec> specs, const std::string& list_path) {
  for (BinSpec& spec : specs) {
    if (spec.kind != BinSpec::Kind::Index) continue;
    const std::string where = "rows '" + spec.descriptor + ":@" + spec.index + "'";
    if (list_path.empty()) {
      throw usage_error(where, "no scenario list for the index", "--scenarios LIST");
    }
    const ListIndex index = ScenarioList::open(list_path).index(spec.index);
    if (index.descriptor != spec.descriptor) {
      throw usage_error(where, "index of another descriptor, " + index.descriptor,
                        index.descriptor + ":@" + spec.index);
    }
    spec.kind = BinSpec::Kind::Edges;
    spec.edges = index.edges;
  }
  return specs;
}

}  // namespace slalom
