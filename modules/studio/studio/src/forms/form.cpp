// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/studio/form.h>

#include <algorithm>
#include <limits>

namespace slalom {
namespace {

std::vector<std::string> parts_of(const std::string& value) {
  return value.empty() ? std::vector<std::string>() : split(value, ',');
}

std::string number_error(const FormField& field, const std::string& text) {
  const bool integer = field.kind == FieldKind::Integer;
  double number = 0;
  long long whole = 0;
  const bool valid = integer ? parse_integer(text, whole) : parse_number(text, number);
  if (valid && field.range.contains(integer ? static_cast<double>(whole) : number)) return "";
  const std::string range = field.range.text();
  return "'" + text + "' is not valid; expected " + (integer ? "an integer" : "a number") +
         (range == "any" ? "" : " " + range);
}

std::string choice_error(const FormField& field, const std::string& text) {
  for (const std::string& part :
       field.kind == FieldKind::Choices ? parts_of(text) : std::vector<std::string>{text})
    if (!contains(field.choices, part))
      return "'" + part + "' is not valid; expected one of " + join(field.choices, ", ");
  return "";
}

std::string kind_error(const FormField& field, const std::string& text) {
  switch (field.kind) {
    case FieldKind::Number:
    case FieldKind::Integer:
      return number_error(field, text);
    case FieldKind::Choice:
    case FieldKind::Choices:
      return choice_error(field, text);
    case FieldKind::Flag:
      return text == "true" || text == "false"
                 ? ""
                 : "'" + text + "' is not valid; expected true or false";
    case FieldKind::Text:
    case FieldKind::Heading:
      break;
  }
  return "";
}

}  // namespace

FormModel::FormModel(FormDescription description) : description_(std::move(description)) {
  for (const FormField& field : description_.fields)
    values_.push_back(field.kind == FieldKind::Flag && field.value.empty() ? "false" : field.value);
}

std::size_t FormModel::index_of(const std::string& key) const {
  std::vector<std::string> keys;
  for (std::size_t i = 0; i < fields().size(); ++i) {
    if (fields()[i].key == key) return i;
    keys.push_back(fields()[i].key);
  }
  throw usage_error(description_.title, "unknown field '" + key + "'",
                    "one of " + join(keys, ", "));
}

bool FormModel::is_shown(std::size_t field) const {
  const FormField& info = fields()[field];
  if (info.shown_if_key.empty()) return true;
  const std::size_t other = index_of(info.shown_if_key);
  return is_shown(other) && is_chosen(other, info.shown_if_value);
}

void FormModel::set_value(std::size_t field, const std::string& text) {
  values_[field] = text;
}

FormValues FormModel::values() const {
  FormValues values;
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (fields()[i].kind != FieldKind::Heading) values[fields()[i].key] = trim(values_[i]);
  return values;
}

bool FormModel::is_chosen(std::size_t field, const std::string& choice) const {
  if (fields()[field].kind != FieldKind::Choices) return values_[field] == choice;
  return contains(parts_of(values_[field]), choice);
}

void FormModel::choose(std::size_t field, const std::string& choice) {
  const FormField& info = fields()[field];
  if (info.kind == FieldKind::Flag) {
    values_[field] = values_[field] == "true" ? "false" : "true";
  } else if (info.kind == FieldKind::Choices) {
    const bool was_chosen = is_chosen(field, choice);
    std::vector<std::string> chosen;
    for (const std::string& one : info.choices)
      if (one == choice ? !was_chosen : is_chosen(field, one)) chosen.push_back(one);
    values_[field] = join(chosen, ", ");
  } else {
    values_[field] = choice;
  }
}

std::string FormModel::error_of(std::size_t field) const {
  const FormField& info = fields()[field];
  if (info.kind == FieldKind::Heading || !is_shown(field)) return "";
  const std::string text = trim(values_[field]);
  if (text.empty()) return info.required ? "is missing" : "";
  const std::string error = kind_error(info, text);
  return error.empty() && info.check ? info.check(text) : error;
}

std::optional<std::pair<std::size_t, std::string>> FormModel::first_error() const {
  for (std::size_t i = 0; i < fields().size(); ++i) {
    const std::string error = error_of(i);
    if (!error.empty()) return std::make_pair(i, fields()[i].label + ": " + error);
  }
  return std::nullopt;
}

}  // namespace slalom
