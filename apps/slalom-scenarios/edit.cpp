#include "filter.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>

namespace slalom {
namespace {

struct EditArguments {
  FilterArguments filter;
  std::string add, remove, name;
};

void tag(const EditArguments& arguments) {
  if (arguments.add.empty() && arguments.remove.empty())
    throw usage_error("tag", "no tags specified", "--add A,B or --remove C");
  ScenarioList list = ScenarioList::open(arguments.filter.list.list);
  const ListSelection selection = select_scenarios(list, arguments.filter);
  make_tag_scenarios(list, selection, split(arguments.add, ','), split(arguments.remove, ','))
      ->execute();
}

void rename(const EditArguments& arguments) {
  const ListArguments& one = arguments.filter.list;
  ScenarioList list = ScenarioList::open(one.list);
  make_rename_scenario(list, list.find_entry(one.id).hash, arguments.name)->execute();
}

}  // namespace

void add_edit_verbs(CLI::App& app) {
  static EditArguments tagged, renamed;
  CLI::App* verb = add_filter_verb(app, "tag", "Add and remove tags", tagged.filter);
  verb->add_option("--add", tagged.add, "Tags, comma-separated");
  verb->add_option("--remove", tagged.remove, "Tags, comma-separated");
  verb->callback([] { tag(tagged); });

  verb = add_list_verb(app, "rename", "Rename a scenario", renamed.filter.list);
  add_scenario_argument(*verb, renamed.filter.list);
  verb->add_option("--name", renamed.name, "The new name")->required();
  verb->callback([] { rename(renamed); });
}

}  // namespace slalom
