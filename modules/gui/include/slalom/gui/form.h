#pragma once

#include <slalom/core/options.h>

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

using FormValues = std::map<std::string, std::string>;  ///< text of each field by its key

enum class FieldKind {
  Text,
  Number,   ///< within `range`
  Integer,  ///< within `range`
  Choice,   ///< one of `choices`
  Choices,  ///< any of them, comma separated in their order
  Flag,     ///< true or false
  Heading   ///< only a line of text
};

/// One thing that a form asks for.
struct FormField {
  std::string key;
  std::string label;
  FieldKind kind = FieldKind::Text;
  std::string value = {};  ///< at first
  std::string unit = {};
  std::string help = {};
  std::vector<std::string> choices = {};
  Range range = Range::any();
  bool required = true;  ///< otherwise it may stay empty
  bool wide = false;     ///< for long texts such as paths
  /// What is wrong with a text, or nothing; called when the kind has nothing against it.
  std::function<std::string(const std::string&)> check = {};
  /// The field is only shown (and checked) while the field of this key has this value, or has it
  /// among its choices.
  std::string shown_if_key = {}, shown_if_value = {};
};

/// What a dialog asks for, and what becomes of the answers. Without fields it is a message: its
/// intro, however long, and one button.
struct FormDescription {
  std::string title;
  std::string accept = "OK";  ///< on the button
  std::string intro = {};     ///< lines above the fields
  std::vector<FormField> fields = {};
  /// Takes the values of all fields, hidden ones too. What it throws as slalom::Error is shown in
  /// the form, which then stays open.
  std::function<void(const FormValues&)> accepted = {};
};

/// A form that is being filled in, without the way it looks.
class FormModel {
 public:
  explicit FormModel(FormDescription description);

  const FormDescription& description() const { return description_; }
  const std::vector<FormField>& fields() const { return description_.fields; }
  std::size_t index_of(const std::string& key) const;  ///< throws Error (Usage) naming the keys
  bool is_shown(std::size_t field) const;

  const std::string& value(std::size_t field) const { return values_[field]; }
  void set_value(std::size_t field, const std::string& text);
  FormValues values() const;

  bool is_chosen(std::size_t field, const std::string& choice) const;
  /// Takes a choice; of Choices, or with a flag, takes it or leaves it.
  void choose(std::size_t field, const std::string& choice);

  /// What is wrong with a field, "" where nothing is; a hidden one is never wrong.
  std::string error_of(std::size_t field) const;
  /// The first field that is wrong and "LABEL: what".
  std::optional<std::pair<std::size_t, std::string>> first_error() const;

 private:
  FormDescription description_;
  std::vector<std::string> values_;
};

}  // namespace slalom
