#pragma once

#include "forms/made_list.h"

#include <slalom/studio/services.h>

#include <string>
#include <vector>

namespace slalom {

/// An import requested by the user.
struct FileImport {
  std::vector<std::string> files;
  IniFile options;   ///< section [import]
  std::string file;  ///< of the new list; empty: append to an open list
};

/// Form for the files, the import options and the target list.
FormDescription import_form(const StudioServices& services, const ListTarget& target,
                            const std::vector<std::string>& files);
/// Throws Error (Usage) when no file is given, a file does not exist, or the new list does.
FileImport read_import(const StudioServices& services, const FormValues& values);
/// Imports the files; may run in any thread. Cancels like generate().
MadeList import_into_list(const StudioServices& services, const FileImport& request,
                          Progress& progress);

/// Form for format, resolution and file of an exported scenario.
FormDescription export_form(const StudioServices& services, const Scenario& scenario,
                            double resolution);
/// Throws Error (Usage) when the file exists and Replace is not set.
void check_export(const StudioServices& services, const FormValues& values);
void export_as(const StudioServices& services, const Scenario& scenario, const FormValues& values);

}  // namespace slalom
