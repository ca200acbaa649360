// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/adapters.h>
#include <slalom/app/campaign_names.h>
#include <slalom/app/campaign_program.h>
#include <slalom/campaign/scenario_sources.h>
#include <slalom/core/options.h>
#include <slalom/core/text.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/generation/generator.h>
#include <slalom/io/result_file.h>
#include <slalom/library/library_method.h>
#include <slalom/methods/barrier_filter.h>
#include <slalom/methods/registry.h>
#include <slalom/metrics/metric.h>
#include <slalom/ros_parameters/resolve.h>

#include <functional>

namespace slalom {
namespace {

/// Takes a section and the function that visits its options.
using SectionVisitor =
    std::function<void(const std::string& section, const std::function<void(OptionVisitor&)>&)>;

template <typename Options>
void visit_section(const SectionVisitor& visit, const std::string& section) {
  visit(section, [](OptionVisitor& visitor) { Options().visit(visitor); });
}

/// A section whose keys can come from a file of parameters.
template <typename Options>
void visit_section_with_source(const SectionVisitor& visit, const std::string& section) {
  visit(section, [](OptionVisitor& visitor) {
    Options().visit(visitor);
    RosParameterSource().visit(visitor);
  });
}

void visit_campaign_options(const SectionVisitor& visit) {
  visit_section<CampaignSection>(visit, "campaign");
  visit_section<ScenariosSection>(visit, "scenarios");
  for (const std::string& family : generator_names())
    visit("generator." + family,
          [&](OptionVisitor& visitor) { visit_generator_options(family, visitor); });
  visit_section_with_source<RobotModel>(visit, "robot");
  visit_section_with_source<SensorModel>(visit, "sensor");
  visit_section<LaserModel>(visit, "laser.NAME");
  visit_section<OdometryModel>(visit, "odometry");
  visit_section<TrackerModel>(visit, "tracks");
  visit_section_with_source<SimulationOptions>(visit, "simulation");
  visit_section<PeopleSettings>(visit, "people");
  visit_section<OmplOptions>(visit, "reference");
  visit_section<MetricsSection>(visit, "metrics");
  visit("limits", [](OptionVisitor& visitor) {
    DeadlineOptions().visit(visitor);
    LimitsSection().visit(visitor);
  });
  visit_section<RecordSection>(visit, "record");
  visit_section<AnalysisSection>(visit, "analysis");
  visit_adapter_options([&](const std::function<void(OptionVisitor&)>& visit_options) {
    visit("method.NAME", visit_options);
  });
  visit_section<MethodOptions>(visit, "method.NAME");
  visit_section<BarrierFilterOptions>(visit, "method.NAME");
  visit_section<RosParameterSource>(visit, "method.NAME");
}

}  // namespace

std::string campaign_options_help() {
  std::string text;
  visit_campaign_options([&](const std::string& section, const auto& visit_options) {
    OptionLister lister;
    visit_options(lister);
    text += (text.empty() ? "[" : "\n[") + section + "]\n" + lister.text();
  });
  return text;
}

Words setting_names(const Words& words) {
  const Words methods = known_methods(words);
  SettingNames names;
  visit_campaign_options([&](const std::string& section, const auto& visit_options) {
    const bool of_method = section == "method.NAME";
    for (const std::string& name : of_method ? methods : Words{""})
      visit_options(*names.collector(of_method ? "method." + name : section));
  });
  for (const std::string& name : methods)
    names.add_names("method." + name + ".plugin", shipped_plugins());
  names.add_names("campaign.methods", methods);
  names.add_names("scenarios.generator", generator_names());
  Words metrics = metric_ids();
  names.add_names("analysis.columns", metrics);
  metrics.insert(metrics.end(), {"all", "movers"});
  names.add_names("metrics.enabled", metrics);
  Words descriptors = descriptor_ids();
  descriptors.insert(descriptors.end(), {"all", "movers"});
  names.add_names("metrics.descriptors", descriptors);
  names.add_names("analysis.rows", descriptor_ids());
  return names.matching(words.back());
}

Words known_methods(const Words& words) {
  Words names;
  for (const std::string& word : words) {
    if (ends_with(word, ".results")) names = ResultFile::open(word).read_methods();
    if (!ends_with(word, ".ini")) continue;
    for (const std::string& section : IniFile::load(word).sections())
      if (starts_with(section, "method.")) names.push_back(section.substr(7));
  }
  return names;
}

}  // namespace slalom
