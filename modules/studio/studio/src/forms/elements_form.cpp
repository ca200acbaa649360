// SPDX-License-Identifier: BSD-3-Clause
#include "forms/elements_form.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <utility>

namespace slalom {

std::string element_key(const std::string& key, std::size_t index) {
  return key + "." + std::to_string(index);
}

FormDescription elements_form(const std::string& title, FormField choice,
                              const std::vector<std::string>& ids,
                              const std::function<std::vector<FormField>(std::size_t)>& fields_of) {
  FormDescription form;
  form.title = title;
  form.accept = "Apply";
  for (std::size_t i = 0; i < ids.size(); ++i)
    choice.choices.push_back(std::to_string(i + 1) + ": " + ids[i]);
  choice.value = choice.choices.empty() ? "" : choice.choices.front();
  form.fields.push_back(choice);
  for (std::size_t i = 0; i < ids.size(); ++i)
    for (FormField& field : fields_of(i)) {
      field.shown_if_key = choice.key;
      field.shown_if_value = choice.choices[i];
      form.fields.push_back(std::move(field));
    }
  return form;
}

std::vector<std::vector<double>> read_rows(const std::string& where, const std::string& text,
                                           std::size_t width, const std::string& what,
                                           const std::string& expected) {
  std::vector<std::vector<double>> rows;
  for (const std::string& part : split_nonempty(text, ';')) {
    const std::vector<std::string> words = split_nonempty(part, ' ');
    std::vector<double> numbers(words.size());
    bool valid = words.size() == width;
    for (std::size_t i = 0; valid && i < width; ++i) valid = parse_number(words[i], numbers[i]);
    if (!valid) throw usage_error(where, "'" + part + "' is not " + what, expected);
    rows.push_back(std::move(numbers));
  }
  return rows;
}

std::string rows_text(const std::vector<std::vector<double>>& rows) {
  std::vector<std::string> texts;
  for (const std::vector<double>& row : rows) {
    std::vector<std::string> words;
    for (const double number : row) words.push_back(format_number(number));
    texts.push_back(join(words, " "));
  }
  return join(texts, "; ");
}

}  // namespace slalom
