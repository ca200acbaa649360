#pragma once

#include "database.h"

#include <string>

namespace slalom {

/// The file format of scenario lists (.scenarios). The row of a scenario contains the checksum of
/// its hash, name, representation, generator, seed and tags; that of a value the checksum of the
/// hash, the id, version and parameters of the descriptor, and the value.
extern const DatabaseKind kScenarioList;

/// Throws Error (File) when the file contains views or triggers, which lists do not have: they
/// could execute code of unknown origin.
void refuse_foreign_schema(SQLite::Database& database, const std::string& path);

}  // namespace slalom
