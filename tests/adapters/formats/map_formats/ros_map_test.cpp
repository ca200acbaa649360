// SPDX-License-Identifier: BSD-3-Clause
#include "map_files.h"
#include "map_readers.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

constexpr char kPgm[] = "P2 3 2 255\n254 254 0\n254 205 254\n";

/// The probability of being free as rounded by MRPT.
float rounded(double probability) {
  using Grid = mrpt::maps::COccupancyGridMap2D;
  return Grid::l2p(Grid::p2l(static_cast<float>(probability)));
}

mrpt::maps::COccupancyGridMap2D read(const std::string& yaml, const std::string& image = kPgm) {
  const MapFolder folder;
  folder.write("map.pgm", image);
  return read_ros_map(folder.write("map.yaml", yaml));
}

constexpr char kHeader[] = "image: map.pgm\nresolution: 0.5\norigin: [-1, 4, 0]\n";

/// Whether reading the map fails at `where` ("map.yaml:3", lines from 1; kHeader has three) with a
/// message that mentions `words`.
testing::AssertionResult rejects(const std::string& yaml, const std::string& where,
                                 std::initializer_list<std::string> words,
                                 const std::string& image = kPgm) {
  const MapFolder folder;
  folder.write("map.pgm", image);
  const std::string path = folder.write("map.yaml", yaml);
  return throws_error(ErrorKind::File, folder.path(where) + ": ", words,
                      [&] { read_ros_map(path); });
}

/// The cells of an image of one row, with additional keys.
std::vector<float> row_of(const std::string& keys, const std::string& pixels, int count) {
  const auto map = read(kHeader + keys, "P2 " + std::to_string(count) + " 1 255 " + pixels);
  std::vector<float> cells;
  for (int x = 0; x < count; ++x) cells.push_back(map.getCell(x, 0));
  return cells;
}

TEST(RosMap, PlacesPixelsInTheWorld) {
  const auto map = read(kHeader);
  EXPECT_EQ(map.getSizeX(), 3U);
  EXPECT_EQ(map.getSizeY(), 2U);
  EXPECT_FLOAT_EQ(map.getResolution(), 0.5F);
  EXPECT_FLOAT_EQ(map.getXMin(), -1);
  EXPECT_FLOAT_EQ(map.getXMax(), 0.5);
  EXPECT_FLOAT_EQ(map.getYMin(), 4);
  EXPECT_FLOAT_EQ(map.getYMax(), 5);
  // The origin is the lower left corner, the image's first row is the upper one: the black pixel,
  // last of the first row, has its center at (-1 + 2.5 * 0.5, 4 + 1.5 * 0.5).
  EXPECT_EQ(map.getPos(0.25F, 4.75F), rounded(0));
  // The gray one, second of the last row: (-1 + 1.5 * 0.5, 4 + 0.5 * 0.5).
  EXPECT_EQ(map.getPos(-0.25F, 4.25F), rounded(0.5));
  EXPECT_EQ(map.getPos(-0.75F, 4.25F), rounded(1));
  EXPECT_EQ(map.getPos(0.25F, 4.25F), rounded(1));
}

TEST(RosMap, KeepsAnOriginThatIsNotAMultipleOfTheResolution) {
  const auto map = read("image: map.pgm\nresolution: 0.05\norigin: [-12.013, 3.021, 0.0]\n");
  EXPECT_FLOAT_EQ(map.getXMin(), -12.013F);
  EXPECT_FLOAT_EQ(map.getYMin(), 3.021F);
  EXPECT_EQ(map.getSizeX(), 3U);
}

TEST(RosMap, AppliesTheThresholds) {
  // Occupancy (255 - pixel) / 255: 0.647 and 0.651 around 0.65; 0.196078 and 0.192 around 0.196.
  EXPECT_EQ(row_of("", "90 89 205 206", 4),
            (std::vector<float>{rounded(0.5), rounded(0), rounded(0.5), rounded(1)}));
  EXPECT_EQ(row_of("occupied_thresh: 0.9\nfree_thresh: 0.1\n", "25 26 229 230", 4),
            (std::vector<float>{rounded(0), rounded(0.5), rounded(0.5), rounded(1)}));
}

TEST(RosMap, AShadeAtAThresholdIsOccupiedOrFree) {
  // A map of pure black and white with the widest thresholds.
  EXPECT_EQ(row_of("occupied_thresh: 1.0\nfree_thresh: 0.0\n", "0 127 255", 3),
            (std::vector<float>{rounded(0), rounded(0.5), rounded(1)}));
  // Occupancies 0.6, 0.4 and 0.2 are those of 102, 153 and 204 of 255.
  EXPECT_EQ(row_of("occupied_thresh: 0.6\nfree_thresh: 0.4\n", "102 103 152 153", 4),
            (std::vector<float>{rounded(0), rounded(0.5), rounded(0.5), rounded(1)}));
  EXPECT_EQ(row_of("occupied_thresh: 0.9\nfree_thresh: 0.2\n", "203 204", 2),
            (std::vector<float>{rounded(0.5), rounded(1)}));
  // Free at both thresholds.
  EXPECT_EQ(row_of("occupied_thresh: 0.6\nfree_thresh: 0.6\n", "101 102 103", 3),
            (std::vector<float>{rounded(0), rounded(1), rounded(1)}));
}

TEST(RosMap, TheModeMayBeInCapitals) {
  const std::string thresholds = "occupied_thresh: 1\nfree_thresh: 0\n";
  for (const std::string mode : {"trinary", "Trinary", "TRINARY"})
    EXPECT_EQ(row_of("mode: " + mode + "\n" + thresholds, "204", 1),
              std::vector<float>{rounded(0.5)});
  for (const std::string mode : {"Scale", "SCALE", "sCALE"})
    EXPECT_EQ(row_of("mode: " + mode + "\n" + thresholds, "204", 1),
              std::vector<float>{rounded(0.8)});
  EXPECT_EQ(row_of("mode: Raw\n", "30", 1), std::vector<float>{rounded(0.7)});
}

TEST(RosMap, TransparentPixelsAreUnknown) {
  // White, white, black and gray; the second to the last ones are not opaque.
  const std::string image =
      png(4, 1, 8, kGrayAlpha, std::string("\xff\xff\xff\xfe\x00\x00\x7f\x00", 8));
  const auto cells = [&image](const std::string& mode) {
    const auto map = read(kHeader + ("mode: " + mode + "\n"), image);
    return std::vector<float>{map.getCell(0, 0), map.getCell(1, 0), map.getCell(2, 0),
                              map.getCell(3, 0)};
  };
  const float unknown = rounded(0.5);
  const std::vector<float> expected{rounded(1), unknown, unknown, unknown};
  EXPECT_EQ(cells("trinary"), expected);
  EXPECT_EQ(cells("scale"), expected);
  EXPECT_EQ(cells("raw"), (std::vector<float>{unknown, unknown, rounded(1), unknown}))
      << "alpha is ignored";
}

TEST(RosMap, NegateInvertsThePixels) {
  EXPECT_EQ(row_of("negate: 1\n", "0 255 128", 3),
            (std::vector<float>{rounded(1), rounded(0), rounded(0.5)}));
  EXPECT_EQ(row_of("negate: 0\n", "0 255 128", 3),
            (std::vector<float>{rounded(0), rounded(1), rounded(0.5)}));
}

TEST(RosMap, NegateIsABooleanOrAnInteger) {
  for (const std::string value : {"1", "2", "true", "True", "yes", "on"})
    EXPECT_EQ(row_of("negate: " + value + "\n", "0 255", 2),
              (std::vector<float>{rounded(1), rounded(0)}))
        << value;
  for (const std::string value : {"0", "false", "False", "no", "off"})
    EXPECT_EQ(row_of("negate: " + value + "\n", "0 255", 2),
              (std::vector<float>{rounded(0), rounded(1)}))
        << value;
}

TEST(RosMap, ComparesShadesOf16BitImagesUnrounded) {
  // Occupied from 0.65 on: 1 - p / 65535 > 0.65 for p < 22937.25. 22937 is shade 89.25 of 255.
  const auto cells = [](const std::string& bytes) {
    const auto map = read(kHeader, "P5 3 1 65535\n" + bytes);
    return std::vector<float>{map.getCell(0, 0), map.getCell(1, 0), map.getCell(2, 0)};
  };
  const auto two_bytes = [](int p) {
    return std::string{static_cast<char>(p >> 8), static_cast<char>(p & 0xff)};
  };
  EXPECT_EQ(cells(two_bytes(22937) + two_bytes(22938) + two_bytes(65535)),
            (std::vector<float>{rounded(0), rounded(0.5), rounded(1)}));
}

TEST(RosMap, ScaleInterpolatesBetweenTheThresholds) {
  // Occupancies 0.2, 0.4, 0.6: free 1 - occupancy.
  EXPECT_EQ(row_of("mode: scale\noccupied_thresh: 1\nfree_thresh: 0\n", "204 153 102", 3),
            (std::vector<float>{rounded(0.8), rounded(0.6), rounded(0.4)}));
}

TEST(RosMap, RawReadsPercentAndLargerValuesAreUnknown) {
  EXPECT_EQ(row_of("mode: raw\n", "0 30 100 101 255", 5),
            (std::vector<float>{rounded(1), rounded(0.7), rounded(0), rounded(0.5), rounded(0.5)}));
}

TEST(RosMap, FindsItsImageByRelativeOrAbsolutePath) {
  const MapFolder folder, other;
  const std::string image = other.write("map.pgm", kPgm);
  const std::string yaml =
      folder.write("map.yaml", "image: " + image + "\nresolution: 0.5\norigin: [0, 0]\n");
  EXPECT_EQ(read_ros_map(yaml).getSizeX(), 3U);
}

std::vector<std::string> notes_of(const std::string& yaml, const std::string& image = kPgm) {
  const MapFolder folder;
  folder.write("map.pgm", image);
  std::vector<std::string> notes;
  EXPECT_GE(read_ros_map(folder.write("map.yaml", yaml), &notes).getSizeX(), 3U);
  return notes;
}

TEST(RosMap, AnImageThatIsNotWhereItSaysIsReadBesideTheMap) {
  for (const std::string stated :
       {"/home/other/maps/map.pgm", "file:///home/other/map.pgm", "package://robot/maps/map.pgm",
        "~/missing/map.pgm", "maps/map.pgm"}) {
    const auto notes = notes_of("image: " + stated + "\nresolution: 0.5\norigin: [0, 0, 0]\n");
    ASSERT_EQ(notes.size(), 1U) << stated;
    EXPECT_EQ(notes[0], "image '" + stated + "' is missing; 'map.pgm' beside the map is read");
  }
  EXPECT_TRUE(notes_of(kHeader).empty());
}

TEST(RosMap, AnImageIsFoundByAFileAddress) {
  const MapFolder folder, other;
  const std::string image = other.write("map.pgm", kPgm);
  std::vector<std::string> notes;
  read_ros_map(
      folder.write("map.yaml", "image: file://" + image + "\nresolution: 0.5\norigin: [0, 0]\n"),
      &notes);
  EXPECT_TRUE(notes.empty());
}

TEST(RosMap, AYawInDegreesIsSuspected) {
  const std::string head = "image: map.pgm\nresolution: 0.5\norigin: ";
  const auto notes = notes_of(head + "[0, 0, 6.29]\n");
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0], "a yaw of 6.29 rad: degrees?");
}

TEST(RosMap, UnknownCellsOfMapSaverThatAreFreeAreCounted) {
  // 205 is occupied by 50/255 = 0.196.
  EXPECT_TRUE(notes_of(std::string(kHeader) + "free_thresh: 0.196\n").empty());
  const auto notes = notes_of(std::string(kHeader) + "free_thresh: 0.25\n");
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_TRUE(mentions(notes[0], {"1 cell of gray 205", "is free with free_thresh 0.25"}));
  EXPECT_TRUE(notes_of(std::string(kHeader) + "mode: raw\nfree_thresh: 0.25\n").empty());
}

TEST(RosMap, ReportsMissingKeys) {
  EXPECT_TRUE(
      rejects("resolution: 0.5\norigin: [0, 0, 0]\n", "map.yaml:1", {"missing key 'image'"}));
  EXPECT_TRUE(
      rejects("image: map.pgm\norigin: [0, 0, 0]\n", "map.yaml:1", {"missing key 'resolution'"}));
  EXPECT_TRUE(rejects("image: map.pgm\nresolution: 0.5\n", "map.yaml:1", {"missing key 'origin'"}));
}

TEST(RosMap, ReportsKeysOfTheWrongType) {
  EXPECT_TRUE(rejects("image: [a, b]\nresolution: 0.5\norigin: [0, 0, 0]\n", "map.yaml:1",
                      {"invalid image", "text"}));
  EXPECT_TRUE(rejects("image: map.pgm\nresolution: fine\norigin: [0, 0, 0]\n", "map.yaml:2",
                      {"invalid resolution", "a finite number"}));
  EXPECT_TRUE(rejects("image: map.pgm\nresolution: {a: 1}\norigin: [0, 0, 0]\n", "map.yaml:2",
                      {"invalid resolution", "a finite number"}));
  EXPECT_TRUE(rejects("image: map.pgm\nresolution: 0.5\norigin: [0, .nan, 0]\n", "map.yaml:3",
                      {"invalid origin", "a finite number"}));
  EXPECT_TRUE(rejects(std::string(kHeader) + "negate: maybe\n", "map.yaml:4",
                      {"invalid negate", "true or false"}));
  EXPECT_TRUE(rejects(std::string(kHeader) + "mode: {}\n", "map.yaml:4", {"invalid mode", "text"}));
}

TEST(RosMap, RejectsInvalidValues) {
  for (const std::string resolution : {"0", "-0.5", "1e-60", "1e60"})
    EXPECT_TRUE(rejects("image: map.pgm\nresolution: " + resolution + "\norigin: [0, 0, 0]\n",
                        "map.yaml:2", {"resolution " + resolution, "meters, > 0"}));
  for (const std::string origin : {"[0]", "[0, 0, 0, 0]", "7"})
    EXPECT_TRUE(rejects("image: map.pgm\nresolution: 0.5\norigin: " + origin + "\n", "map.yaml:3",
                        {"malformed origin", "[x, y, yaw]"}));
  EXPECT_TRUE(rejects("image: map.pgm\nresolution: 0.5\norigin: [1e60, 0, 0]\n", "map.yaml:3",
                      {"origin out of range", "meters"}));
  EXPECT_TRUE(rejects(std::string(kHeader) + "mode: trinity\n", "map.yaml:4",
                      {"mode 'trinity'", "trinary, scale or raw"}));
  EXPECT_TRUE(rejects(std::string(kHeader) + "free_thresh: 0.7\n", "map.yaml:1",
                      {"free_thresh <= occupied_thresh"}));
}

TEST(RosMap, RejectsInvalidYaml) {
  EXPECT_TRUE(rejects("image: [map.pgm\n", "map.yaml:2", {"is not YAML ("}));
  EXPECT_TRUE(rejects("just words\n", "map.yaml:1", {"keys and values"}));
  EXPECT_TRUE(rejects("", "map.yaml", {"keys and values"}));
}

TEST(RosMap, ReportsAMissingOrCorruptImage) {
  EXPECT_TRUE(rejects("image: other.pgm\nresolution: 0.5\norigin: [0, 0, 0]\n", "other.pgm",
                      {"cannot be read"}));
  EXPECT_TRUE(rejects(kHeader, "map.pgm", {"truncated", "at byte 10"}, "P5 3 2 255\nabcde"));
}

TEST(RosMap, RejectsAMissingFile) {
  EXPECT_TRUE(throws_error(ErrorKind::File, "/nowhere/map.yaml: ", {"cannot be read"},
                           [] { read_ros_map("/nowhere/map.yaml"); }));
}

}  // namespace
}  // namespace slalom
