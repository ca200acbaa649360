// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "error_text.h"
#include "io_sample.h"

#include <slalom/commands/describe_list.h>
#include <slalom/studio/list_document.h>

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace slalom {

/// Lists of small scenarios for tests of the window.
class ListFiles : public testing::Test {
 protected:
  static Scenario make_scenario(int number) {
    return Scenario::continuous("world_" + std::to_string(number), {0, 0, 10, 8},
                                {{{{5, 4}, 1}}, {}}, {1, 1, 0}, {9, 1 + 1e-5 * number});
  }
  static std::string hash_of(int number) { return make_scenario(number).hash(); }

  /// Scenarios numbered from `first`, in order. Their density is fictitious: (number mod 10) / 10,
  /// NA if number mod 10 is 8, not computed if it is 9. Every third is tagged "hard".
  std::string make_list(const std::string& name, int count, int first = 0) const {
    const std::string path = folder_ / name;
    const ValueKey key = descriptor_view({"density"}, {}).at("density").front();
    ScenarioList::write(path, [&](ScenarioList& list) {
      for (int i = first; i < first + count; ++i) {
        const Scenario scenario = make_scenario(i);
        list.add(scenario,
                 {"test",
                  {},
                  i % 3 == 0 ? std::vector<std::string>{"hard"} : std::vector<std::string>{}});
        if (i % 10 != 9)
          list.store_value(scenario.hash(),
                           {key, i % 10 == 8 ? Value::na("no reason") : Value::of(i % 10 / 10.0)});
      }
    });
    return path;
  }

  /// The numbers of the scenarios in a view, from top to bottom.
  static std::vector<int> numbers(const ScenarioList& list, const ListView& view) {
    std::map<std::string, int> number;
    for (const auto& entry : list.entries()) number[entry.hash] = std::stoi(entry.name.substr(6));
    std::vector<int> shown;
    for (const std::string& hash : view.hashes) shown.push_back(number.at(hash));
    return shown;
  }

  TemporaryFolder folder_;
};

/// An open list of ten scenarios.
class OpenList : public ListFiles {
 protected:
  void SetUp() override { document_.refresh(); }
  using Numbers = std::vector<int>;

  static Numbers shown(ListDocument& document) { return numbers(document.list(), document.view()); }
  Numbers shown() { return shown(document_); }
  Numbers selected() {
    ListView view;
    view.hashes = document_.selected();
    return numbers(document_.list(), view);
  }
  void select(const Numbers& chosen) {
    std::vector<std::string> hashes;
    for (const int number : chosen) hashes.push_back(hash_of(number));
    document_.select(hashes);
  }

  std::string path_ = make_list("a.scenarios", 10);
  ListDocument document_{path_};
};

}  // namespace slalom
