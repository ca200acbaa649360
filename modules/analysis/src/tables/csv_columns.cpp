#include <slalom/analysis/csv_columns.h>
#include <slalom/analysis/table_export.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <optional>

namespace slalom {
namespace {

/// The fields of the record that begins at `position`, which is advanced past it; counts lines.
std::vector<std::string> next_record(const std::string& text, std::size_t& position,
                                     std::size_t& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (; position < text.size(); ++position) {
    const char c = text[position];
    if (quoted && c == '"' && position + 1 < text.size() && text[position + 1] == '"') {
      fields.back() += text[++position];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      fields.emplace_back();
    } else if (c == '\n' && !quoted) {
      ++position;
      ++line;
      break;
    } else if (c != '\r' || quoted) {
      line += c == '\n' ? 1 : 0;
      fields.back() += c;
    }
  }
  return fields;
}

/// The text of a field, without the apostrophe that csv_field() adds to formulas.
std::string text_of_field(const std::string& field) {
  const std::string text = trim(field);
  return !text.empty() && text[0] == '\'' && is_formula(text.substr(1)) ? text.substr(1) : text;
}

bool is_missing(const std::string& field) {
  return field.empty() || field == "NA" || field == "nan" || field == "NaN";
}

bool is_key(const std::string& name) {
  for (const char* key : {"scenario", "scenario_hash", "method", "repetition", "outcome"}) {
    if (name == key) return true;
  }
  return false;
}

/// The file by columns.
class CsvTable {
 public:
  CsvTable(const std::string& text, const std::string& name) : name_(name) {
    std::size_t position = 0, line = 1;
    header_ = next_record(text, position, line);
    for (std::string& id : header_) id = text_of_field(id);
    fields_.resize(header_.size());
    while (position < text.size()) {
      const std::size_t at = line;
      std::vector<std::string> record = next_record(text, position, line);
      if (record.size() == 1 && record[0].empty()) continue;
      require_width(record.size(), at);
      for (std::size_t i = 0; i < record.size(); ++i)
        fields_[i].push_back(text_of_field(record[i]));
      ++rows_;
    }
    if (rows_ == 0) throw file_error(name_, "no rows", "a header line and rows of numbers");
  }

  std::size_t rows() const { return rows_; }
  const std::vector<std::string>& header() const { return header_; }
  const std::vector<std::string>& column(std::size_t i) const { return fields_[i]; }
  const std::vector<std::string>* find(const std::string& id) const {
    const auto found = std::find(header_.begin(), header_.end(), id);
    if (found == header_.end()) return nullptr;
    return &fields_[static_cast<std::size_t>(found - header_.begin())];
  }

 private:
  std::string name_;
  std::vector<std::string> header_;
  std::vector<std::vector<std::string>> fields_;
  std::size_t rows_ = 0;

  void require_width(std::size_t width, std::size_t line) const {
    if (width == header_.size()) return;
    throw file_error(name_ + ":" + std::to_string(line), std::to_string(width) + " fields",
                     std::to_string(header_.size()) + " as in the header");
  }
};

std::optional<ValueColumn> number_column(const std::string& id,
                                         const std::vector<std::string>& fields,
                                         const CsvColumnOptions& options) {
  QuantityInfo info{id, 1, id, "-", Direction::None};
  if (id == "success" || contains(options.up, id)) info.direction = Direction::Up;
  if (contains(options.down, id)) info.direction = Direction::Down;
  ValueColumn column(info);
  column.reserve(fields.size());
  bool any = false, only_bits = true;
  for (const std::string& field : fields) {
    double number = 0;
    if (is_missing(field)) {
      column.add_na("empty");
      continue;
    }
    if (!parse_number(field, number)) return std::nullopt;
    column.add_number(number);
    any = true;
    only_bits = only_bits && (number == 0 || number == 1);
  }
  if (!any) return std::nullopt;
  column.rate = only_bits;
  return column;
}

void add_keys(ResultTable& columns, const CsvTable& csv) {
  const auto* hashes = csv.find("scenario_hash");
  const auto* names = csv.find("scenario");
  if (hashes == nullptr) hashes = names;
  if (names == nullptr) names = hashes;
  const auto* methods = csv.find("method");
  const auto* outcomes = csv.find("outcome");
  const auto* repetitions = csv.find("repetition");
  NameIndex scenario_index(columns.scenario_hashes), method_index(columns.methods),
      outcome_index(columns.outcomes);
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    const std::string own = "row" + std::to_string(row + 1);
    columns.scenario.push_back(scenario_index.index_of(hashes ? (*hashes)[row] : own));
    if (columns.scenario.back() == columns.scenario_names.size()) {
      columns.scenario_names.push_back(names ? (*names)[row] : own);
    }
    columns.method.push_back(method_index.index_of(methods ? (*methods)[row] : "all"));
    const bool known = outcomes != nullptr && !is_missing((*outcomes)[row]);
    columns.outcome.push_back(outcome_index.index_of(known ? (*outcomes)[row] : kUnknownOutcome));
    double repetition = 0;
    if (repetitions) parse_number((*repetitions)[row], repetition);
    columns.repetition.push_back(
        static_cast<std::uint32_t>(repetition > 0 ? std::min(repetition, 4e9) : 0.0));
  }
  sort_names(columns);
}

}  // namespace

ResultTable columns_from_csv(const std::string& text, const std::string& name,
                             const CsvColumnOptions& options) {
  const CsvTable csv(text, name);
  ResultTable columns;
  columns.source = name;
  add_keys(columns, csv);
  for (std::size_t i = 0; i < csv.header().size(); ++i) {
    const std::string& id = csv.header()[i];
    if (id.empty() || is_key(id) || find_metric(columns, id) != nullptr) continue;
    if (auto column = number_column(id, csv.column(i), options)) {
      columns.metrics.push_back(std::move(*column));
    }
  }
  if (csv.find("outcome") != nullptr) add_success(columns);
  if (columns.metrics.empty()) {
    throw file_error(name, "no numeric columns", "a header line and rows of numbers");
  }
  return columns;
}

}  // namespace slalom
