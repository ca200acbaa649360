#pragma once

#include <slalom/gui/made_list.h>
#include <slalom/gui/studio_services.h>

#include <string>
#include <vector>

namespace slalom {

/// What a user asked to be imported.
struct FileImport {
  std::vector<std::string> files;
  IniFile options;   ///< section [import]
  std::string file;  ///< of the new list; empty: they are added to an open one
};

/// Files, what is to become of them, and where they go.
FormDescription import_form(const StudioServices& services, const ListTarget& target,
                            const std::vector<std::string>& files);
/// Throws Error (Usage) when no file is named, one is not there, or the new list is.
FileImport read_import(const StudioServices& services, const FormValues& values);
/// The work itself, for any thread; as generate().
MadeList import_into_list(const StudioServices& services, const FileImport& request,
                          Progress& progress);

/// Format, resolution and file for the scenario that is shown.
FormDescription export_form(const StudioServices& services, const Scenario& scenario,
                            double resolution);
/// Throws Error (Usage) when the file is there and is not to be replaced.
void check_export(const StudioServices& services, const FormValues& values);
void export_as(const StudioServices& services, const Scenario& scenario, const FormValues& values);

}  // namespace slalom
