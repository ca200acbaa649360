// SPDX-License-Identifier: BSD-3-Clause
#include "csv_table.h"
#include "run_ends.h"

#include <slalom/analysis/cell.h>
#include <slalom/analysis/csv_columns.h>
#include <slalom/core/error.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>
#include <slalom/core/value.h>
#include <slalom/results/outcome_words.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>
#include <tuple>

namespace slalom {
namespace {

/// A field in a message.
std::string shown(const std::string& field) {
  constexpr std::size_t kLength = 40;  // bytes
  const bool is_long = field.size() > kLength;
  return "'" + printable_line(is_long ? field.substr(0, kLength) + "..." : field) + "'";
}

bool is_missing(const std::string& field) {
  static const std::set<std::string> words = {"",     "na",       "n/a",      "nan", "none",
                                              "null", "-",        "--",       "inf", "+inf",
                                              "-inf", "infinity", "-infinity"};
  return words.count(lower_case(field)) > 0;
}

/// 1 or 0 for a word that means it; letters do in columns of ends only.
std::optional<double> truth_of(const std::string& field, bool is_end) {
  static const std::vector<std::string> yes = {"true", "yes", "on", "t", "y"},
                                        no = {"false", "no", "off", "f", "n"};
  const std::string word = lower_case(field);
  if (word.size() == 1 && !is_end) return std::nullopt;
  if (contains(yes, word)) return 1;
  if (contains(no, word)) return 0;
  return std::nullopt;
}

/// The number, also with a decimal comma where commas do not separate fields, and of "85%".
bool parse_field(const std::string& field, char separator, bool is_end, double& number) {
  if (parse_number(field, number)) return true;
  if (const auto truth = truth_of(field, is_end)) return number = *truth, true;
  if (!field.empty() && field.back() == '%') {
    const bool valid = parse_field(field.substr(0, field.size() - 1), separator, false, number);
    number /= 100;
    return valid;
  }
  const std::size_t comma = field.find(',');
  if (separator == ',' || comma == std::string::npos) return false;
  std::string with_point = field;
  with_point[comma] = '.';
  return parse_number(with_point, number);
}

/// The outcomes that words mean, with those that are stated to mean success.
class OutcomeWords {
 public:
  explicit OutcomeWords(const std::vector<std::string>& success_words) {
    for (const std::string& word : success_words) success_.push_back(lower_case(word));
  }

  bool any() const { return !success_.empty(); }
  bool is_success(const std::string& word) const { return contains(success_, lower_case(word)); }
  std::optional<std::string> known(const std::string& word) const {
    return is_success(word) ? "success" : outcome_of_word(word);
  }

 private:
  std::vector<std::string> success_;
};

/// A column that identifies the run of a row.
struct KeyColumn {
  const char* name;                  ///< also of the option --NAME-column
  std::vector<const char*> aliases;  ///< in lower case
};

/// The name of a column in lower case, with "_" between words, and without the objects of JSON in
/// which it stands: "result.success".
std::string plain_name(const std::string& id) {
  std::string name = lower_case(id.substr(id.rfind('.') + 1));
  for (char& c : name) c = c == ' ' || c == '-' ? '_' : c;
  return name;
}

/// Finds the columns of the runs' keys; describes what is not obvious.
class KeyColumns {
 public:
  KeyColumns(const CsvTable& csv, const CsvColumnOptions& options) : csv_(csv) {
    const auto any = [](const std::vector<std::string>&) { return true; };
    hash = find({"scenario_hash", {}}, "", any);
    scenario = find({"scenario", {"world", "map", "environment", "env"}}, options.scenario, any);
    method = find({"method", {"planner", "local_planner", "algorithm", "controller"}},
                  options.method, any);
    repetition = find({"repetition", {"trial", "run", "episode"}}, options.repetition,
                      [](const auto& fields) { return !first_other(fields); });
    const OutcomeWords words(options.success_words);
    outcome = find({"outcome",
                    {"result", "status", "state", "end_state", "reason", "done_reason",
                     "end_reason", "termination", "termination_reason", "ended_by", "success"}},
                   options.outcome, [&](const auto& fields) {
                     return std::any_of(fields.begin(), fields.end(), [&](const std::string& word) {
                       return words.known(word).has_value();
                     });
                   });
  }

  using Fields = const std::vector<std::string>*;
  Fields hash = nullptr, scenario = nullptr, method = nullptr, repetition = nullptr,
         outcome = nullptr;

  bool is_key(std::size_t column) const { return taken_.count(column) > 0; }
  /// "planner as method", for columns with other names than Slalom's.
  const std::vector<std::string>& renamed() const { return renamed_; }

  /// The first field that is neither the number of a repetition nor missing.
  static std::optional<std::size_t> first_other(const std::vector<std::string>& fields) {
    constexpr double kLargest = std::numeric_limits<std::int32_t>::max();
    double number = 0;
    for (std::size_t row = 0; row < fields.size(); ++row)
      if (!is_missing(fields[row]) && !(parse_number(fields[row], number) &&
                                        number == std::floor(number) && number <= kLargest))
        return row;
    return std::nullopt;
  }

 private:
  const CsvTable& csv_;
  std::set<std::size_t> taken_;
  std::vector<std::string> renamed_;

  template <typename Predicate>
  std::vector<std::size_t> columns_where(Predicate predicate) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < csv_.header().size(); ++i)
      if (!is_key(i) && predicate(i)) found.push_back(i);
    return found;
  }

  template <typename Accept>
  Fields find(const KeyColumn& key, const std::string& chosen, Accept accept) {
    const std::string name = chosen.empty() ? key.name : chosen;
    const auto& header = csv_.header();
    std::vector<std::size_t> found =
        columns_where([&](std::size_t i) { return header[i] == name; });
    if (!found.empty()) return take(found[0], key);
    if (!chosen.empty())
      throw usage_error("--" + std::string(key.name) + "-column",
                        csv_.name() + " has no column '" + chosen + "'",
                        expected_name(chosen, header));
    found = columns_where([&](std::size_t i) { return plain_name(header[i]) == key.name; });
    if (!found.empty()) return take(found[0], key);
    found = columns_where([&](std::size_t i) {
      const std::string plain = plain_name(header[i]);
      return std::find(key.aliases.begin(), key.aliases.end(), plain) != key.aliases.end() &&
             accept(csv_.column(i));
    });
    if (found.size() > 1)
      throw file_error(csv_.name() + ":1",
                       shown(header[found[0]]) + " and " + shown(header[found[1]]) +
                           " may both be the " + key.name,
                       "--" + std::string(key.name) + "-column NAME");
    return found.empty() ? nullptr : take(found[0], key);
  }

  Fields take(std::size_t column, const KeyColumn& key) {
    taken_.insert(column);
    const std::string& name = csv_.header()[column];
    if (name != key.name) renamed_.push_back(name + " as " + key.name);
    return &csv_.column(column);
  }
};

/// The outcome of a field. Throws Error (File) for an unknown word, with all that are unknown,
/// unless words of success are stated.
class OutcomeFields {
 public:
  OutcomeFields(const CsvTable& csv, const KeyColumns& keys, const CsvColumnOptions& options)
      : fields_(keys.outcome), words_(options.success_words) {
    if (fields_ == nullptr && words_.any())
      throw usage_error("--success-word", csv.name() + " has no column of outcomes",
                        "--outcome-column NAME");
    if (fields_ == nullptr) return;
    std::optional<std::size_t> first;
    for (std::size_t row = 0; row < fields_->size(); ++row) {
      const std::string& word = (*fields_)[row];
      if (is_missing(word)) continue;
      if (words_.is_success(word)) add(word, success_);
      if (words_.known(word)) continue;
      if (!first) first = row;
      add(word, unknown_);
    }
    if (first && !words_.any())
      throw file_error(csv.where(*first), "unknown outcome " + join(unknown_, ", "),
                       "one of " + join(known_outcomes(), ", ") +
                           ", a column success of 0 and 1, or --success-word WORD");
  }

  std::string operator()(std::size_t row) const {
    if (fields_ == nullptr || is_missing((*fields_)[row])) return kUnknownOutcome;
    return words_.known((*fields_)[row]).value_or("failure");
  }

  /// "'parked' as success, 'fell' as failure", if words of success are stated.
  std::string note() const {
    if (!words_.any()) return "";
    const std::string success =
        success_.empty() ? "no outcome of --success-word" : join(success_, ", ") + " as success";
    return success + (unknown_.empty() ? "" : ", " + join(unknown_, ", ") + " as failure");
  }

 private:
  const std::vector<std::string>* fields_;
  OutcomeWords words_;
  std::vector<std::string> success_, unknown_;  ///< as shown; some of them

  static void add(const std::string& word, std::vector<std::string>& words) {
    if (!contains(words, shown(word)) && words.size() < 5) words.push_back(shown(word));
  }
};

/// Counts the rows of each scenario and method.
class RowCounts {
 public:
  std::uint32_t next(std::uint32_t scenario, std::uint32_t method) {
    return counts_[{scenario, method}]++;
  }

 private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> counts_;
};

std::uint32_t repetition_of(const std::string& field) {
  double number = 0;
  return parse_number(field, number) ? static_cast<std::uint32_t>(std::max(number, 0.0)) : 0;
}

/// Merged cells and rows of totals have no key.
void require_key(const CsvTable& csv, const std::vector<std::string>* fields, std::size_t row,
                 const std::string& name) {
  if (fields != nullptr && trim((*fields)[row]).empty())
    throw file_error(csv.where(row), "the " + name + " is empty", "a name in each row");
}

void add_keys(ResultTable& columns, const CsvTable& csv, const KeyColumns& keys,
              const OutcomeFields& outcome_of) {
  const auto* hashes = keys.hash ? keys.hash : keys.scenario;
  const auto* names = keys.scenario ? keys.scenario : keys.hash;
  if (keys.repetition != nullptr)
    if (const auto row = KeyColumns::first_other(*keys.repetition))
      throw file_error(csv.where(*row), "repetition " + shown((*keys.repetition)[*row]),
                       "an integer from 0 to 2147483647");
  NameIndex scenario_index(columns.scenario_hashes), method_index(columns.methods),
      outcome_index(columns.outcomes);
  RowCounts counts;
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> runs;
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    require_key(csv, keys.method, row, "method");
    require_key(csv, hashes, row, "scenario");
    const std::string own = "row" + std::to_string(row + 1);
    columns.scenario.push_back(
        scenario_index.index_of(hashes ? (*hashes)[row] : own + " of " + csv.name()));
    if (columns.scenario.back() == columns.scenario_names.size()) {
      columns.scenario_names.push_back(names ? (*names)[row] : own);
    }
    columns.method.push_back(method_index.index_of(keys.method ? (*keys.method)[row] : "all"));
    columns.outcome.push_back(outcome_index.index_of(outcome_of(row)));
    columns.repetition.push_back(keys.repetition
                                     ? repetition_of((*keys.repetition)[row])
                                     : counts.next(columns.scenario.back(), columns.method.back()));
    if (!runs.emplace(columns.scenario[row], columns.method[row], columns.repetition[row]).second)
      throw file_error(csv.where(row),
                       "two rows of repetition " + std::to_string(columns.repetition[row]) +
                           " of " + shown(columns.methods[columns.method[row]]) + " in " +
                           shown(columns.scenario_names[columns.scenario[row]]),
                       "each once; another column with --repetition-column NAME");
  }
  expect_names(columns);
  sort_names(columns);
}

/// A larger absolute value stands for a missing one: the largest float or double.
constexpr double kMaxNumber = 3.4e38;

/// Whether a number is too large for one.
bool overflows(const std::string& field) {
  char* end = nullptr;
  const double number = std::strtod(field.c_str(), &end);
  return *end == '\0' && std::isinf(number) && field.find_first_of("0123456789") == 0;
}

/// The columns of numbers as metrics; the others with the reason.
class NumberColumns {
 public:
  NumberColumns(const CsvTable& csv, const CsvColumnOptions& options, ResultTable& table)
      : csv_(csv), options_(options), table_(table) {}

  void add(std::size_t column) {
    const auto& fields = csv_.column(column);
    const std::string id = id_of(csv_.header()[column]);
    const auto is_empty = [](const std::string& field) { return field.empty(); };
    if (id.empty() && std::all_of(fields.begin(), fields.end(), is_empty)) return;
    if (!id.empty() && find_metric(table_, id) != nullptr)
      throw file_error(csv_.name() + ":1", "two columns of " + id, "each name once, in any case");
    const std::string why = id.empty()                  ? "no name"
                            : add_numbers(id, fields)   ? ""
                            : text_row_ < fields.size() ? text_reason(fields)
                                                        : "no numbers";
    if (!why.empty())
      table_.unread.emplace_back(id.empty() ? "column " + std::to_string(column + 1) : id, why);
    has_text_ = has_text_ || text_row_ < fields.size();
  }

  bool has_text() const { return has_text_; }  ///< a column that may be a key
  /// Lines about values that are not read as they are written.
  std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    if (has_decimal_commas_) notes.emplace_back("commas are read as decimal points");
    if (!percent_.empty()) notes.push_back("percent as fractions of 1: " + join(percent_, ", "));
    if (!truth_.empty()) notes.push_back("words as 1 and 0: " + join(truth_, ", "));
    if (!too_large_.empty())
      notes.push_back("numbers from 3.4e38 as not available: " + join(too_large_, ", "));
    return notes;
  }

 private:
  const CsvTable& csv_;
  const CsvColumnOptions& options_;
  ResultTable& table_;
  std::size_t text_row_ = 0;  ///< of the last column
  bool has_text_ = false, has_decimal_commas_ = false;
  std::vector<std::string> percent_, truth_, too_large_;  ///< columns

  /// "Success" is the metric success.
  static std::string id_of(const std::string& name) {
    const std::string success = success_info().id;
    return plain_name(name) == success ? success : name;
  }

  std::string text_reason(const std::vector<std::string>& fields) const {
    return csv_.short_where(text_row_) + ": " + shown(fields[text_row_]) + " is not a number";
  }

  /// False if there are no numbers, or a field is text: text_row_.
  bool add_numbers(const std::string& id, const std::vector<std::string>& fields) {
    std::vector<Value> values;
    const bool is_end = is_end_name(id);
    bool any = false, commas = false, percent = false, truth = false, too_large = false;
    for (text_row_ = 0; text_row_ < fields.size(); ++text_row_) {
      const std::string& field = fields[text_row_];
      double number = 0;
      if (is_missing(field)) {
        values.push_back(Value::na(field.empty() ? "empty" : field));
        continue;
      }
      const bool is_number = parse_field(field, csv_.separator(text_row_), is_end, number);
      if (!is_number && !overflows(field)) return false;
      const bool is_sentinel = !is_number || std::abs(number) > kMaxNumber;
      values.push_back(is_sentinel ? Value::na(field) : Value::of(number));
      too_large = too_large || is_sentinel;
      any = true;
      commas = commas || field.find(',') != std::string::npos;
      percent = percent || field.back() == '%';
      truth = truth || truth_of(field, is_end);
    }
    if (!any) return false;
    for (std::size_t row = 0; percent && row < values.size(); ++row)
      if (!values[row].is_na() && fields[row].back() != '%' && std::abs(values[row].number()) > 1)
        throw file_error(csv_.where(row), shown(id) + " is " + fields[row] + " beside percent",
                         "a fraction of 1, or % in each row");
    if (!percent && is_percent_of_ends(id, values)) {
      percent = true;
      for (Value& value : values)
        if (!value.is_na()) value = Value::of(value.number() / 100);
    }
    if (percent) percent_.push_back(id);
    if (truth) truth_.push_back(id);
    if (too_large) too_large_.push_back(id);
    has_decimal_commas_ = has_decimal_commas_ || commas;
    ValueColumn& column = table_.metrics.emplace_back(info_of(id, values));
    column.reserve(values.size());
    for (const Value& value : values) column.add(value);
    return true;
  }

  static bool is_bit(double number) { return number == 0 || number == 1; }

  /// "success [%]" of 0 and 100.
  static bool is_percent_of_ends(const std::string& id, const std::vector<Value>& values) {
    return id.find('%') != std::string::npos &&
           first_refused(values, [](double number) { return number == 0 || number == 100; }) ==
               values.size() &&
           first_refused(values, is_bit) < values.size();
  }

  /// The first row with a number that `accept` refuses, or the number of rows.
  template <typename Accept>
  static std::size_t first_refused(const std::vector<Value>& values, Accept accept) {
    const auto refused = std::find_if(values.begin(), values.end(), [&](const Value& value) {
      return !value.is_na() && !accept(value.number());
    });
    return static_cast<std::size_t>(refused - values.begin());
  }

  template <typename Accept>
  void require(const std::string& id, const std::vector<Value>& values, const std::string& expected,
               Accept accept) const {
    const std::size_t row = first_refused(values, accept);
    if (row < values.size())
      throw file_error(csv_.where(row), shown(id) + " is " + format_number(values[row].number()),
                       expected);
  }

  QuantityInfo info_of(const std::string& id, const std::vector<Value>& values) const {
    QuantityInfo info{id, 1, id, "-", Direction::None};
    if (id == success_info().id) info.direction = success_info().direction;
    if (contains(options_.up, id)) info.direction = Direction::Up;
    if (contains(options_.down, id)) info.direction = Direction::Down;
    set_kind(info, values);
    if (const auto stated = options_.ranges.find(id); stated != options_.ranges.end()) {
      info.range = stated->second;
      require(id, values, "a number " + info.range.text() + ", as --range states",
              [&](double number) { return info.range.contains(number); });
    }
    return info;
  }

  void set_kind(QuantityInfo& info, const std::vector<Value>& values) const {
    const auto stated = options_.kinds.find(info.id);
    const bool is_stated = stated != options_.kinds.end();
    if (is_stated ? stated->second == QuantityKind::Rate
                  : first_refused(values, is_bit) == values.size()) {
      info.kind = QuantityKind::Rate;
      info.range = Range::between(0, 1);
      require(info.id, values, "0 or 1, as --kind states", is_bit);
    } else if (is_stated) {
      info.kind = stated->second;
      if (info.kind == QuantityKind::Count) info.range = Range::at_least(0);
      require(info.id, values, "a number from 0, as --kind states",
              [&](double number) { return info.range.contains(number); });
    } else {
      take_known(info, values);
    }
  }

  /// A rate is recognized by its values. A stated range takes the place of the known one.
  void take_known(QuantityInfo& info, const std::vector<Value>& values) const {
    if (options_.ranges.count(info.id) > 0) return;
    for (const QuantityInfo& known : options_.known) {
      if (known.id != info.id) continue;
      require(info.id, values,
              known.is_rate() ? "0 or 1, or --range " + info.id + "=0..1 for means of runs"
                              : "a number " + known.range.text() + ", or --range " + info.id +
                                    "=LOW..HIGH for a quantity that is not Slalom's",
              [&](double number) {
                return known.is_rate() ? is_bit(number) : known.range.contains(number);
              });
      if (!known.is_rate()) info.kind = known.kind;
      info.range = known.range;
    }
  }
};

/// "a=x,b=y" as pairs.
std::vector<std::pair<std::string, std::string>> assignments(const std::string& option,
                                                             const std::string& text,
                                                             const std::string& expected) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const std::string& part : split_nonempty(text, ',')) {
    const std::size_t equal = part.rfind('=');
    if (equal == std::string::npos || equal == 0)
      throw usage_error(option, shown(part) + " is not valid", expected);
    pairs.emplace_back(part.substr(0, equal), part.substr(equal + 1));
  }
  return pairs;
}

template <typename Statement>
std::vector<std::string> keys_of(const std::map<std::string, Statement>& statements) {
  std::vector<std::string> ids;
  for (const auto& [id, statement] : statements) ids.push_back(id);
  return ids;
}

/// Throws Error (Usage) for an option about a column that is no metric.
void require_columns(const ResultTable& table, const std::string& option,
                     const std::vector<std::string>& ids) {
  std::vector<std::string> names;
  for (const ValueColumn& column : table.metrics) names.push_back(column.info().id);
  for (const std::string& id : ids) {
    require_readable(table, option, id);
    if (!contains(names, id))
      throw usage_error(option, table.source + " has no column of numbers " + shown(id),
                        expected_name(id, names));
  }
}

std::string unread_text(const ResultTable& table) {
  std::vector<std::string> texts;
  for (const auto& [id, why] : table.unread) texts.push_back(id + " (" + why + ")");
  return join(texts, ", ");
}

/// Returns notes on columns that were not read as they stand.
void add_notes(ResultTable& table, const KeyColumns& keys, const NumberColumns& numbers,
               const std::vector<std::string>& taken, std::vector<std::string> parts) {
  if (!taken.empty()) parts.push_back("taken: " + join(taken, ", "));
  if (!table.unread.empty()) parts.push_back("not used: " + unread_text(table));
  if (numbers.has_text() && keys.method == nullptr)
    parts.emplace_back("no column method (--method-column): all rows are of one method, 'all'");
  if (numbers.has_text() && keys.scenario == nullptr && keys.hash == nullptr)
    parts.emplace_back("no column scenario (--scenario-column): each row is a scenario of its own");
  for (const std::string& note : numbers.notes()) parts.push_back(note);
  if (!parts.empty()) table.notes.push_back(join(parts, "; "));
}

bool are_different(const std::vector<std::string>& names) {
  return std::set<std::string>(names.begin(), names.end()).size() == names.size();
}

/// The names of files without folder and ending; with the folder if two are equal. Throws Error
/// (File) if they are equal then, too.
std::vector<std::string> method_names(const std::vector<CsvFile>& files) {
  std::vector<std::string> stems, paths;
  for (const CsvFile& file : files) {
    const std::filesystem::path path(file.name);
    stems.push_back(path.stem().string());
    paths.push_back((path.parent_path() / path.stem()).string());
  }
  if (are_different(stems)) return stems;
  if (!are_different(paths))
    throw file_error(files[0].name, "is one of two tables of the same method, the name of the file",
                     "other names, or a column method");
  return paths;
}

ResultTable columns_of(const CsvTable& csv, const CsvColumnOptions& options) {
  const KeyColumns keys(csv, options);
  const OutcomeFields outcomes(csv, keys, options);
  ResultTable columns;
  columns.source = csv.name();
  add_keys(columns, csv, keys, outcomes);
  NumberColumns numbers(csv, options, columns);
  for (std::size_t i = 0; i < csv.header().size(); ++i)
    if (!keys.is_key(i)) numbers.add(i);
  std::vector<std::string> taken = keys.renamed();
  for (const std::string& end : complete_outcomes(columns, csv, keys.outcome != nullptr, options))
    taken.push_back(end);
  if (columns.metrics.empty())
    throw file_error(csv.name(), "no numeric columns: " + unread_text(columns),
                     "a header line and rows of numbers");
  require_columns(columns, "--kind", keys_of(options.kinds));
  require_columns(columns, "--range", keys_of(options.ranges));
  require_columns(columns, "--conditional", options.conditional);
  require_columns(columns, "--unconditional", options.unconditional);
  std::vector<std::string> notes;
  if (csv.has_blanks()) notes.emplace_back("separated by blanks");
  if (const std::string note = outcomes.note(); !note.empty()) notes.push_back(note);
  for (std::string& note : make_conditional(columns, csv, keys.hash != nullptr, options))
    notes.push_back(std::move(note));
  add_notes(columns, keys, numbers, taken, std::move(notes));
  return columns;
}

}  // namespace

std::map<std::string, QuantityKind> parse_column_kinds(const std::string& text) {
  std::map<std::string, QuantityKind> kinds;
  const std::string names = join(names_of<QuantityKind>(), ", ");
  for (const auto& [id, name] : assignments("--kind", text, "COLUMN=KIND, with one of " + names)) {
    const auto kind = from_name<QuantityKind>(name);
    if (!kind) throw usage_error("--kind", "unknown kind " + shown(name), "one of " + names);
    kinds[id] = *kind;
  }
  return kinds;
}

std::map<std::string, Range> parse_column_ranges(const std::string& text) {
  constexpr const char* kExpected = "COLUMN=LOW..HIGH, COLUMN=LOW.. or COLUMN=..HIGH";
  std::map<std::string, Range> ranges;
  for (const auto& [id, notation] : assignments("--range", text, kExpected)) {
    const auto range = parse_range(notation);
    if (!range) throw usage_error("--range", shown(notation) + " is not valid", kExpected);
    ranges[id] = *range;
  }
  return ranges;
}

ResultTable columns_from_csv(const std::string& text, const std::string& name,
                             const CsvColumnOptions& options) {
  return columns_of(CsvTable(text, name, options.names), options);
}

ResultTable columns_from_csv(const std::vector<CsvFile>& files, const CsvColumnOptions& options) {
  std::vector<CsvTable> tables;
  std::vector<std::string> names, without_method;
  for (const CsvFile& file : files) {
    if (contains(names, file.name))
      throw file_error(file.name, "is given twice", "each table once");
    names.push_back(file.name);
    tables.emplace_back(file.text, file.name, options.names);
    if (KeyColumns(tables.back(), options).method == nullptr) without_method.push_back(file.name);
  }
  if (without_method.size() == files.size()) {
    const std::vector<std::string> methods = method_names(files);
    for (std::size_t i = 0; i < files.size(); ++i) tables[i].add_column("method", methods[i]);
  } else if (!without_method.empty()) {
    throw file_error(without_method[0], "has no column of methods, as another table has",
                     "a column method in all tables, or in none for the names of the files");
  }
  return columns_of(CsvTable(tables), options);
}

void unify_kinds(std::vector<ResultTable>& tables) {
  for (const ResultTable& table : tables)
    for (const ValueColumn& column : table.metrics) {
      if (column.info().is_rate()) continue;
      for (ResultTable& other : tables)
        for (ValueColumn& same : other.metrics)
          if (same.info().id == column.info().id && same.info().is_rate())
            same.set_kind(column.info().kind, column.info().range);
    }
}

}  // namespace slalom
