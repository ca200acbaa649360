// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

namespace SQLite {
class Database;
}

namespace slalom {

/// Opens an SQLite file of another program for reading, with the precautions against files of
/// strangers that Slalom's own have: nothing that the file stores is executed. Makes no file beside
/// it, so that it may be in a folder that cannot be written. `kind` is what was expected, for
/// messages: "a bag". Throws Error (File).
std::unique_ptr<SQLite::Database> open_foreign_database(const std::string& path,
                                                        const std::string& kind);

}  // namespace slalom
