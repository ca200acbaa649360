// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/temporary_file.h>
#include <slalom/core/text.h>
#include <slalom/planner_arena/benchmark_database.h>

#include <SQLiteCpp/SQLiteCpp.h>

namespace slalom {
namespace {

constexpr const char* kSchema = R"(
CREATE TABLE experiments (id INTEGER PRIMARY KEY AUTOINCREMENT, name VARCHAR(512), totaltime REAL,
  timelimit REAL, memorylimit REAL, runcount INTEGER, version VARCHAR(128), hostname VARCHAR(1024),
  cpuinfo TEXT, date DATETIME, seed INTEGER, setup TEXT);
CREATE TABLE plannerConfigs (id INTEGER PRIMARY KEY AUTOINCREMENT, name VARCHAR(512) NOT NULL,
  settings TEXT);
CREATE TABLE enums (name VARCHAR(512), value INTEGER, description TEXT, PRIMARY KEY (name, value));
CREATE TABLE runs (id INTEGER PRIMARY KEY AUTOINCREMENT, experimentid INTEGER, plannerid INTEGER,
  FOREIGN KEY (experimentid) REFERENCES experiments(id) ON DELETE CASCADE,
  FOREIGN KEY (plannerid) REFERENCES plannerConfigs(id) ON DELETE CASCADE);
CREATE TABLE progress (runid INTEGER, time REAL, PRIMARY KEY (runid, time),
  FOREIGN KEY (runid) REFERENCES runs(id) ON DELETE CASCADE);
)";

std::string quoted(const std::string& identifier) {
  std::string text = "\"";
  for (const char c : identifier) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\"";
}

/// The lines of one section of an .ini in canonical text.
std::string section_of(const std::string& ini, const std::string& section) {
  std::string lines;
  bool inside = false;
  for (const std::string& line : split(ini, '\n')) {
    if (!line.empty() && line.front() == '[') {
      inside = line == "[" + section + "]";
    } else if (inside && !line.empty()) {
      lines += line + ";";
    }
  }
  return lines;
}

/// The value of a campaign key as a number; NA if it is missing.
Value ini_number(const std::string& ini, const std::string& section, const std::string& key) {
  for (const std::string& line : split(section_of(ini, section), ';')) {
    const auto equals = line.find('=');
    double number = 0;
    if (equals != std::string::npos && trim(line.substr(0, equals)) == key &&
        parse_number(trim(line.substr(equals + 1)), number))
      return Value::of(number);
  }
  return Value::na("not given");
}

void bind_value(SQLite::Statement& statement, int index, const Value& value) {
  value.is_na() ? statement.bind(index) : statement.bind(index, value.number());
}

/// NULL for NA, and if there is no such column.
void bind_value(SQLite::Statement& statement, int index, const ValueColumn* column,
                std::size_t row) {
  const bool missing = column == nullptr || column->is_na(row);
  missing ? statement.bind(index) : statement.bind(index, column->number(row));
}

/// Writes the tables of one database.
class Writer {
 public:
  Writer(const ResultTable& table, SQLite::Database& database)
      : table_(table), database_(database) {}

  void write() {
    SQLite::Transaction transaction(database_);
    database_.exec(kSchema);
    add_outcomes();
    add_experiments();
    add_planners();
    add_runs();
    transaction.commit();
  }

 private:
  std::string manifest(const std::string& key) const {
    const auto found = table_.manifest.find(key);
    return found == table_.manifest.end() ? "" : found->second;
  }

  /// The value of an outcome is its position in the table.
  void add_outcomes() {
    SQLite::Statement insert(database_, "INSERT INTO enums VALUES ('status', ?, ?)");
    for (std::size_t outcome = 0; outcome < table_.outcomes.size(); ++outcome) {
      insert.bind(1, static_cast<std::int64_t>(outcome));
      insert.bind(2, table_.outcomes[outcome]);
      insert.exec();
      insert.reset();
    }
  }

  /// The id of an experiment is 1 plus the position of the scenario in the table.
  void add_experiments() {
    std::string sql = "INSERT INTO experiments VALUES (NULL, ?, 0, ?, ?, ?, ?, '', '', '', ?, ?";
    for (const ValueColumn& descriptor : table_.descriptors) {
      database_.exec("ALTER TABLE experiments ADD " + quoted(descriptor.info().id) + " REAL");
      sql += ", ?";
    }
    SQLite::Statement insert(database_, sql + ")");
    const std::string ini = manifest("campaign.ini");
    std::vector<int> counts(table_.scenario_hashes.size(), 0);
    for (const std::uint32_t scenario : table_.scenario) ++counts[scenario];
    for (std::size_t scenario = 0; scenario < counts.size(); ++scenario) {
      int field = 0;
      insert.bind(++field, table_.scenario_names[scenario]);
      bind_value(insert, ++field, ini_number(ini, "simulation", "max_time"));
      bind_value(insert, ++field, ini_number(ini, "limits", "memory_mb"));
      insert.bind(++field, counts[scenario]);
      insert.bind(++field, "Slalom " + manifest("version.slalom"));
      insert.bind(++field, manifest("seed"));
      insert.bind(++field, "scenario " + table_.scenario_hashes[scenario] + "\n" + ini);
      for (const ValueColumn& descriptor : table_.descriptors)
        bind_value(insert, ++field, &descriptor, scenario);
      insert.exec();
      insert.reset();
    }
  }

  /// The id of a planner is 1 plus the position of the method in the table.
  void add_planners() {
    SQLite::Statement insert(database_, "INSERT INTO plannerConfigs VALUES (NULL, ?, ?)");
    for (const std::string& method : table_.methods) {
      insert.bind(1, method);
      insert.bind(2, section_of(manifest("campaign.ini"), "method." + method));
      insert.exec();
      insert.reset();
    }
  }

  /// The metrics except those with the names of columns that every benchmark has.
  std::vector<const ValueColumn*> metrics() const {
    std::vector<const ValueColumn*> columns;
    for (const ValueColumn& column : table_.metrics) {
      const std::string& id = column.info().id;
      const bool reserved = id == "time" || id == "solved" || id == "status";
      if (!reserved && !column.wall_clock) columns.push_back(&column);
    }
    return columns;
  }

  void add_runs() {
    for (const char* column : {"time REAL", "solved BOOLEAN", "status ENUM"})
      database_.exec(std::string("ALTER TABLE runs ADD ") + column);
    std::string sql = "INSERT INTO runs VALUES (NULL, ?, ?, ?, ?, ?";
    const auto columns = metrics();
    for (const ValueColumn* column : columns) {
      database_.exec("ALTER TABLE runs ADD " + quoted(column->info().id) + " REAL");
      sql += ", ?";
    }
    SQLite::Statement insert(database_, sql + ")");
    const ValueColumn* time = find_metric(table_, "time_to_goal");
    for (std::size_t run = 0; run < table_.size(); ++run) {
      int field = 0;
      insert.bind(++field, static_cast<std::int64_t>(table_.scenario[run]) + 1);
      insert.bind(++field, static_cast<std::int64_t>(table_.method[run]) + 1);
      bind_value(insert, ++field, time, run);
      bind_value(insert, ++field, success_of(table_.outcomes[table_.outcome[run]]));
      insert.bind(++field, static_cast<std::int64_t>(table_.outcome[run]));
      for (const ValueColumn* column : columns) bind_value(insert, ++field, column, run);
      insert.exec();
      insert.reset();
    }
  }

  const ResultTable& table_;
  SQLite::Database& database_;
};

}  // namespace

void write_benchmark_database(const ResultTable& table, const std::string& path) {
  TemporaryFile temporary(path);
  try {
    SQLite::Database database(temporary.name(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    Writer(table, database).write();
  } catch (const SQLite::Exception& e) {
    throw job_error(path, std::string("cannot be written: ") + e.what());
  }
  temporary.publish();
}

}  // namespace slalom
