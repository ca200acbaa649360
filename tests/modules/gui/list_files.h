#pragma once

#include "error_text.h"
#include "io_sample.h"

#include <slalom/commands/describe_list.h>
#include <slalom/gui/list_document.h>

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace slalom {

/// Lists of small places for tests of what a window shows of them.
class ListFiles : public testing::Test {
 protected:
  static Scenario place(int number) {
    return Scenario::continuous("place_" + std::to_string(number), {0, 0, 10, 8},
                                {{{{5, 4}, 1}}, {}}, {1, 1, 0}, {9, 1 + 1e-5 * number});
  }
  static std::string hash_of(int number) { return place(number).hash(); }

  /// Places from `first` on, in order. Their density, made up: (number mod 10) / 10, NA where the
  /// number leaves 8 over when divided by 10, never computed where it leaves 9. Every third is
  /// tagged "hard".
  std::string make_list(const std::string& name, int count, int first = 0) const {
    const std::string path = folder_ / name;
    const DescriptorKey key = descriptor_view({"density"}, {}).at("density").front();
    ScenarioList::write(path, [&](ScenarioList& list) {
      for (int i = first; i < first + count; ++i) {
        const Scenario scenario = place(i);
        list.add(scenario,
                 {"test",
                  {},
                  i % 3 == 0 ? std::vector<std::string>{"hard"} : std::vector<std::string>{}});
        if (i % 10 != 9)
          list.keep(scenario.hash(), key.id, key.version, key.parameters,
                    i % 10 == 8 ? Value::na("no reason") : Value::of(i % 10 / 10.0));
      }
    });
    return path;
  }

  /// The numbers of the places that are shown, from top to bottom.
  static std::vector<int> numbers(const ScenarioList& list, const ListView& view) {
    std::map<std::string, int> number;
    for (const auto& entry : list.entries()) number[entry.hash] = std::stoi(entry.name.substr(6));
    std::vector<int> shown;
    for (const std::string& hash : view.hashes) shown.push_back(number.at(hash));
    return shown;
  }

  TemporaryFolder folder_;
};

/// One of them as a window shows it, with ten places.
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
