// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/fork.h>
#include <slalom/core/options.h>
#include <slalom/methods/method_factory.h>

#include <optional>
#include <string>

namespace slalom {

/// An adapter of methods, as programs know it.
struct MethodAdapter {
  const char* name;
  /// Reads the options of a method from a section of an .ini. Throws Error (Usage) for an invalid
  /// or unknown key.
  MethodFactory (*read)(const IniFile& ini, const std::string& section);
  void (*visit_options)(OptionVisitor& visitor);
  /// The value of an option of the method's own configuration, named SECTION.KEY or NODE.NAME, and
  /// the key of the .ini that overrides such options; null if it has none.
  std::optional<std::string> (*configuration_value)(const IniFile& ini, const std::string& section,
                                                    const std::string& option) = nullptr;
  const char* overrides_key = nullptr;
};

/// For MethodAdapter::visit_options.
template <typename Options>
void visit_options_of(OptionVisitor& visitor) {
  Options().visit(visitor);
}

/// The function `slalom_method_adapter` of an adapter that is a part loaded at run time. The part
/// sets its fork hooks in those of the program, which forks.
using GetMethodAdapter = const MethodAdapter*(ForkHooks& hooks);

}  // namespace slalom
