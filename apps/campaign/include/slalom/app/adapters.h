// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/methods/adapter.h>
#include <slalom/methods/registry.h>

#include <functional>

namespace slalom {

/// All adapters, by name.
MethodRegistry all_adapters();

/// The adapter of that name, null if there is none. Throws Error (Usage) at `where` if it is a part
/// that was not built.
const MethodAdapter* find_adapter(const std::string& name, const std::string& where);

/// Calls `visit` for each adapter that was built with the function that visits its keys in
/// [method.NAME].
void visit_adapter_options(
    const std::function<void(const std::function<void(OptionVisitor&)>& visit_options)>& visit);

/// Whether the methods of this adapter are in other processes, which they reach over a network.
bool uses_network(const std::string& adapter);

/// The thing outside of the .ini that a key of a method's section names, as its adapter declares.
External external_use(const IniFile& ini, const std::string& section, const std::string& key);

}  // namespace slalom
