#pragma once

#include <slalom/gui/form.h>
#include <slalom/io/scenario_list.h>

#include <functional>
#include <memory>
#include <string>

namespace slalom {

/// Where new scenarios are to go unless the user says otherwise.
struct ListTarget {
  bool into_list = true;  ///< a list is open to which they can be added
  std::string file;       ///< for a new list
};

/// Scenarios that a worker made.
struct MadeList {
  std::shared_ptr<ScenarioList> aside;  ///< to be added by make_add_list(); null for a new list
  std::string file;                     ///< of the new list
  std::size_t size = 0;
  std::string report;  ///< lines about how it went; may be empty
};

/// Fields "target" and "file", for forms.
void add_target_fields(FormDescription& form, const ListTarget& target);
/// The new list that they name; empty when they name the open one. Throws Error (Usage) when it is
/// there already.
std::string read_target(const FormValues& values);

/// Fills a new list, or one aside where `file` is empty. The new list stands in its place once it
/// is whole; when `fill` throws, nothing is left of it.
MadeList make_list(const std::string& file, const std::function<void(ScenarioList&)>& fill);

}  // namespace slalom
