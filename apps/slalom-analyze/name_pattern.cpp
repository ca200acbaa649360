// SPDX-License-Identifier: BSD-3-Clause
#include "name_pattern.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <filesystem>

namespace slalom {
namespace {

constexpr const char* kExpected =
    "{method}, {scenario} and {repetition}, each at most once and with other characters between "
    "them, such as {method}_{scenario}_{repetition}.csv";

bool is_number(const std::string& text) {
  return text.find_first_not_of("0123456789") == std::string::npos;
}

/// The last `folders` of a path and its name.
std::string end_of(const std::string& path, std::size_t folders) {
  std::size_t begin = path.size();
  for (std::size_t i = 0; i <= folders && begin != std::string::npos && begin > 0; ++i)
    begin = path.rfind('/', begin - 1);
  return begin == std::string::npos || path[begin] != '/' ? path : path.substr(begin + 1);
}

}  // namespace

NamePattern::NamePattern(const std::string& text) {
  const auto malformed = [](const std::string& what) {
    return usage_error("--name-pattern", what, kExpected);
  };
  std::size_t begin = 0;
  while (begin < text.size()) {
    const bool is_field = text[begin] == '{';
    const std::size_t end = text.find(is_field ? '}' : '{', begin);
    if (is_field && end == std::string::npos) throw malformed("no } in '" + text + "'");
    const std::string part =
        text.substr(begin + (is_field ? 1 : 0), end - begin - (is_field ? 1 : 0));
    if (is_field && !contains({"method", "scenario", "repetition"}, part))
      throw malformed("unknown field {" + part + "}");
    if (is_field && has(part)) throw malformed("{" + part + "} twice");
    if (is_field && !parts_.empty() && parts_.back().is_field)
      throw malformed("nothing between {" + parts_.back().text + "} and {" + part + "}");
    parts_.push_back({is_field, part});
    begin = end == std::string::npos ? text.size() : end + (is_field ? 1 : 0);
  }
  const auto is_field = [](const Part& part) { return part.is_field; };
  if (std::none_of(parts_.begin(), parts_.end(), is_field))
    throw malformed("no field in '" + text + "'");
  folders_ = static_cast<std::size_t>(std::count(text.begin(), text.end(), '/'));
  has_extension_ = !parts_.back().is_field && parts_.back().text.find('.') != std::string::npos;
}

bool NamePattern::has(const std::string& field) const {
  return std::any_of(parts_.begin(), parts_.end(),
                     [&](const Part& part) { return part.is_field && part.text == field; });
}

std::vector<NamePattern::Fields> NamePattern::matches(const std::string& path) const {
  std::string name = end_of(std::filesystem::path(path).lexically_normal().string(), folders_);
  if (!has_extension_) name = std::filesystem::path(name).replace_extension().string();
  std::vector<Fields> found;
  Fields fields;
  match(0, name, fields, found);
  return found;
}

void NamePattern::match(std::size_t part, const std::string& rest, Fields& fields,
                        std::vector<Fields>& found) const {
  if (part == parts_.size()) {
    if (rest.empty()) found.push_back(fields);
    return;
  }
  const auto& [is_field, text] = parts_[part];
  if (!is_field) {
    if (starts_with(rest, text)) match(part + 1, rest.substr(text.size()), fields, found);
    return;
  }
  const std::size_t longest = std::min(rest.find('/'), rest.size());
  for (std::size_t size = 1; size <= longest; ++size) {
    const std::string value = rest.substr(0, size);
    if (text == "repetition" && !is_number(value)) break;
    fields[text] = value;
    match(part + 1, rest.substr(size), fields, found);
  }
}

}  // namespace slalom
