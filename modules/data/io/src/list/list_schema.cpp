// SPDX-License-Identifier: BSD-3-Clause
#include "list_schema.h"

namespace slalom {

/// `content` is the last column, so that selections do not read it.
const DatabaseKind kScenarioList = {
    "a scenario list (.scenarios)", 0x534c534c /* "SLSL" */, 3,
    "CREATE TABLE scenarios (position INTEGER PRIMARY KEY, hash TEXT NOT NULL UNIQUE,"
    " name TEXT NOT NULL, representation TEXT NOT NULL, generator TEXT, seed INTEGER,"
    " checksum INTEGER NOT NULL, content BLOB NOT NULL);"
    "CREATE TABLE tags (hash TEXT NOT NULL, tag TEXT NOT NULL, PRIMARY KEY (hash, tag))"
    " WITHOUT ROWID;"
    "CREATE INDEX scenarios_by_tag ON tags (tag, hash);"
    "CREATE TABLE descriptor_keys (key INTEGER PRIMARY KEY, id TEXT NOT NULL,"
    " version INTEGER NOT NULL, parameters TEXT NOT NULL, UNIQUE (id, version, parameters));"
    "CREATE TABLE descriptor_values (hash TEXT NOT NULL, key INTEGER NOT NULL, value REAL,"
    " standard_error REAL, reason TEXT, checksum INTEGER NOT NULL, PRIMARY KEY (hash, key))"
    " WITHOUT ROWID;"
    "CREATE TABLE indexes (name TEXT PRIMARY KEY COLLATE NOCASE, descriptor TEXT NOT NULL,"
    " keys TEXT NOT NULL, edges TEXT NOT NULL);"
    "CREATE TABLE notes (key TEXT PRIMARY KEY, text TEXT NOT NULL);"};

}  // namespace slalom
