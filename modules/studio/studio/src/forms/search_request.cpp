// SPDX-License-Identifier: BSD-3-Clause
#include "forms/requests.h"

#include <slalom/core/error.h>

#include <filesystem>

namespace slalom {

FormDescription search_form(const std::string& folder) {
  FormDescription form;
  form.title = "Search failures";
  form.accept = "Search";
  form.intro = "Searches scenarios in which a method fails, and opens the smallest ones as a list.";
  FormField campaign{"campaign", "Campaign", FieldKind::Text,
                     "",         "",         "its .ini, with the method and witnesses"};
  FormField target{"folder",
                   "Folder",
                   FieldKind::Text,
                   folder,
                   "",
                   "for the list, a campaign that repeats it and a report; of a search that was "
                   "interrupted: continues it"};
  campaign.wide = target.wide = true;
  FormField runs{"runs", "Runs", FieldKind::Integer, "10000", "", "budget: runs of the method"};
  FormField failures{"failures", "Failures", FieldKind::Integer,
                     "10",       "",         "stop after this many failures"};
  runs.range = failures.range = Range::between(1, 1e9);
  campaign.extensions = {".ini"};
  target.extensions = {"/"};
  form.fields = {campaign,
                 {"method", "Method", FieldKind::Text, "", "", "of the campaign"},
                 target,
                 runs,
                 failures,
                 {"all_outcomes", "All outcomes", FieldKind::Flag, "false", "",
                  "also count stuck and timeout, which are frequent, as failures"},
                 {"witness", "Witness", FieldKind::Flag, "true", "",
                  "another method of the campaign must reach the goal"}};
  return form;
}

StudioServices::SearchRequest read_search(const FormValues& values) {
  const std::string& campaign = values.at("campaign");
  if (!std::filesystem::exists(campaign))
    throw usage_error(campaign, "does not exist", "the .ini of a campaign");
  return {campaign,
          values.at("method"),
          values.at("folder"),
          values.at("runs"),
          values.at("failures"),
          values.at("all_outcomes") == "true",
          values.at("witness") == "true"};
}

NewList search_into_list(const StudioServices& services,
                         const StudioServices::SearchRequest& request, Progress& progress) {
  NewList made;
  made.report = services.search_failures(request, progress);
  const std::string found = request.folder + "/failures.scenarios";
  if (std::filesystem::exists(found)) made.file = found;
  return made;
}

}  // namespace slalom
