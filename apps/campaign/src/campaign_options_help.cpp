#include <slalom/app/adapters.h>
#include <slalom/app/campaign_program.h>
#include <slalom/campaign/scenario_sources.h>
#include <slalom/core/options.h>
#include <slalom/generation/generator.h>

namespace slalom {
namespace {

template <typename Options>
void list_section(std::string& text, const std::string& section) {
  Options options;
  OptionLister lister;
  options.visit(lister);
  text += (text.empty() ? "[" : "\n[") + section + "]\n" + lister.text();
}

}  // namespace

std::string campaign_options_help() {
  std::string text;
  list_section<CampaignSection>(text, "campaign");
  list_section<ScenariosSection>(text, "scenarios");
  for (const std::string& family : generator_names()) {
    OptionLister lister;
    visit_generator_options(family, lister);
    text += "\n[generator." + family + "]\n" + lister.text();
  }
  list_section<RobotModel>(text, "robot");
  list_section<SensorModel>(text, "sensor");
  list_section<OdometryModel>(text, "odometry");
  list_section<SimulationOptions>(text, "simulation");
  list_section<OmplOptions>(text, "reference");
  list_section<MetricsSection>(text, "metrics");
  list_section<LimitsSection>(text, "limits");
  list_section<RecordSection>(text, "record");
  list_section<AnalysisSection>(text, "analysis");
  return text + adapter_options_help();
}

}  // namespace slalom
