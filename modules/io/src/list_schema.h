#pragma once

#include "database.h"

#include <string>

namespace slalom {

/// What a scenario list (.scenarios) looks like on disk. Version 1 had neither origins nor tags nor
/// indexes; it is brought up to date when it is opened.
extern const DatabaseKind kScenarioList;

/// Brings a list of an older version up to date, in one transaction. Throws Error (File) naming the
/// version when the file cannot be written.
void upgrade_list(SQLite::Database& database, const std::string& path);

/// Throws Error (File) when the file holds views or triggers: a list has none, and such would run
/// whoever made them.
void refuse_foreign_schema(SQLite::Database& database, const std::string& path);

}  // namespace slalom
