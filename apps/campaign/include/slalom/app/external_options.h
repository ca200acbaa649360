// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>

#include <map>
#include <string>
#include <vector>

namespace slalom {

/// An option of a method that names something outside of the .ini.
struct ExternalOption {
  std::string section, key, value;
  External use;
};

/// Returns the external options of the sections (see method_sections()) that are not empty.
std::vector<ExternalOption> external_options(const IniFile& ini,
                                             const std::vector<std::string>& sections);

/// Whether the key of the section names a file, a folder or an address: what matters for results is
/// its content, not its name.
bool is_location(const IniFile& ini, const std::string& section, const std::string& key);

/// The files of methods whose contents may change results: paths by "method.NAME.plugin". Throws
/// Error (Usage) for one that does not exist.
std::map<std::string, std::string> files_of_methods(const IniFile& ini,
                                                    const std::vector<std::string>& sections);

/// For an .ini that a data file contains, such as a result file or a recorded run: throws Error
/// (Usage), naming what it is, if the methods would execute, load or write anything that is not
/// shipped with Slalom. Options that the user has overridden are not those of the file. `file` is
/// named in the message, `expected` the ways out; no sections: those of all methods.
void require_no_foreign_code(
    const IniFile& ini, std::vector<std::string> sections, const std::string& file,
    const std::string& expected = "-c with an .ini of your own, or --trust if you trust the file");

}  // namespace slalom
