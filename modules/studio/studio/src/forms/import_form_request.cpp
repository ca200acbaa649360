// SPDX-License-Identifier: BSD-3-Clause
#include "forms/requests.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/temporary_list.h>

#include <filesystem>

namespace slalom {
namespace {

constexpr char kIntoList[] = "this list", kIntoFile[] = "a new list";

namespace fs = std::filesystem;

constexpr char kSection[] = "import";

std::vector<FormField> fields_of(const VisitOptions& visit) {
  return option_fields(visit, "");
}

const StudioServices::Format& format_of(const StudioServices& services, const std::string& name) {
  for (const StudioServices::Format& format : services.export_formats)
    if (format.name == name) return format;
  throw usage_error("export", "unknown format '" + name + "'", "one of the listed formats");
}

}  // namespace

void add_target_fields(FormDescription& form, const ListTarget& target) {
  FormField into{"target", "Into", FieldKind::Choice, target.into_list ? kIntoList : kIntoFile};
  if (target.into_list) into.choices.emplace_back(kIntoList);
  into.choices.emplace_back(kIntoFile);
  FormField file{"file", "New list", FieldKind::Text, target.file, "", "path of a new file"};
  file.wide = true;
  file.shown_if_key = "target";
  file.shown_if_value = kIntoFile;
  file.extensions = {".scenarios"};
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

NewList make_list(const std::string& file, const std::function<void(ScenarioList&)>& fill) {
  NewList made;
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

AddedScenarios add_to_list(const std::string& path, const NewList& made, Progress& progress) {
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

FormDescription import_form(const StudioServices& services, const ListTarget& target,
                            const std::vector<std::string>& files) {
  FormDescription form;
  form.title = "Import";
  form.accept = "Import";
  form.intro =
      "Maps (MRPT, ROS, MovingAI, images) need a start and a goal, or a number of random pairs.";
  FormField paths{
      "files",           "Files", FieldKind::Text,
      join(files, ", "), "",      "maps, BARN worlds or folders, .scenario.yaml; comma separated"};
  paths.wide = true;
  paths.extensions = {""};
  paths.several = true;
  form.fields.push_back(paths);
  add_target_fields(form, target);
  for (const auto& [title, visit] : services.import_options) {
    form.fields.push_back({"about " + title, title, FieldKind::Heading});
    for (FormField& field : fields_of(visit)) form.fields.push_back(std::move(field));
  }
  return form;
}

FileImport read_import(const StudioServices& services, const FormValues& values) {
  FileImport request;
  const std::vector<std::string> files = split(values.at("files"), ',');
  const std::string hint = files.size() > 1 ? "; a comma in the name of a file divides it" : "";
  for (const std::string& file : files) {
    if (file.empty()) continue;
    if (!fs::exists(file)) throw usage_error(file, "does not exist", "a file or folder" + hint);
    request.files.push_back(file);
  }
  if (request.files.empty()) throw usage_error("files", "no file given", "one or more");
  request.file = read_target(values);
  request.options = IniFile::from_text("", "Import");
  for (const auto& [title, visit] : services.import_options)
    put_options(request.options, kSection, "", fields_of(visit), values);
  return request;
}

NewList import_into_list(const StudioServices& services, const FileImport& request,
                         Progress& progress) {
  std::vector<std::string> messages;
  NewList made = make_list(request.file, [&](ScenarioList& list) {
    const auto imported = services.import_files(request.files, request.options, progress);
    list.add_all(imported.scenarios);
    for (const auto& [key, text] : imported.notes) list.set_note(key, text);
    messages = imported.messages;
  });
  made.report = join(messages, "\n");
  return made;
}

FormDescription export_form(const StudioServices& services, const Scenario& scenario,
                            double resolution) {
  FormDescription form;
  form.title = "Export " + scenario.name();
  form.accept = "Export";
  FormField format{"format", "Format", FieldKind::Choice};
  std::vector<std::string> contents;
  for (const StudioServices::Format& one : services.export_formats) {
    format.choices.push_back(one.name);
    contents.push_back(one.name + ": " + one.content + " (" + one.extension + ")");
  }
  format.value = format.choices.empty() ? "" : format.choices.front();
  form.intro = join(contents, "; ");
  FormField file{"file",          "File", FieldKind::Text,
                 scenario.name(), "",     "the extension of the format is added if there is none"};
  file.wide = true;
  for (const StudioServices::Format& one : services.export_formats)
    file.extensions.push_back(one.extension);
  FormField cells{"resolution",
                  "Resolution",
                  FieldKind::Number,
                  format_number(resolution),
                  "m",
                  "cell size, if the format has cells and the scenario has none"};
  cells.range = Range::positive();
  FormField replace{"replace", "Replace", FieldKind::Flag, "false", "", "overwrite the file"};
  form.fields = {format, file, cells, replace};
  return form;
}

void check_export(const StudioServices& services, const FormValues& values) {
  const std::string& file = values.at("file");
  const std::string extension = format_of(services, values.at("format")).extension;
  const bool exists = fs::is_regular_file(file) || fs::is_regular_file(file + extension);
  if (exists && values.at("replace") != "true")
    throw usage_error(file, "already exists", "another name, or Replace");
}

std::string export_as(const StudioServices& services, const Scenario& scenario,
                      const FormValues& values) {
  double resolution = 0;
  parse_number(values.at("resolution"), resolution);
  return services.export_scenario(scenario, values.at("format"), resolution, values.at("file"));
}

}  // namespace slalom
