// SPDX-License-Identifier: BSD-3-Clause
#include "slalom_build_id.h"

#include <slalom/core/error.h>
#include <slalom/core/version.h>
#include <slalom/library/library_method.h>
#include <slalom/library/part.h>
#include <slalom/library/shared_library.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>

namespace slalom {
namespace {

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::unique_ptr<SharedLibrary> load_part(const std::string& name, const std::string& where) {
  const std::string path = shipped_folder() + "/runtime/libslalom_" + name + ".so";
  if (!std::filesystem::exists(path)) throw not_built(where, "SLALOM_WITH_" + upper(name));
  std::string reason;
  auto library = load_shared_library(path, reason);
  if (!library)
    throw usage_error(where, path + " cannot be loaded: " + reason, "the libraries it needs");
  const auto build_id = reinterpret_cast<const char* (*)()>(library->find("slalom_build_id"));
  if (build_id == nullptr || std::string(build_id()) != SLALOM_BUILD_ID)
    throw usage_error(where, path + " is of another build of Slalom",
                      "one of the same sources: scripts/build.sh release");
  return library;
}

}  // namespace

void* find_in_part(const std::string& name, const char* symbol, const std::string& where) {
  static std::mutex mutex;
  // Never unloaded: methods, and what they registered at exit, may outlive all owners.
  static auto& loaded = *new std::map<std::string, std::unique_ptr<SharedLibrary>>;
  const std::lock_guard<std::mutex> lock(mutex);
  auto found = loaded.find(name);
  if (found == loaded.end()) found = loaded.emplace(name, load_part(name, where)).first;
  void* function = found->second->find(symbol);
  if (function == nullptr)
    throw usage_error(where, "the part '" + name + "' has no " + symbol,
                      "scripts/build.sh release");
  return function;
}

}  // namespace slalom
