// SPDX-License-Identifier: BSD-3-Clause
#include "recorded_command.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

namespace slalom {
namespace {

ListCommandPtr command(ScenarioList& list, std::string title, RecordedCommand::Act act,
                       RecordedCommand::DisabledReason disabled_reason = nullptr) {
  return std::make_unique<RecordedCommand>(std::vector<ScenarioList*>{&list}, std::move(title),
                                           std::move(act), std::move(disabled_reason));
}

bool has_index(const ScenarioList& list, const std::string& name) {
  for (const ListIndex& index : list.indexes())
    if (index.name == name) return true;
  return false;
}

/// Why this scenario cannot be edited; empty if it can.
std::string missing_reason(const ScenarioList& list, const std::string& hash) {
  ListSelection one;
  one.hashes = {hash};
  return list.count(one) == 1 ? "" : "the scenario is not in the list";
}

}  // namespace

ListCommandPtr make_rename_scenario(ScenarioList& list, const std::string& hash,
                                    const std::string& name) {
  const std::string title = "Rename to " + name;
  return command(
      list, title, [&list, hash, name] { list.rename(hash, name); },
      [&list, hash, name] {
        return name.empty() ? "the name is empty" : missing_reason(list, hash);
      });
}

ListCommandPtr make_edit_scenario(ScenarioList& list, const std::string& hash,
                                  const Scenario& scenario) {
  return command(
      list, "Edit " + scenario.name(), [&list, hash, scenario] { list.replace(hash, scenario); },
      [&list, hash, next = scenario.hash()] {
        if (next != hash && missing_reason(list, next).empty())
          return std::string("the list already contains this scenario");
        return missing_reason(list, hash);
      });
}

ListCommandPtr make_tag_scenarios(ScenarioList& list, ListSelection selection,
                                  std::vector<std::string> add, std::vector<std::string> remove) {
  const std::size_t count = list.count(selection);
  std::vector<std::string> tags = add;
  for (const std::string& tag : remove) tags.push_back("not " + tag);
  const bool none = count == 0 || tags.empty();
  return command(
      list, "Tag " + scenarios_text(count) + " " + join(tags, ", "),
      [&list, selection = std::move(selection), add = std::move(add), remove = std::move(remove)] {
        list.tag(selection, add, remove);
      },
      [none] { return std::string(none ? "no scenarios or no tags selected" : ""); });
}

ListCommandPtr make_create_index(ScenarioList& list, ListIndex index) {
  const std::string title = "Create index " + index.name;
  const std::string name = index.name;
  return command(
      list, title, [&list, index = std::move(index)] { list.create_index(index); },
      [&list, name] {
        return std::string(has_index(list, name) ? "an index of this name already exists" : "");
      });
}

ListCommandPtr make_drop_index(ScenarioList& list, const std::string& name) {
  const std::string title = "Drop index " + name;
  return command(
      list, title, [&list, name] { list.drop_index(name); },
      [&list, name] {
        return std::string(has_index(list, name) ? "" : "no index of this name exists");
      });
}

}  // namespace slalom
