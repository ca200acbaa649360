#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <memory>
#include <string>

namespace slalom {

/// What tells one kind of Slalom's SQLite files from others.
struct DatabaseKind {
  const char* name;  ///< for messages: "a scenario list"
  int application_id;
  int version;
  const char* schema;  ///< SQL that makes the tables
  int oldest = 0;      ///< oldest version that opens and is then brought up to date; 0 for none
};

/// A new file of that kind; one that is there is replaced. Throws Error (Job) when it cannot be
/// made.
std::unique_ptr<SQLite::Database> create_database(const std::string& path,
                                                  const DatabaseKind& kind);

/// An existing file. Throws Error (File) when it is missing, of another kind or version, or
/// damaged.
std::unique_ptr<SQLite::Database> open_database(const std::string& path, const DatabaseKind& kind);

/// Runs `act`, turning SQLite's exceptions into Error: File while reading, Job while writing.
template <typename Act>
auto reading(const std::string& path, Act act) -> decltype(act());
template <typename Act>
auto writing(const std::string& path, Act act) -> decltype(act());

[[noreturn]] void throw_read_error(const std::string& path, const std::exception& e);
[[noreturn]] void throw_write_error(const std::string& path, const std::exception& e);

template <typename Act>
auto reading(const std::string& path, Act act) -> decltype(act()) {
  try {
    return act();
  } catch (const SQLite::Exception& e) {
    throw_read_error(path, e);
  }
}

template <typename Act>
auto writing(const std::string& path, Act act) -> decltype(act()) {
  try {
    return act();
  } catch (const SQLite::Exception& e) {
    throw_write_error(path, e);
  }
}

}  // namespace slalom
