#include <slalom/core/error.h>
#include <slalom/core/options.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr char kSeedRange[] = "in [0, 9223372036854775807]";
constexpr std::uint64_t kMaxSeed = std::numeric_limits<std::int64_t>::max();

Error invalid_value(const std::string& where, const std::string& text,
                    const std::string& expected) {
  return usage_error(where, "'" + text + "' is not valid", expected);
}

void check_choice(const std::string& where, const std::string& text,
                  const std::vector<std::string>& choices) {
  if (!choices.empty() && !contains(choices, text))
    throw invalid_value(where, text, "one of " + join(choices, ", "));
}

}  // namespace

bool Range::contains(double value) const {
  return (low_open ? value > low : value >= low) && value <= high;
}

std::string Range::text() const {
  const bool bounded_below = low > -std::numeric_limits<double>::infinity();
  const bool bounded_above = high < std::numeric_limits<double>::infinity();
  if (bounded_below && bounded_above)
    return std::string("in ") + (low_open ? "(" : "[") + format_number(low) + ", " +
           format_number(high) + "]";
  if (bounded_below) return (low_open ? "> " : ">= ") + format_number(low);
  if (bounded_above) return "<= " + format_number(high);
  return "any";
}

void OptionReader::option(const std::string& key, double& value, const std::string&,
                          const std::string&, Range range) {
  known_.push_back(key);
  const auto text = ini_.get(section_, key);
  if (!text) return;
  double number = 0;
  if (!parse_number(*text, number) || !range.contains(number))
    throw invalid_value(ini_.where(section_, key), *text, "a number " + range.text());
  value = number;
}

void OptionReader::option(const std::string& key, int& value, const std::string&,
                          const std::string&, Range range) {
  known_.push_back(key);
  const auto text = ini_.get(section_, key);
  if (!text) return;
  long long number = 0;
  if (!parse_integer(*text, number) || !range.contains(static_cast<double>(number)) ||
      number > std::numeric_limits<int>::max() || number < std::numeric_limits<int>::min())
    throw invalid_value(ini_.where(section_, key), *text, "an integer " + range.text());
  value = static_cast<int>(number);
}

void OptionReader::option(const std::string& key, std::uint64_t& value, const std::string&) {
  known_.push_back(key);
  const auto text = ini_.get(section_, key);
  if (!text) return;
  long long number = 0;
  if (!parse_integer(*text, number) || number < 0)
    throw invalid_value(ini_.where(section_, key), *text, std::string("an integer ") + kSeedRange);
  value = static_cast<std::uint64_t>(number);
}

void OptionReader::option(const std::string& key, bool& value, const std::string&) {
  known_.push_back(key);
  const auto text = ini_.get(section_, key);
  if (!text) return;
  if (*text == "true" || *text == "yes" || *text == "on" || *text == "1") {
    value = true;
  } else if (*text == "false" || *text == "no" || *text == "off" || *text == "0") {
    value = false;
  } else {
    throw invalid_value(ini_.where(section_, key), *text, "true or false");
  }
}

void OptionReader::option(const std::string& key, std::string& value, const std::string&,
                          const std::vector<std::string>& choices) {
  known_.push_back(key);
  const auto text = ini_.get(section_, key);
  if (!text) return;
  check_choice(ini_.where(section_, key), *text, choices);
  value = *text;
}

void OptionReader::reject_unknown_keys() const {
  for (const std::string& key : ini_.keys(section_)) {
    if (contains(known_, key)) continue;
    throw usage_error(ini_.where(section_, key), "unknown key", expected_name(key, known_));
  }
}

void OptionLister::option(const std::string& key, double& value, const std::string& unit,
                          const std::string& help, Range range) {
  lines_.push_back({key, format_number(value), unit, range.text(), help});
}

void OptionLister::option(const std::string& key, int& value, const std::string& unit,
                          const std::string& help, Range range) {
  lines_.push_back({key, std::to_string(value), unit, range.text(), help});
}

void OptionLister::option(const std::string& key, std::uint64_t& value, const std::string& help) {
  lines_.push_back({key, std::to_string(value), "-", kSeedRange, help});
}

void OptionLister::option(const std::string& key, bool& value, const std::string& help) {
  lines_.push_back({key, value ? "true" : "false", "-", "true or false", help});
}

void OptionLister::option(const std::string& key, std::string& value, const std::string& help,
                          const std::vector<std::string>& choices) {
  lines_.push_back({key, value.empty() ? "(none)" : value, "-",
                    choices.empty() ? "text" : join(choices, " | "), help});
}

OptionLocation location_in(const IniFile& ini, const std::string& section) {
  return [ini, section](const std::string& key) {
    return key.empty() ? ini.where(section) : ini.where(section, key);
  };
}

OptionLocation location_of(const std::string& maker) {
  return [maker](const std::string& key) { return key.empty() ? maker : maker + "." + key; };
}

void OptionChecker::option(const std::string& key, double& value, const std::string&,
                           const std::string&, Range range) {
  if (!std::isfinite(value) || !range.contains(value))
    throw invalid_value(where_(key), format_number(value), "a number " + range.text());
}

void OptionChecker::option(const std::string& key, int& value, const std::string&,
                           const std::string&, Range range) {
  if (!range.contains(value))
    throw invalid_value(where_(key), std::to_string(value), "an integer " + range.text());
}

void OptionChecker::option(const std::string& key, std::uint64_t& value, const std::string&) {
  if (value > kMaxSeed)
    throw invalid_value(where_(key), std::to_string(value),
                        std::string("an integer ") + kSeedRange);
}

void OptionChecker::option(const std::string&, bool&, const std::string&) {}

void OptionChecker::option(const std::string& key, std::string& value, const std::string&,
                           const std::vector<std::string>& choices) {
  check_choice(where_(key), value, choices);
}

void OptionWriter::option(const std::string& key, double& value, const std::string&,
                          const std::string&, Range) {
  write_(key, format_number(value));
}

void OptionWriter::option(const std::string& key, int& value, const std::string&,
                          const std::string&, Range) {
  write_(key, std::to_string(value));
}

void OptionWriter::option(const std::string& key, std::uint64_t& value, const std::string&) {
  write_(key, std::to_string(value));
}

void OptionWriter::option(const std::string& key, bool& value, const std::string&) {
  write_(key, value ? "true" : "false");
}

void OptionWriter::option(const std::string& key, std::string& value, const std::string&,
                          const std::vector<std::string>&) {
  write_(key, value);
}

std::string OptionLister::text() const {
  std::string text;
  for (const Line& line : lines_) {
    std::string row = "  " + line.key + " = " + line.default_value;
    if (line.unit != "-") row += " " + line.unit;
    row.resize(std::max<std::size_t>(row.size() + 1, 34), ' ');
    text += row + line.help + " (" + line.range + ")\n";
  }
  return text;
}

}  // namespace slalom
