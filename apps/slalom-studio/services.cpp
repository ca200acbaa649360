#include "services.h"

#include <slalom/app/import_scenarios.h>
#include <slalom/core/options.h>
#include <slalom/map_formats/map_export.h>

namespace slalom {
namespace {

using Visit = void (ImportRequest::*)(OptionVisitor&);

VisitOptions defaults_of(Visit visit) {
  return [visit](OptionVisitor& visitor) {
    ImportRequest request;
    (request.*visit)(visitor);
  };
}

StudioServices::ImportedFiles import_files(const std::vector<std::string>& files,
                                           const IniFile& options, Progress& progress) {
  ImportRequest request = read_options<ImportRequest>(options, "import");
  request.files = files;
  ImportedScenarios imported = import_scenarios(request, progress);
  return {std::move(imported.scenarios), std::move(imported.notes), std::move(imported.messages)};
}

void export_to(const Scenario& scenario, const std::string& format, double resolution,
               const std::string& path) {
  MapExportOptions options;
  options.resolution = resolution;
  export_scenario(scenario, format, options, path);
}

}  // namespace

StudioServices make_services() {
  StudioServices services;
  services.load_map = load_occupancy_grid;
  services.import_options = {{"Start and goal on maps", defaults_of(&ImportRequest::visit_pairs)},
                             {"Maps", defaults_of(&ImportRequest::visit_maps)},
                             {"Data sets", defaults_of(&ImportRequest::visit_data_sets)}};
  services.import_files = import_files;
  for (const ExportFormat& format : export_formats())
    services.export_formats.push_back({format.name, format.ending, format.content});
  services.export_scenario = export_to;
  return services;
}

}  // namespace slalom
