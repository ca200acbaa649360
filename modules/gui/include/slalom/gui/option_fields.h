#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/core/options.h>
#include <slalom/gui/form.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// Shows the options of something with their defaults; as visit_generator_options() does.
using VisitOptions = std::function<void(OptionVisitor&)>;

/// A field for each option, filled with its default, its key "PREFIX.KEY" (without a prefix "KEY").
/// A field whose default is infinite is empty and may stay so.
std::vector<FormField> option_fields(const VisitOptions& visit, const std::string& prefix,
                                     const std::vector<std::string>& without = {});

/// Writes those of the fields into [section] that say something else than the default.
void put_options(IniFile& ini, const std::string& section, const std::string& prefix,
                 const std::vector<FormField>& fields, const FormValues& values);

}  // namespace slalom
