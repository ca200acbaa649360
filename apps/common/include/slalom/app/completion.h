// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>

#include <CLI/CLI.hpp>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace slalom {

using Words = std::vector<std::string>;

/// Names for a value, given the words of the command line up to it, the last one as far as it is
/// typed. It may read the files among them.
using NameSource = std::function<Words(const Words& words)>;

/// Lets shells complete the values of `option`, also one by one in lists and expressions. Options
/// with a fixed choice need no call.
void complete_with(CLI::Option* option, NameSource names);

/// The values of --set, SECTION.KEY=VALUE: keys, and the names that are their values.
class SettingNames {
 public:
  /// A visitor that adds the keys of a section, and the choices of those that have some.
  std::unique_ptr<OptionVisitor> collector(const std::string& section);
  /// Adds names to the values of SECTION.KEY, or a key without names.
  void add_names(const std::string& key, const Words& names);
  /// "SECTION.KEY=" of all keys; for a word with such a beginning, its values.
  Words matching(const std::string& word) const;

 private:
  std::map<std::string, Words> names_;
};

/// The names of the verbs that the help lists; empty for a program without verbs.
Words verb_names(const CLI::App& app);

/// The candidates for the last of `words`, which follow the name of the program: verbs, options or
/// values. Empty where a file name is expected.
Words complete(const CLI::App& app, const Words& words);

}  // namespace slalom
