#include <slalom/analysis/privileged_marks.h>
#include <slalom/core/text.h>

namespace slalom {
namespace {

void mark(std::string& text, const PrivilegedMethods& methods) {
  text = with_privileged_marks(text, methods.names());
}

}  // namespace

PrivilegedMethods privileged_methods(const std::vector<ResultTable>& results) {
  PrivilegedMethods methods;
  for (const ResultTable& table : results) methods.add(privileged_methods(table.manifest));
  return methods;
}

void mark_privileged(DataTable& table, const PrivilegedMethods& methods) {
  if (methods.empty()) return;
  mark(table.title, methods);
  for (std::string& column : table.columns) mark(column, methods);
  table.at = [at = std::move(table.at), names = methods.names()](std::size_t row,
                                                                 std::size_t column) {
    Field field = at(row, column);
    if (auto* text = std::get_if<std::string>(&field)) *text = with_privileged_marks(*text, names);
    return field;
  };
}

void mark_privileged(SummaryTable& summary, const PrivilegedMethods& methods) {
  for (MethodSummary& method : summary.methods) mark(method.method, methods);
  summary.footnote = privileged_footnote(methods);
}

void mark_privileged(CrossTable& table, const PrivilegedMethods& methods) {
  if (!contains(methods.names(), table.method)) return;
  mark(table.title, methods);
  mark(table.method, methods);
  for (std::string& note : table.notes) mark(note, methods);
  table.footnote = privileged_footnote(methods);
}

void mark_privileged(Interpretation& interpretation, const PrivilegedMethods& methods) {
  if (methods.empty()) return;
  if (interpretation.summary) mark_privileged(*interpretation.summary, methods);
  if (interpretation.cross_tables)
    for (CrossTable& table : *interpretation.cross_tables) mark_privileged(table, methods);
  for (DataTable& table : interpretation.tables) mark_privileged(table, methods);
  for (DataTable& table : interpretation.views) mark_privileged(table, methods);
  for (std::string& remark : interpretation.remarks) mark(remark, methods);
  interpretation.footnote = privileged_footnote(methods);
}

}  // namespace slalom
