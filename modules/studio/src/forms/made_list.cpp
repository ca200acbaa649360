#include "forms/made_list.h"

#include <slalom/core/error.h>
#include <slalom/io/temporary_list.h>

#include <filesystem>

namespace slalom {
namespace {

constexpr char kIntoList[] = "this list", kIntoFile[] = "a new list";

}  // namespace

void add_target_fields(FormDescription& form, const ListTarget& target) {
  FormField into{"target", "Into", FieldKind::Choice, target.into_list ? kIntoList : kIntoFile};
  if (target.into_list) into.choices.emplace_back(kIntoList);
  into.choices.emplace_back(kIntoFile);
  FormField file{"file", "New list", FieldKind::Text, target.file, "", "path of a new file"};
  file.wide = true;
  file.shown_if_key = "target";
  file.shown_if_value = kIntoFile;
  form.fields.push_back(into);
  form.fields.push_back(file);
}

std::string read_target(const FormValues& values) {
  if (values.at("target") != kIntoFile) return "";
  const std::string& file = values.at("file");
  if (std::filesystem::exists(file))
    throw usage_error(file, "already exists", "the path of a new file");
  return file;
}

MadeList make_list(const std::string& file, const std::function<void(ScenarioList&)>& fill) {
  MadeList made;
  const auto fill_and_count = [&](ScenarioList& list) {
    fill(list);
    made.size = list.size();
  };
  if (file.empty()) {
    made.staging = make_temporary_list();
    fill_and_count(*made.staging);
  } else {
    ScenarioList::write(file, fill_and_count);
    made.file = file;
  }
  return made;
}

AddedScenarios add_to_list(const std::string& path, const MadeList& made, Progress& progress) {
  AddedScenarios added;
  const auto target = std::make_shared<ScenarioList>(ScenarioList::open(path));
  const auto entries = made.staging->entries();
  if (!entries.empty()) added.first = entries.front().hash;
  const std::size_t before = target->size();
  ListCommandPtr command = make_add_list(made.staging, *target, progress);
  if (const std::string reason = command->disabled_reason(); !reason.empty())
    throw job_error(path, reason);
  command->execute();
  added.count = target->size() - before;
  added.command = make_already_executed(target, std::move(command));
  return added;
}

}  // namespace slalom
