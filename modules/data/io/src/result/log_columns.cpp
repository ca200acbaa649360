// SPDX-License-Identifier: BSD-3-Clause
#include "log_columns.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace slalom {
namespace {

/// The names of a quantity in logs, the preferred one first. Those with a dot may end a name.
struct Aliases {
  std::string name, others;
};

const std::array<Aliases, kLogQuantities> kAliases = {{
    {"t", "time timestamp stamp %time __time header.stamp"},
    {"x", "tx pos_x pose_x position_x pose.x position.x field.x p_rs_r_x"},
    {"y", "ty pos_y pose_y position_y pose.y position.y field.y p_rs_r_y"},
    {"phi", "yaw theta heading pose_yaw pose_theta pose.yaw pose.theta field.theta"},
    {"v", "vx v_x linear_x twist.twist.linear.x"},
    {"w", "wz w_z omega yaw_rate angular_z twist.twist.angular.z"},
    {"vy", "v_y linear_y twist.twist.linear.y"},
    {"command_v", "cmd_v cmd_vx cmd_vel.linear.x cmd_vel.twist.linear.x"},
    {"command_w", "cmd_w cmd_wz cmd_vel.angular.z cmd_vel.twist.angular.z"},
    {"command_vy", "cmd_vy cmd_vel.linear.y cmd_vel.twist.linear.y"},
    {"qx", "q_x orientation_x orientation.x q_rs_x"},
    {"qy", "q_y orientation_y orientation.y q_rs_y"},
    {"qz", "q_z orientation_z orientation.z q_rs_z"},
    {"qw", "q_w orientation_w orientation.w q_rs_w"},
}};

const std::map<std::string, double> kUnits = {
    {"", 1},      {"s", 1},     {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9},        {"m", 1},
    {"cm", 1e-2}, {"mm", 1e-3}, {"rad", 1},   {"rad/s", 1}, {"deg", M_PI / 180}, {"m/s", 1},
    {"m s^-1", 1}};

/// A name in small letters with dots, without the unit in brackets, and the factor of the unit.
std::pair<std::string, double> plain_name(const std::string& name) {
  std::string plain = lower_case(name);
  std::replace(plain.begin(), plain.end(), '/', '.');
  const std::size_t open = plain.find_first_of("[(");
  if (open == std::string::npos || (plain.back() != ']' && plain.back() != ')')) return {plain, 1};
  const auto unit = kUnits.find(trim(plain.substr(open + 1, plain.size() - open - 2)));
  return unit == kUnits.end() ? std::pair(plain, 1.0)
                              : std::pair(trim(plain.substr(0, open)), unit->second);
}

bool is_alias(const std::string& name, const std::string& alias) {
  return name == alias || (alias.find('.') != std::string::npos && ends_with(name, "." + alias));
}

/// At most five names, and the number of the others.
std::string some_of(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 5;
  if (names.size() <= kMost) return join(names, ", ");
  return join({names.begin(), names.begin() + kMost}, ", ") + " and " +
         count_text(names.size() - kMost, "other");
}

/// The separator of a header, whose names may contain blanks unless they are separated by them.
char separator_of(const std::string& header) {
  for (const char separator : {',', ';', '\t'})
    if (header.find(separator) != std::string::npos) return separator;
  return ' ';
}

/// The separator of a line of numbers.
char separator_of_numbers(const std::string& line) {
  const char separator = separator_of(line);
  return separator == '\t' ? ' ' : separator;
}

std::vector<std::string> fields_of(const std::string& line, char separator) {
  return separator == ' ' ? split_at_blanks(line) : split(line, separator);
}

/// The column of a quantity by the first of its names that the header has.
std::optional<LogColumns::Source> find_column(const Aliases& aliases, const LogColumns& columns,
                                              const TextLines& lines) {
  std::vector<std::string> words = split_nonempty(aliases.others, ' ');
  words.insert(words.begin(), aliases.name);
  for (const std::string& alias : words) {
    std::optional<LogColumns::Source> found;
    for (std::size_t i = 0; i < columns.names.size(); ++i) {
      const auto [name, factor] = plain_name(columns.names[i]);
      if (!is_alias(name, alias)) continue;
      if (found)
        throw lines.error("duplicate column of " + aliases.name + ": '" +
                              columns.names[found->field] + "', '" + columns.names[i] + "'",
                          "each column once, or --columns " + aliases.name + "=COLUMN");
      found = {i, factor};
    }
    if (found) return found;
  }
  return std::nullopt;
}

/// The index of a name, in any case if it is not there as it is written. Throws Error (File) for a
/// name of two columns.
std::optional<std::size_t> index_of(const std::string& name, const std::vector<std::string>& names,
                                    const TextLines& lines) {
  std::vector<std::size_t> exact, similar;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) exact.push_back(i);
    if (lower_case(names[i]) == lower_case(name)) similar.push_back(i);
  }
  const std::vector<std::size_t>& found = exact.empty() ? similar : exact;
  if (found.size() > 1)
    throw lines.error("columns " + std::to_string(found[0] + 1) + " and " +
                          std::to_string(found[1] + 1) + " are both named '" + names[found[0]] +
                          "'",
                      "a header line with a name of its own for each column that is used");
  return found.empty() ? std::nullopt : std::optional(found[0]);
}

/// The COLUMN of NAME=COLUMN[*FACTOR].
std::string chosen_column(const std::string& text) {
  const std::size_t equal = text.find('='), star = text.rfind('*');
  const bool scaled = star != std::string::npos && star > equal;
  return trim(text.substr(equal + 1, scaled ? star - equal - 1 : std::string::npos));
}

/// Whether a header has all columns of --columns.
bool has_chosen_columns(const std::string& columns_option, const std::vector<std::string>& names) {
  const std::vector<std::string> choices = split_nonempty(columns_option, ',');
  return !choices.empty() &&
         std::all_of(choices.begin(), choices.end(), [&](const std::string& choice) {
           return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
             return lower_case(name) == lower_case(chosen_column(choice));
           });
         });
}

/// One NAME=COLUMN[*FACTOR] of --columns. A factor takes the place of the unit in the header.
void choose_column(const std::string& text, LogColumns& columns, const TextLines& lines) {
  std::vector<std::string> known;
  for (const Aliases& aliases : kAliases) known.push_back(aliases.name);
  const std::size_t equal = text.find('='), star = text.rfind('*');
  if (equal == std::string::npos)
    throw usage_error("--columns", "no '=' in '" + text + "'", "NAME=COLUMN or NAME=COLUMN*FACTOR");
  const std::string name = trim(text.substr(0, equal));
  const auto quantity = index_of(name, known, lines);
  if (!quantity)
    throw usage_error("--columns", "unknown name '" + name + "'", expected_name(name, known));
  if (columns.sources[*quantity])
    throw usage_error("--columns", "two columns of '" + name + "'", "one");
  const bool scaled = star != std::string::npos && star > equal;
  const std::string column = chosen_column(text);
  const auto field = index_of(column, columns.names, lines);
  if (!field)
    throw lines.error("no column '" + column + "' for " + name,
                      expected_name(column, columns.names, some_of(columns.names)));
  double factor = plain_name(columns.names[*field]).second;
  if (scaled && (!parse_number(trim(text.substr(star + 1)), factor) || factor == 0))
    throw usage_error("--columns", "invalid factor in '" + text + "'", "a number other than 0");
  columns.sources[*quantity] = {*field, factor};
}

/// The columns as the remark before a line of numbers names them; none if it does not.
std::optional<LogColumns> columns_of_remark(const std::string& line,
                                            const std::string& columns_option,
                                            const TextLines& lines) {
  LogColumns columns;
  columns.first_line_has_numbers = true;
  columns.separator = separator_of_numbers(line);
  std::string remark = lines.remark();
  remark = trim(remark.erase(0, remark.find_first_not_of('#')));
  columns.names = fields_of(remark, separator_of(remark));
  const bool has_names = columns.names.size() == fields_of(line, columns.separator).size() &&
                         (has_chosen_columns(columns_option, columns.names) ||
                          find_column(kAliases[kTime], columns, lines));
  return has_names ? std::optional(columns) : std::nullopt;
}

/// Appends "NAME.x", "NAME.y", ...
void append_members(std::vector<std::string>& names, const std::string& name,
                    const std::string& members) {
  for (const char member : members) names.push_back(name + "." + member);
}

void append_covariance(std::vector<std::string>& names, const std::string& name) {
  for (int i = 0; i < 36; ++i) names.push_back(name + ".covariance." + std::to_string(i));
}

struct EchoedMessage {
  std::string type;
  std::vector<std::string> names;  ///< of its fields, in their order
};

/// The messages with poses that `ros2 topic echo --csv` prints without the names of their fields
/// (geometry_msgs, nav_msgs of ROS 2).
std::vector<EchoedMessage> echoed_messages() {
  const std::vector<std::string> header = {"header.stamp.sec", "header.stamp.nanosec",
                                           "header.frame_id"};
  EchoedMessage pose{"PoseStamped", header};
  append_members(pose.names, "pose.position", "xyz");
  append_members(pose.names, "pose.orientation", "xyzw");
  EchoedMessage estimate{"PoseWithCovarianceStamped", header}, odometry{"Odometry", header};
  odometry.names.emplace_back("child_frame_id");
  for (EchoedMessage* message : {&estimate, &odometry}) {
    append_members(message->names, "pose.pose.position", "xyz");
    append_members(message->names, "pose.pose.orientation", "xyzw");
    append_covariance(message->names, "pose");
  }
  append_members(odometry.names, "twist.twist.linear", "xyz");
  append_members(odometry.names, "twist.twist.angular", "xyz");
  append_covariance(odometry.names, "twist");
  return {pose, estimate, odometry};
}

/// The columns of a message by the number of its fields and the frame among them, a text.
std::optional<LogColumns> columns_of_message(const std::vector<std::string>& fields) {
  double number = 0;
  for (const EchoedMessage& message : echoed_messages()) {
    if (fields.size() != message.names.size() || parse_number(fields[2], number)) continue;
    LogColumns columns;
    columns.first_line_has_numbers = true;
    columns.has_header = false;
    columns.names = message.names;
    columns.message = message.type;
    return columns;
  }
  return std::nullopt;
}

/// The names of the fields of a log whose first line of content has numbers.
LogColumns columns_without_header(const std::string& line, const std::string& columns_option,
                                  const TextLines& lines) {
  if (auto columns = columns_of_remark(line, columns_option, lines)) return *columns;
  LogColumns columns;
  columns.first_line_has_numbers = true;
  columns.separator = separator_of_numbers(line);
  const std::vector<std::string> fields = fields_of(line, columns.separator);
  const std::size_t count = fields.size();
  if (columns.separator == ',')
    if (auto message = columns_of_message(fields)) return *message;
  columns.has_header = false;
  columns.names = {"t", "x", "y", "z", "qx", "qy", "qz", "qw"};
  if (count == 7) columns.names = {"t", "x", "y", "z", "yaw", "pitch", "roll"};
  if (count == 4) columns.names = {"t", "x", "y", "phi"};
  if (columns.separator != ' ' || count != columns.names.size())
    throw lines.error("no header line before " + count_text(count, "field"),
                      "one with t, x, y; without: t x y z qx qy qz qw (TUM), "
                      "t x y z yaw pitch roll or t x y phi, separated by blanks, or Odometry (89), "
                      "PoseStamped (10) or PoseWithCovarianceStamped (46 fields) of ros2 topic "
                      "echo --csv");
  return columns;
}

}  // namespace

bool LogColumns::read(const std::string& line, LogRow& row, const TextLines& lines) const {
  std::vector<std::string> fields = fields_of(line, separator);
  std::vector<bool> used(fields.size(), false), is_nan(fields.size(), false);
  for (const auto& source : sources)
    if (source && source->field < used.size()) used[source->field] = true;
  if (nanoseconds && *nanoseconds < used.size()) used[*nanoseconds] = true;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    is_nan[i] = used[i] && lower_case(fields[i]) == "nan";
    if (!used[i] || is_nan[i]) fields[i] = "0";  // may be text
  }
  const std::vector<double> numbers = numbers_of(fields, names.size(), lines);
  bool complete = true;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (!sources[i]) continue;
    row[i] = numbers[sources[i]->field] * sources[i]->factor;
    if (!std::isfinite(row[i]))
      throw lines.error(kAliases[i].name + " is too large", "a finite number");
    if (!is_nan[sources[i]->field]) continue;
    const bool is_command = i == kCommandV || i == kCommandW || i == kCommandVy;
    row[i] = std::numeric_limits<double>::quiet_NaN();
    complete = complete && is_command;
  }
  if (nanoseconds) row[kTime] += 1e-9 * numbers[*nanoseconds];
  return complete;
}

std::string LogColumns::scaled(std::size_t quantity, double factor) const {
  const Source& source = *sources[quantity];
  return "--columns " + kAliases[quantity].name + "=" + names[source.field] + "*" +
         format_number(source.factor * factor);
}

std::string LogColumns::note() const {
  if (!message.empty()) return "read as " + message + " of ros2 topic echo --csv";
  if (!has_header) return names.size() == 8 ? "" : "no header line: read as " + join(names, " ");
  std::vector<std::string> unused;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!names[i].empty() && std::none_of(sources.begin(), sources.end(), [&](const auto& source) {
          return source && source->field == i;
        }))
      unused.push_back(names[i]);
  if (unused.empty()) return "";
  return count_text(unused.size(), "column") + " not used: " + some_of(unused);
}

bool is_header_before(const std::string& line, const std::string& columns_option,
                      const TextLines& lines) {
  return columns_of_remark(line, columns_option, lines).has_value();
}

LogColumns find_log_columns(const std::string& line, const std::string& columns_option,
                            const TextLines& lines) {
  LogColumns columns;
  columns.separator = separator_of(line);
  columns.names = fields_of(line, columns.separator);
  double number = 0;
  if (parse_number(fields_of(line, separator_of_numbers(line))[0], number))
    columns = columns_without_header(line, columns_option, lines);
  for (const std::string& choice : split_nonempty(columns_option, ','))
    choose_column(choice, columns, lines);
  auto& sources = columns.sources;
  if (!columns.message.empty() && !sources[kTime]) {
    sources[kTime] = LogColumns::Source{0, 1};
    columns.nanoseconds = 1;
  }
  for (std::size_t i = 0; i < sources.size(); ++i)
    if (!sources[i]) sources[i] = find_column(kAliases[i], columns, lines);
  for (const std::size_t i : {kTime, kX, kY})
    if (!sources[i])
      throw lines.error("missing column '" + kAliases[i].name + "'",
                        "a header line with t, x, y; or --columns " + kAliases[i].name +
                            "=COLUMN, one of " + some_of(columns.names));
  if (columns.has(kPhi) || !columns.has(kQz) || !columns.has(kQw))
    for (const std::size_t i : {kQx, kQy, kQz, kQw}) sources[i].reset();
  // EuRoC's logs are in ns and do not always say so.
  if (starts_with(columns.names[sources[kX]->field], "p_RS_R_x") &&
      columns.names[sources[kTime]->field] == "timestamp" && sources[kTime]->factor == 1)
    sources[kTime]->factor = 1e-9;
  return columns;
}

}  // namespace slalom
