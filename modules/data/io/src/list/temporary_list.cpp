// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/scratch_folder.h>
#include <slalom/io/temporary_list.h>

namespace slalom {
namespace {

/// The list is closed before its folder is removed. SQLite creates its journal next to the list.
struct ListInFolder {
  ScratchFolder folder;
  ScenarioList list = ScenarioList::create(folder.path() + "/new.scenarios");
};

}  // namespace

std::shared_ptr<ScenarioList> make_temporary_list() {
  const auto owner = std::make_shared<ListInFolder>();
  return {owner, &owner->list};
}

}  // namespace slalom
