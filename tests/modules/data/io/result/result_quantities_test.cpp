// SPDX-License-Identifier: BSD-3-Clause
#include "checked_row.h"
#include "error_text.h"
#include "io_sample.h"

#include <slalom/io/result_file.h>

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

namespace slalom {
namespace {

class QuantitiesOfAFile : public testing::Test {
 protected:
  const TemporaryFolder folder_;
  const std::string path_ = folder_ / "a.results";

  static QuantityInfo plain(const std::string& id) { return {id, 1, id, "-", Direction::Down}; }

  void execute(const std::string& sql) const {
    SQLite::Database(path_, SQLite::OPEN_READWRITE).exec(sql);
  }

  /// Writes the checksum of the manifest and these columns of the quantities, as another program.
  void repair_checksum(const std::string& columns, int count) const {
    SQLite::Database database(path_, SQLite::OPEN_READWRITE);
    RowChecksum checksum;
    SQLite::Statement manifest(database, "SELECT key, text FROM manifest ORDER BY key");
    while (manifest.executeStep()) checksum.add_columns(manifest, 0, 2);
    SQLite::Statement rows(database, "SELECT " + columns + " FROM quantities ORDER BY position");
    while (rows.executeStep()) checksum.add_columns(rows, 0, count);
    database.exec("UPDATE header SET checksum = " + std::to_string(checksum.value()));
  }
};

TEST_F(QuantitiesOfAFile, HaveTheirKindAndRange) {
  QuantityInfo score = plain("score"), falls = plain("falls"), height = plain("height");
  score.kind = QuantityKind::Ratio;
  score.range = Range::between(-1.0 / 3, 1e20);
  falls.kind = QuantityKind::Count;
  falls.range = Range::at_least(0);
  ResultFile::create(path_, {{"campaign", "test"}}, {height}, {success_info(), score, falls});
  const ResultFile file = ResultFile::open(path_);
  EXPECT_TRUE(file.metrics().at(0).is_rate());
  EXPECT_EQ(file.metrics().at(1).kind, QuantityKind::Ratio);
  EXPECT_EQ(file.metrics().at(1).range.low, -1.0 / 3);
  EXPECT_EQ(file.metrics().at(1).range.high, 1e20);
  EXPECT_EQ(file.metrics().at(2).kind, QuantityKind::Count);
  EXPECT_EQ(range_notation(file.metrics().at(2).range), "0..");
  EXPECT_EQ(file.descriptors().at(0).kind, QuantityKind::Amount);
  EXPECT_EQ(range_notation(file.descriptors().at(0).range), "..");
}

TEST_F(QuantitiesOfAFile, OfVersion3HaveTheKindsAndRangesOfThatTime) {
  ResultFile::create(path_, {{"campaign", "test"}}, {plain("density")},
                     {plain("success"), plain("mover_collision"), plain("optimality"),
                      plain("frozen_time"), plain("of_another_program")});
  execute(
      "ALTER TABLE quantities DROP COLUMN value_kind;"
      "ALTER TABLE quantities DROP COLUMN value_range; PRAGMA user_version = 3");
  repair_checksum("kind, id, version, name, unit, direction", 6);
  const ResultFile file = ResultFile::open(path_);
  const std::vector<QuantityInfo>& metrics = file.metrics();
  EXPECT_EQ(range_notation(file.descriptors().at(0).range), "0..1");
  EXPECT_TRUE(metrics.at(0).is_rate());
  EXPECT_TRUE(metrics.at(1).is_rate());
  EXPECT_EQ(range_notation(metrics.at(2).range), "0..1");
  EXPECT_EQ(metrics.at(2).kind, QuantityKind::Ratio);
  EXPECT_EQ(range_notation(metrics.at(3).range), "0..");
  EXPECT_EQ(metrics.at(4).kind, QuantityKind::Amount);
  EXPECT_EQ(range_notation(metrics.at(4).range), "..");
  EXPECT_EQ(metrics.at(4).direction, Direction::Down);
}

TEST_F(QuantitiesOfAFile, WithAnUnknownKindOrRangeAreRefused) {
  for (const std::string change : {"value_kind = 'colour'", "value_range = '1..0'"}) {
    ResultFile::create(path_, {{"campaign", "test"}}, {}, {success_info()});
    execute("UPDATE quantities SET " + change);
    repair_checksum("kind, id, version, name, unit, direction, value_kind, value_range", 8);
    EXPECT_TRUE(throws_error(ErrorKind::File, path_, {"success is a", "rate, count, amount, ratio"},
                             [&] { ResultFile::open(path_); }))
        << change;
  }
}

TEST_F(QuantitiesOfAFile, ThatWereChangedAreDamaged) {
  ResultFile::create(path_, {{"campaign", "test"}}, {}, {success_info()});
  execute("UPDATE quantities SET value_range = '0..2'");
  EXPECT_TRUE(
      throws_error(ErrorKind::File, path_, {"is damaged"}, [&] { ResultFile::open(path_); }));
}

}  // namespace
}  // namespace slalom
