// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/completion.h>
#include <slalom/core/text.h>

namespace slalom {
namespace {

std::map<const CLI::Option*, NameSource>& sources() {
  static std::map<const CLI::Option*, NameSource> by_option;
  return by_option;
}

/// The names of a fixed choice, "TEXT:{a,b}" in the help.
Words choices(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t begin = type.find('{'), end = type.find('}');
  if (begin == std::string::npos || end == std::string::npos) return {};
  return split(type.substr(begin + 1, end - begin - 1), ',');
}

bool takes_value(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

/// The option that a word names, or nullptr.
const CLI::Option* option_of(const CLI::App& app, const std::string& word) {
  return word.size() > 1 && word[0] == '-' ? app.get_option_no_throw(word.substr(0, word.find('=')))
                                           : nullptr;
}

Words with_prefix(const Words& names, const std::string& typed, const std::string& before) {
  Words found;
  for (const std::string& name : names)
    if (starts_with(name, typed)) found.push_back(before + name);
  return found;
}

/// Candidates for `value`, of which `before` is the start of the same word.
Words complete_value(const CLI::Option& option, const Words& words, const std::string& value,
                     const std::string& before) {
  const auto source = sources().find(&option);
  const Words names = source == sources().end() ? choices(option) : source->second(words);
  const Words whole = with_prefix(names, value, before);
  const std::size_t separator = value.find_last_of(",; ");
  if (!whole.empty() || separator == std::string::npos) return whole;
  return with_prefix(names, value.substr(separator + 1), before + value.substr(0, separator + 1));
}

Words option_names(const CLI::App& app) {
  Words names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames())
      if (!option->get_group().empty()) names.push_back("--" + name);
  return names;
}

/// Position of the last word: in a verb, perhaps as the value of an option.
struct Place {
  const CLI::App* verb;
  const CLI::Option* option = nullptr;
};

Place place_of_last(const CLI::App& app, const Words& words) {
  Place place{&app};
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (place.option != nullptr) {
      place.option = nullptr;
    } else if (const CLI::Option* option = option_of(*place.verb, words[i])) {
      if (takes_value(*option) && words[i].find('=') == std::string::npos) place.option = option;
    } else if (contains(verb_names(*place.verb), words[i])) {
      place.verb = place.verb->get_subcommand(words[i]);
    }
  }
  return place;
}

}  // namespace

void complete_with(CLI::Option* option, NameSource names) {
  sources()[option] = std::move(names);
}

std::unique_ptr<OptionVisitor> SettingNames::collector(const std::string& section) {
  return std::make_unique<OptionFunction>([this, section](const Option& option) {
    const bool flag = option.get_if<bool>() != nullptr;
    add_names(section + "." + option.key, flag ? Words{"true", "false"} : option.choices);
  });
}

void SettingNames::add_names(const std::string& key, const Words& names) {
  Words& known = names_[key];
  known.insert(known.end(), names.begin(), names.end());
}

Words SettingNames::matching(const std::string& word) const {
  const std::size_t equals = word.find('=');
  const auto found = names_.find(word.substr(0, equals));
  Words words;
  if (equals == std::string::npos) {
    for (const auto& [key, names] : names_) words.push_back(key + "=");
  } else if (found != names_.end()) {
    const std::size_t start = std::max(equals, word.find_last_of(',')) + 1;
    const std::string before =
        word.substr(0, word.find(',') == std::string::npos ? equals + 1 : start);
    for (const std::string& name : found->second) words.push_back(before + name);
  }
  return words;
}

Words verb_names(const CLI::App& app) {
  const auto is_listed = [](const CLI::App* verb) { return !verb->get_group().empty(); };
  Words names;
  for (const CLI::App* verb : app.get_subcommands(is_listed)) names.push_back(verb->get_name());
  return names;
}

Words complete(const CLI::App& app, const Words& words) {
  const Place place = place_of_last(app, words);
  const std::string word = words.empty() ? "" : words.back();
  if (place.option != nullptr) return complete_value(*place.option, words, word, "");
  const CLI::Option* option = option_of(*place.verb, word);
  const std::size_t equals = word.find('=');
  if (option != nullptr && equals != std::string::npos)
    return complete_value(*option, words, word.substr(equals + 1), word.substr(0, equals + 1));
  return with_prefix(
      !word.empty() && word[0] == '-' ? option_names(*place.verb) : verb_names(*place.verb), word,
      "");
}

}  // namespace slalom
