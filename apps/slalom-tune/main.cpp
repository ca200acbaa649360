// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/method_option.h>
#include <slalom/app/output_folder.h>
#include <slalom/app/program.h>
#include <slalom/app/question_options.h>
#include <slalom/core/error.h>
#include <slalom/core/read_file.h>
#include <slalom/io/result_file.h>
#include <slalom/ros_parameters/resolve.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>

namespace slalom {
namespace {

namespace fs = std::filesystem;

constexpr char kCertificate[] = "tuned.json", kIni[] = "tuned.ini", kPage[] = "tuned.html",
               kYaml[] = "tuned.yaml", kDiff[] = "tuned.diff";

struct TuneArguments {
  AskArguments ask;
  std::string folder;
};

using Ids = std::set<std::string>;

Ids sealed_scenarios(const Json& certificate) {
  return certificate.at("answer").at("sealed_scenarios").get<Ids>();
}

/// The use of its sealed scenarios by searches in folders beside this one.
struct EarlierUse {
  std::size_t searches = 0;
  Ids scenarios = {};
};

EarlierUse earlier_use(const fs::path& folder, const Ids& sealed) {
  EarlierUse use;
  std::error_code ignored;
  const fs::path parent = fs::absolute(folder / "x").parent_path().parent_path();
  for (const fs::directory_entry& entry : fs::directory_iterator(parent, ignored)) {
    const fs::path file = entry.path() / kCertificate;
    if (fs::equivalent(entry.path(), folder, ignored) || !fs::is_regular_file(file, ignored))
      continue;
    try {
      Ids common;
      for (const std::string& id :
           sealed_scenarios(parse_certificate(read_file(file.string()), file.string())))
        if (sealed.count(id) > 0) common.insert(id);
      use.searches += common.empty() ? 0 : 1;
      use.scenarios.merge(common);
    } catch (const std::exception&) {
      // A file of something else.
    }
  }
  return use;
}

/// A search whose result is replaced would be a use of the sealed scenarios that nobody counts.
void refuse_other_search(const std::string& path, AskedQuestion& asked) {
  if (!fs::exists(path)) return;
  if (!answers(read_certificate(path), asked))
    throw usage_error(path, "is the result of another search",
                      "another folder (-o), since the sealed scenarios have been used");
}

/// The campaign with the recommended options.
std::string tuned_ini(const Json& certificate) {
  IniFile ini = IniFile::from_text(certificate.at("campaign.ini"));
  const auto method = certificate.at("question").at("method").get<std::string>();
  for (const auto& [key, value] : certificate.at("answer").at("recommendation").items())
    set_method_option(ini, method, key, value.get<std::string>());
  return ini.canonical_text();
}

/// The recommended options as parameters of Nav2 or move_base, if the method has a file of these:
/// its diff and, if it is one file, the file. What cannot be written is named.
void write_parameters(const CampaignArguments& campaign, const Json& certificate,
                      const fs::path& folder) {
  IniFile ini = IniFile::load(campaign.config);
  for (const std::string& assignment : campaign.overrides) ini.override_key(assignment);
  const auto method = certificate.at("question").at("method").get<std::string>();
  const Json& answer = certificate.at("answer");
  if (!ini.get("method." + method, "from")) return;
  for (const auto& [key, value] : answer.at("recommendation").items())
    if (value != answer.at("default").at(key))
      set_method_option(ini, method, key, value.get<std::string>());
  std::vector<RosParameterReport> reports = resolve_ros_parameters(ini);
  reports.erase(std::remove_if(reports.begin(), reports.end(),
                               [&](const RosParameterReport& report) {
                                 return report.section != "method." + method;
                               }),
                reports.end());
  for (const RosParameterReport& report : reports) {
    for (const std::string& parameter : report.not_in_file)
      print_notice("not in " + report.source + ": " + parameter);
    for (const std::string& key : report.no_way_back)
      if (answer.at("recommendation").contains(key))
        print_notice("no parameter of " + report.source + " is " + key + " = " +
                     answer.at("recommendation").at(key).get<std::string>());
  }
  const std::vector<EditedRosParameters> edited = edit_ros_parameters(reports);
  if (edited.empty()) return;
  write_file_atomically((folder / kDiff).string(), ros_parameter_diff(reports));
  std::cout << (folder / kDiff).string();
  if (edited.size() == 1) {
    write_file_atomically((folder / kYaml).string(), edited.front().text);
    std::cout << ", " << (folder / kYaml).string();
  }
  std::cout << "\n";
}

void tune(TuneArguments& arguments) {
  IniFile ini = load_campaign_ini(arguments.ask.campaign);
  const fs::path folder(arguments.folder);
  refuse_output_over_inputs((folder / kIni).string(), ini);
  make_output_folder(arguments.folder);
  AskedQuestion asked{std::move(arguments.ask.question), std::move(ini)};
  const std::string path = (folder / kCertificate).string();
  refuse_other_search(path, asked);
  const Answer answer = ask_and_print(arguments.ask, asked, path);
  write_file_atomically((folder / kIni).string(), tuned_ini(answer.certificate));
  write_file_atomically((folder / kPage).string(), certificate_page(answer.certificate, path));
  const Ids sealed = sealed_scenarios(answer.certificate);
  const EarlierUse use = earlier_use(folder, sealed);
  if (use.searches > 0)
    std::cout << use.scenarios.size() << " of " << sealed.size() << " sealed scenarios that "
              << use.searches << " other " << (use.searches == 1 ? "search" : "searches")
              << " beside this folder used, too: the confidence is that of one claim\n";
  std::cout << (folder / kIni).string() << ", " << path << ", " << (folder / kPage).string()
            << "\n";
  write_parameters(arguments.ask.campaign, answer.certificate, folder);
  require_enough(asked, answer);
}

void define(CLI::App& app) {
  static TuneArguments arguments;
  arguments.ask.question = make_question("tune");
  add_question_options(app, arguments.ask);
  app.add_option(
         "-o,--output", arguments.folder,
         "Folder for tuned.ini, tuned.json and tuned.html, and tuned.yaml and tuned.diff if the "
         "method has parameters of Nav2 or move_base; the same command continues a search "
         "that was interrupted")
      ->required();
  app.callback([] { tune(arguments); });
}

}  // namespace
}  // namespace slalom

int main(int argc, char** argv) {
  return slalom::run_program(
      "slalom-tune",
      "Searches better options of a method, and says with which confidence they are better than "
      "its defaults in scenarios that the search has not seen.",
      argc, argv, slalom::define);
}
