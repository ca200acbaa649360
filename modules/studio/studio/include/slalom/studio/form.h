// SPDX-License-Identifier: BSD-3-Clause
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
  Choices,  ///< any of `choices`, comma separated, in the order of `choices`
  Flag,     ///< true or false
  Heading   ///< a line of text without a value
};

/// A field of a form.
struct FormField {
  std::string key;
  std::string label;
  FieldKind kind = FieldKind::Text;
  std::string value = {};  ///< initial value
  std::string unit = {};
  std::string help = {};
  std::vector<std::string> choices = {};
  Range range = Range::any();
  bool required = true;  ///< otherwise the value may be empty
  bool wide = false;     ///< for long texts such as paths
  /// Returns an error message for a text that is valid for the kind; empty for none.
  std::function<std::string(const std::string&)> check = {};
  /// If set, the field is shown (and checked) only while the field of this key has this value, or
  /// has it among its chosen values.
  std::string shown_if_key = {}, shown_if_value = {};
  /// For paths: the form offers folders, and the files whose names end in one of these; "" is any,
  /// "/" is none.
  std::vector<std::string> extensions = {};
  bool several = false;  ///< paths, comma separated; the form offers files for the last one
};

/// Content of a dialog. Without fields it is a message, its intro text and one button, or a
/// question if `accepted` is set.
struct FormDescription {
  std::string title;
  std::string accept = "OK";  ///< label of the button
  std::string intro = {};     ///< text above the fields
  std::vector<FormField> fields = {};
  /// Called with the values of all fields, including hidden ones. The form shows an exception and
  /// stays open.
  std::function<void(const FormValues&)> accepted = {};
};

/// State of a form that is being filled in, independent of its presentation.
class FormModel {
 public:
  explicit FormModel(FormDescription description);

  const FormDescription& description() const { return description_; }
  const std::vector<FormField>& fields() const { return description_.fields; }
  std::size_t index_of(const std::string& key) const;  ///< throws Error (Usage) with the known keys
  bool is_shown(std::size_t field) const;

  const std::string& value(std::size_t field) const { return values_[field]; }
  void set_value(std::size_t field, const std::string& text);
  FormValues values() const;

  bool is_chosen(std::size_t field, const std::string& choice) const;
  /// Selects a choice; toggles it for Choices and Flag fields.
  void choose(std::size_t field, const std::string& choice);

  /// The error message of a field; empty if it is valid or hidden.
  std::string error_of(std::size_t field) const;
  /// The first invalid field and "LABEL: MESSAGE".
  std::optional<std::pair<std::size_t, std::string>> first_error() const;

 private:
  FormDescription description_;
  std::vector<std::string> values_;
};

}  // namespace slalom
