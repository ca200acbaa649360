#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/planner_arena/benchmark_database.h>

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdio>
#include <set>

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

using Ids = std::map<std::string, std::int64_t>;

std::string quoted(const std::string& identifier) {
  std::string text = "\"";
  for (const char c : identifier) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\"";
}

/// The lines of one section of an .ini, as canonical text has them.
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

/// The value of a key of the campaign, as a number; NULL where it says nothing.
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

/// Writes the tables of one database.
class Writer {
 public:
  Writer(const ResultTable& table, SQLite::Database& database)
      : table_(table), database_(database) {}

  void write() {
    SQLite::Transaction transaction(database_);
    database_.exec(kSchema);
    const Ids outcomes = add_outcomes();
    const Ids experiments = add_experiments();
    const Ids planners = add_planners();
    add_runs(outcomes, experiments, planners);
    transaction.commit();
  }

 private:
  std::string manifest(const std::string& key) const {
    const auto found = table_.manifest.find(key);
    return found == table_.manifest.end() ? "" : found->second;
  }

  Ids add_outcomes() {
    Ids ids;
    for (const RunRecord& run : table_.runs) ids[run.outcome] = 0;
    SQLite::Statement insert(database_, "INSERT INTO enums VALUES ('status', ?, ?)");
    std::int64_t next = 0;
    for (auto& [outcome, id] : ids) {
      id = next++;
      insert.bind(1, id);
      insert.bind(2, outcome);
      insert.exec();
      insert.reset();
    }
    return ids;
  }

  std::vector<std::string> descriptor_ids() const {
    std::set<std::string> ids;
    for (const auto& scenario : table_.scenarios)
      for (const auto& descriptor : scenario.second.descriptors) ids.insert(descriptor.first);
    return {ids.begin(), ids.end()};
  }

  std::map<std::string, int> run_counts() const {
    std::map<std::string, int> counts;
    for (const RunRecord& run : table_.runs) ++counts[run.scenario_hash];
    return counts;
  }

  Ids add_experiments() {
    const std::vector<std::string> descriptors = descriptor_ids();
    for (const std::string& id : descriptors)
      database_.exec("ALTER TABLE experiments ADD " + quoted(id) + " REAL");
    std::string sql = "INSERT INTO experiments VALUES (NULL, ?, 0, ?, ?, ?, ?, '', '', '', ?, ?";
    for (std::size_t i = 0; i < descriptors.size(); ++i) sql += ", ?";
    SQLite::Statement insert(database_, sql + ")");
    const std::string ini = manifest("campaign.ini");
    const std::map<std::string, int> counts = run_counts();
    Ids ids;
    for (const auto& [hash, scenario] : table_.scenarios) {
      int field = 0;
      insert.bind(++field, scenario.name);
      bind_value(insert, ++field, ini_number(ini, "simulation", "max_time"));
      bind_value(insert, ++field, ini_number(ini, "limits", "memory_mb"));
      const auto count = counts.find(hash);
      insert.bind(++field, count == counts.end() ? 0 : count->second);
      insert.bind(++field, "Slalom " + manifest("version.slalom"));
      insert.bind(++field, manifest("seed"));
      insert.bind(++field, "scenario " + hash + "\n" + ini);
      for (const std::string& id : descriptors) {
        const auto found = scenario.descriptors.find(id);
        bind_value(insert, ++field,
                   found == scenario.descriptors.end() ? Value::na("") : found->second.value);
      }
      insert.exec();
      insert.reset();
      ids[hash] = database_.getLastInsertRowid();
    }
    return ids;
  }

  Ids add_planners() {
    Ids ids;
    for (const RunRecord& run : table_.runs) ids[run.method] = 0;
    SQLite::Statement insert(database_, "INSERT INTO plannerConfigs VALUES (NULL, ?, ?)");
    for (auto& [method, id] : ids) {
      insert.bind(1, method);
      insert.bind(2, section_of(manifest("campaign.ini"), "method." + method));
      insert.exec();
      insert.reset();
      id = database_.getLastInsertRowid();
    }
    return ids;
  }

  std::vector<std::string> metric_ids() const {
    std::set<std::string> ids;
    for (const RunRecord& run : table_.runs)
      for (const auto& metric : run.metrics) ids.insert(metric.first);
    ids.erase("time");  // columns that every benchmark has
    ids.erase("solved");
    ids.erase("status");
    return {ids.begin(), ids.end()};
  }

  static Value metric_of(const RunRecord& run, const std::string& id) {
    const auto found = run.metrics.find(id);
    return found == run.metrics.end() ? Value::na("not computed") : found->second.value;
  }

  void add_runs(const Ids& outcomes, const Ids& experiments, const Ids& planners) {
    const std::vector<std::string> metrics = metric_ids();
    for (const char* column : {"time REAL", "solved BOOLEAN", "status ENUM"})
      database_.exec(std::string("ALTER TABLE runs ADD ") + column);
    std::string sql = "INSERT INTO runs VALUES (NULL, ?, ?, ?, ?, ?";
    for (const std::string& id : metrics) {
      database_.exec("ALTER TABLE runs ADD " + quoted(id) + " REAL");
      sql += ", ?";
    }
    SQLite::Statement insert(database_, sql + ")");
    for (const RunRecord& run : table_.runs) {
      const auto experiment = experiments.find(run.scenario_hash);
      int field = 0;
      if (experiment == experiments.end())
        insert.bind(++field);
      else
        insert.bind(++field, experiment->second);
      insert.bind(++field, planners.at(run.method));
      bind_value(insert, ++field, metric_of(run, "time_to_goal"));
      insert.bind(++field, run.outcome == "success" ? 1 : 0);
      insert.bind(++field, outcomes.at(run.outcome));
      for (const std::string& id : metrics) bind_value(insert, ++field, metric_of(run, id));
      insert.exec();
      insert.reset();
    }
  }

  const ResultTable& table_;
  SQLite::Database& database_;
};

}  // namespace

void write_benchmark_database(const ResultTable& table, const std::string& path) {
  const std::string temporary = path + ".tmp";
  std::remove(temporary.c_str());
  try {
    SQLite::Database database(temporary, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    Writer(table, database).write();
  } catch (const SQLite::Exception& e) {
    std::remove(temporary.c_str());
    throw job_error(path, std::string("cannot be written: ") + e.what());
  }
  if (std::rename(temporary.c_str(), path.c_str()) == 0) return;
  std::remove(temporary.c_str());
  throw job_error(path, "cannot be written: not renamed");
}

}  // namespace slalom
