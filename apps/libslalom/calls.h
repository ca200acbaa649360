// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/ini_file.h>
#include <slalom/slalom.h>

#include <nlohmann/json.hpp>

#include <string>

namespace slalom {

/// Keeps the text for slalom_error().
void set_failure(const std::string& text);

/// Whether the host wants to stop, or slalom_stop() was called, until raise_again().
bool is_interrupted();
void raise_again();

/// Begins a function of the interface.
void begin_call();

/// The result of `action`; `failed`, with the text of the error kept, if it throws.
template <typename Result, typename Action>
Result guarded(Result failed, Action action) {
  Result result = failed;
  try {
    begin_call();
    result = action();
  } catch (const nlohmann::json::exception& error) {
    set_failure(std::string("an argument is not as slalom.h says: ") + error.what());
  } catch (const std::exception& error) {
    set_failure(error.what());
  } catch (...) {
    set_failure("unknown error");
  }
  raise_again();
  return result;
}

/// Takes what a function of the host has given to slalom_reply() in this thread.
std::string take_reply();

/// The text, `what` in messages. Throws Error (Usage) for null.
std::string text_of(const char* text, const std::string& what);

/// A structured text. Throws Error (Usage) for null and for what is no JSON.
nlohmann::json json_of(const char* text, const std::string& what);

/// A copy that slalom_free() frees.
char* to_owned(const std::string& text);

/// Memory for `count` values that slalom_free() frees.
template <typename Value>
Value* owned_array(std::size_t count) {
  auto* memory = static_cast<Value*>(std::malloc(count * sizeof(Value) + 1));
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

/// Settings as sections of an .ini. Throws Error (Usage) for what is no object of objects of texts,
/// and for unknown sections.
IniFile to_ini(const nlohmann::json& settings);

/// Unlocks the host while several threads work.
class Unlocked {
 public:
  Unlocked();
  ~Unlocked();
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;

 private:
  void* unlocked_ = nullptr;
};

/// Enters the host on one of several threads.
class Entered {
 public:
  Entered();
  ~Entered();
  Entered(const Entered&) = delete;
  Entered& operator=(const Entered&) = delete;

 private:
  int entered_ = 0;
};

}  // namespace slalom
