// SPDX-License-Identifier: BSD-3-Clause
#include "database.h"
#include "error_text.h"

#include <gtest/gtest.h>

#include <sqlite3.h>

namespace slalom {
namespace {

/// SQLite reports a lock that the file system refuses as one that another program has.
TEST(Database, ALockIsOfAnotherProgramOrOneThatTheFileSystemRefuses) {
  const auto locked = [] { throw SQLite::Exception("database is locked", SQLITE_BUSY); };
  for (const std::string& message :
       {error_text(ErrorKind::Job, [&] { reading("x.results", locked); }),
        error_text(ErrorKind::Job, [&] { writing("x.results", locked); })})
    EXPECT_EQ(message,
              "x.results: is locked by another program, or its file system has no locks (as NFS "
              "without lockd); expected the end of that program, or a local disk");
}

}  // namespace
}  // namespace slalom
