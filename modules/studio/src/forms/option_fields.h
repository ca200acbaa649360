#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/core/options.h>
#include <slalom/studio/form.h>
#include <slalom/studio/services.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// A field for each option, with its default, except for the keys in `without`. Its key is
/// "PREFIX.KEY", or "KEY" without a prefix. A field with an infinite default is empty and optional.
std::vector<FormField> option_fields(const VisitOptions& visit, const std::string& prefix,
                                     const std::vector<std::string>& without = {});

/// Writes the fields whose values differ from the default to [section].
void put_options(IniFile& ini, const std::string& section, const std::string& prefix,
                 const std::vector<FormField>& fields, const FormValues& values);

}  // namespace slalom
