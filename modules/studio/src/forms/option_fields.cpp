#include "forms/requests.h"

#include <slalom/core/text.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

std::string field_key(const std::string& prefix, const std::string& key) {
  return prefix.empty() ? key : prefix + "." + key;
}

/// A readable label: "Min obstacles" for "min_obstacles".
std::string label_of(std::string key) {
  std::replace(key.begin(), key.end(), '_', ' ');
  if (!key.empty() && key[0] >= 'a' && key[0] <= 'z') key[0] = static_cast<char>(key[0] - 32);
  return key;
}

class FieldLister : public OptionVisitor {
 public:
  explicit FieldLister(std::string prefix) : prefix_(std::move(prefix)) {}

  void option(const std::string& key, double& value, const std::string& unit,
              const std::string& help, Range range) override {
    FormField& field = add(key, FieldKind::Number, help);
    field.unit = unit == "-" ? "" : unit;
    field.range = range;
    field.required = std::isfinite(value);
    if (field.required) field.value = format_number(value);
  }
  void option(const std::string& key, int& value, const std::string& unit, const std::string& help,
              Range range) override {
    FormField& field = add(key, FieldKind::Integer, help);
    field.unit = unit == "-" ? "" : unit;
    field.range = range;
    field.value = std::to_string(value);
  }
  void option(const std::string& key, std::uint64_t& value, const std::string& help) override {
    FormField& field = add(key, FieldKind::Integer, help);
    field.range = Range::at_least(0);
    field.value = std::to_string(value);
  }
  void option(const std::string& key, bool& value, const std::string& help) override {
    add(key, FieldKind::Flag, help).value = value ? "true" : "false";
  }
  void option(const std::string& key, std::string& value, const std::string& help,
              const std::vector<std::string>& choices) override {
    FormField& field = add(key, choices.empty() ? FieldKind::Text : FieldKind::Choice, help);
    field.value = value;
    field.choices = choices;
    field.required = false;
    field.wide = choices.empty();
  }

  std::vector<FormField> fields;

 private:
  FormField& add(const std::string& key, FieldKind kind, const std::string& help) {
    FormField field;
    field.key = field_key(prefix_, key);
    field.label = label_of(key);
    field.kind = kind;
    field.help = help;
    fields.push_back(std::move(field));
    return fields.back();
  }

  std::string prefix_;
};

}  // namespace

std::vector<FormField> option_fields(const VisitOptions& visit, const std::string& prefix,
                                     const std::vector<std::string>& without) {
  FieldLister lister(prefix);
  visit(lister);
  std::vector<FormField> fields;
  for (FormField& field : lister.fields) {
    const bool excluded = std::any_of(without.begin(), without.end(), [&](const std::string& key) {
      return field.key == field_key(prefix, key);
    });
    if (!excluded) fields.push_back(std::move(field));
  }
  return fields;
}

void put_options(IniFile& ini, const std::string& section, const std::string& prefix,
                 const std::vector<FormField>& fields, const FormValues& values) {
  const std::size_t prefix_size = prefix.empty() ? 0 : prefix.size() + 1;
  for (const FormField& field : fields) {
    const auto value = values.find(field.key);
    if (value == values.end() || value->second == field.value) continue;
    ini.set(section, field.key.substr(prefix_size), value->second);
  }
}

}  // namespace slalom
