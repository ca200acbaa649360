// SPDX-License-Identifier: BSD-3-Clause
#include "text_grid.h"
#include "view_fields.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/analysis/table_export.h>
#include <slalom/analysis/table_text.h>
#include <slalom/core/printable.h>

#include <nlohmann/json.hpp>

namespace slalom {
namespace {

std::string table_text(const DataTable& table) {
  const std::string head = table.title.empty() ? "" : printable_line(table.title) + "\n\n";
  if (table.rows == 0) return head + "(empty)\n";
  const ViewFields view = view_fields(table);
  TextGrid grid(view.header);
  for (const std::vector<std::string>& row : view.rows) {
    std::vector<TextGrid::Lines> cells;
    for (const std::string& field : row) cells.push_back({field});
    grid.add_row(std::move(cells));
  }
  return head + grid.text();
}

std::string footnote_text(const Interpretation& interpretation) {
  const std::string& footnote = interpretation.footnote;
  return footnote.empty() ? "" : "\n" + printable_line(footnote) + "\n";
}

std::string remarks_text(const Interpretation& interpretation) {
  std::string text = interpretation.remarks.empty() ? "" : "\n";
  for (const std::string& remark : interpretation.remarks)
    text += "→ " + printable_line(remark) + "\n";
  return text;
}

std::string cross_tables_text(const Interpretation& interpretation) {
  std::string text = interpretation.summary ? render_summary_text(*interpretation.summary) : "";
  for (const CrossTable& table : *interpretation.cross_tables) {
    text += (text.empty() ? "" : "\n\n") + render_cross_table_text(table);
  }
  return text + remarks_text(interpretation) + footnote_text(interpretation);
}

}  // namespace

std::string render_text(const Interpretation& interpretation) {
  if (interpretation.cross_tables) return cross_tables_text(interpretation);
  std::string text;
  for (const DataTable& table : views_of(interpretation))
    text += (text.empty() ? "" : "\n") + table_text(table);
  return text + remarks_text(interpretation) + footnote_text(interpretation);
}

std::string render_json(const Interpretation& interpretation) {
  if (interpretation.cross_tables) return render_json(*interpretation.cross_tables);
  using Json = nlohmann::ordered_json;
  Json json = {{"tables", Json::array()},
               {"remarks", interpretation.remarks},
               {"passed", interpretation.passed}};
  for (const DataTable& table : interpretation.tables) {
    json["tables"].push_back(Json::parse(render_json(table)));
  }
  if (!interpretation.footnote.empty()) json["footnote"] = interpretation.footnote;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string render_csv(const Interpretation& interpretation) {
  std::string text;
  if (interpretation.cross_tables) {
    text = render_csv(*interpretation.cross_tables);
  } else {
    for (const DataTable& table : interpretation.tables)
      text += (text.empty() ? "" : "\n") + render_csv(table);
  }
  if (interpretation.footnote.empty()) return text;
  return text + "\nfootnote\n" + csv_field(interpretation.footnote) + "\n";
}

}  // namespace slalom
