// SPDX-License-Identifier: BSD-3-Clause
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

FormField field_of(const Option& option, const std::string& prefix) {
  FormField field;
  field.key = field_key(prefix, option.key);
  field.label = label_of(option.key);
  field.help = option.help;
  field.value = option.text();
  field.unit = option.unit == "-" ? "" : option.unit;
  field.range = option.range;
  field.choices = option.choices;
  if (const double* number = option.get_if<double>()) {
    field.kind = FieldKind::Number;
    field.required = std::isfinite(*number);
    if (!field.required) field.value.clear();
  } else if (option.get_if<std::optional<double>>() != nullptr) {
    field.kind = FieldKind::Text;  // a number or a word
  } else if (option.get_if<bool>() != nullptr) {
    field.kind = FieldKind::Flag;
  } else if (option.get_if<std::string>() != nullptr) {
    field.kind = option.choices.empty() ? FieldKind::Text : FieldKind::Choice;
    field.required = false;
    field.wide = option.choices.empty();
  } else {
    field.kind = FieldKind::Integer;
    if (option.get_if<std::uint64_t>() != nullptr) field.range = Range::at_least(0);
  }
  return field;
}

}  // namespace

std::vector<FormField> option_fields(const VisitOptions& visit, const std::string& prefix,
                                     const std::vector<std::string>& without) {
  std::vector<FormField> fields;
  OptionFunction add([&](const Option& option) {
    if (!contains(without, option.key)) fields.push_back(field_of(option, prefix));
  });
  visit(add);
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
