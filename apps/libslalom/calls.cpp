// SPDX-License-Identifier: BSD-3-Clause
#include "calls.h"

#include <slalom/app/program.h>
#include <slalom/core/error.h>
#include <slalom/core/fork.h>
#include <slalom/core/version.h>
#include <slalom/library/library_method.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <filesystem>
#include <iterator>
#include <utility>

namespace slalom {
namespace {

thread_local std::string failure, reply;
slalom_host host = {};

/// An exception of the host in this thread.
thread_local bool interrupted = false;
thread_local void* raised[3] = {};

void call_if_locked(void (*function)()) {
  if (function != nullptr && (host.holds_lock == nullptr || host.holds_lock() != 0)) function();
}

}  // namespace

void set_failure(const std::string& text) {
  failure = text;
}

void begin_call() {
  interrupted = false;
  static const bool methods_are_beside_this_library = [] {
    Dl_info here;
    if (dladdr(reinterpret_cast<const void*>(&slalom_error), &here) == 0) return false;
    const auto folder = std::filesystem::absolute(here.dli_fname).parent_path().parent_path();
    set_shipped_folder(folder.string());
    return true;
  }();
  static_cast<void>(methods_are_beside_this_library);
}

std::string take_reply() {
  return std::exchange(reply, "");
}

std::string text_of(const char* text, const std::string& what) {
  if (text == nullptr) throw usage_error(what, "is a null pointer", "a text");
  return text;
}

nlohmann::json json_of(const char* text, const std::string& what) {
  const nlohmann::json json = nlohmann::json::parse(text_of(text, what), nullptr, false);
  if (json.is_discarded()) throw usage_error(what, "is not JSON", "see slalom.h");
  return json;
}

char* to_owned(const std::string& text) {
  char* copy = owned_array<char>(text.size());
  std::memcpy(copy, text.c_str(), text.size() + 1);
  return copy;
}

IniFile to_ini(const nlohmann::json& settings) {
  if (!settings.is_object()) throw usage_error("settings", "are no object", "{SECTION: {...}}");
  IniFile ini = IniFile::from_text("", "arguments");
  for (const auto& [section, keys] : settings.items()) {
    if (!keys.is_object()) throw usage_error(section, "is no section", "{KEY: TEXT, ...}");
    for (const auto& [key, value] : keys.items()) {
      if (!value.is_string()) throw usage_error(section + " " + key, "is no text", "\"VALUE\"");
      ini.set(section, key, value, "");
    }
  }
  ini.reject_unknown_sections(campaign_sections());
  return ini;
}

bool is_interrupted() {
  if (interrupted || host.interrupted == nullptr || host.interrupted() == 0) return interrupted;
  interrupted = true;
  if (host.put_aside != nullptr) host.put_aside(&raised[0], &raised[1], &raised[2]);
  return true;
}

void raise_again() {
  if (raised[0] != nullptr && host.raise_again != nullptr)
    host.raise_again(raised[0], raised[1], raised[2]);
  std::fill(std::begin(raised), std::end(raised), nullptr);
  interrupted = false;
}

Unlocked::Unlocked() {
  if (host.unlock != nullptr) unlocked_ = host.unlock();
}

Unlocked::~Unlocked() {
  if (host.lock != nullptr) host.lock(unlocked_);
}

Entered::Entered() {
  if (host.enter != nullptr) entered_ = host.enter();
}

Entered::~Entered() {
  if (host.leave != nullptr) host.leave(entered_);
}

}  // namespace slalom

uint32_t slalom_library_abi_version() {
  return SLALOM_LIBRARY_ABI_VERSION;
}

const char* slalom_version() {
  static const std::string text = slalom::version();
  return text.c_str();
}

const char* slalom_error() {
  return slalom::failure.c_str();
}

void slalom_reply(const char* text) {
  slalom::reply = text == nullptr ? "" : text;
}

void slalom_free(void* memory) {
  std::free(memory);
}

void slalom_stop() {
  slalom::interrupted = true;
}

void slalom_set_host(const slalom_host* host) {
  using namespace slalom;
  slalom::host = host == nullptr ? slalom_host{} : *host;
  set_fork_hooks({[] { call_if_locked(slalom::host.before_fork); },
                  [] { call_if_locked(slalom::host.after_fork_in_parent); },
                  [] { call_if_locked(slalom::host.after_fork_in_child); }});
}
