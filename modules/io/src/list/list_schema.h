#pragma once

#include "database.h"

#include <string>

namespace slalom {

/// The file format of scenario lists (.scenarios). Version 1 had no origins, tags and indexes; such
/// files are upgraded when opened.
extern const DatabaseKind kScenarioList;

/// Upgrades a list of an older version in one transaction. Throws Error (File) with the version
/// when the file cannot be written.
void upgrade_list(SQLite::Database& database, const std::string& path);

/// Throws Error (File) when the file contains views or triggers, which lists do not have: they
/// could execute code of unknown origin.
void refuse_foreign_schema(SQLite::Database& database, const std::string& path);

}  // namespace slalom
