#include "map_files.h"
#include "map_readers.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

constexpr char kPgm[] = "P2 3 2 255\n254 254 0\n254 205 254\n";

/// Cells' probability of being free, as MRPT rounds it to its own steps.
float kept(double probability) {
  using Map = mrpt::maps::COccupancyGridMap2D;
  return Map::l2p(Map::p2l(static_cast<float>(probability)));
}

mrpt::maps::COccupancyGridMap2D read(const std::string& yaml, const std::string& image = kPgm) {
  const MapFolder folder;
  folder.write("map.pgm", image);
  return read_ros_map(folder.write("map.yaml", yaml));
}

constexpr char kHead[] = "image: map.pgm\nresolution: 0.5\norigin: [-1, 4, 0]\n";

/// The message with the folder's name left out; lines count from 1, kHead has three.
std::string refusal(const std::string& yaml, const std::string& image = kPgm) {
  const MapFolder folder;
  folder.write("map.pgm", image);
  const std::string path = folder.write("map.yaml", yaml);
  std::string text = error_text(Culprit::File, [&] { read_ros_map(path); });
  const std::string prefix = folder.path("");
  for (std::size_t at; (at = text.find(prefix)) != std::string::npos;)
    text.erase(at, prefix.size());
  return text;
}

/// One row of pixels under further keys.
std::vector<float> row_of(const std::string& keys, const std::string& pixels, int count) {
  const auto map = read(kHead + keys, "P2 " + std::to_string(count) + " 1 255 " + pixels);
  std::vector<float> cells;
  for (int x = 0; x < count; ++x) cells.push_back(map.getCell(x, 0));
  return cells;
}

TEST(RosMap, PutsEachPixelAtItsPlaceInTheWorld) {
  const auto map = read(kHead);
  EXPECT_EQ(map.getSizeX(), 3U);
  EXPECT_EQ(map.getSizeY(), 2U);
  EXPECT_FLOAT_EQ(map.getResolution(), 0.5F);
  EXPECT_FLOAT_EQ(map.getXMin(), -1);
  EXPECT_FLOAT_EQ(map.getXMax(), 0.5);
  EXPECT_FLOAT_EQ(map.getYMin(), 4);
  EXPECT_FLOAT_EQ(map.getYMax(), 5);
  // The origin is the lower left corner, the image's first row is the upper one: the black pixel,
  // last of the first row, has its centre at (-1 + 2.5 * 0.5, 4 + 1.5 * 0.5).
  EXPECT_EQ(map.getPos(0.25F, 4.75F), kept(0));
  // The grey one, second of the last row: (-1 + 1.5 * 0.5, 4 + 0.5 * 0.5).
  EXPECT_EQ(map.getPos(-0.25F, 4.25F), kept(0.5));
  EXPECT_EQ(map.getPos(-0.75F, 4.25F), kept(1));
  EXPECT_EQ(map.getPos(0.25F, 4.25F), kept(1));
}

TEST(RosMap, KeepsAnOriginThatIsNoMultipleOfTheResolution) {
  const auto map = read("image: map.pgm\nresolution: 0.05\norigin: [-12.013, 3.021, 0.0]\n");
  EXPECT_FLOAT_EQ(map.getXMin(), -12.013F);
  EXPECT_FLOAT_EQ(map.getYMin(), 3.021F);
  EXPECT_EQ(map.getSizeX(), 3U);
}

TEST(RosMap, PartsCellsByTheThresholds) {
  // Occupied share (255 - pixel) / 255: 0.647 and 0.651 about 0.65; 0.196078 and 0.192 about 0.196.
  EXPECT_EQ(row_of("", "90 89 205 206", 4),
            (std::vector<float>{kept(0.5), kept(0), kept(0.5), kept(1)}));
  EXPECT_EQ(row_of("occupied_thresh: 0.9\nfree_thresh: 0.1\n", "25 26 229 230", 4),
            (std::vector<float>{kept(0), kept(0.5), kept(0.5), kept(1)}));
}

TEST(RosMap, NegateTurnsBlackAndWhiteRound) {
  EXPECT_EQ(row_of("negate: 1\n", "0 255 128", 3),
            (std::vector<float>{kept(1), kept(0), kept(0.5)}));
  EXPECT_EQ(row_of("negate: 0\n", "0 255 128", 3),
            (std::vector<float>{kept(0), kept(1), kept(0.5)}));
}

TEST(RosMap, ScaleKeepsShadesBetweenTheThresholds) {
  // Occupied shares 0.2, 0.4, 0.6 of 255 between 0 and 1: free 1 - share.
  EXPECT_EQ(row_of("mode: scale\noccupied_thresh: 1\nfree_thresh: 0\n", "204 153 102", 3),
            (std::vector<float>{kept(0.8), kept(0.6), kept(0.4)}));
}

TEST(RosMap, RawReadsPercentAndBeyondIsUnknown) {
  EXPECT_EQ(row_of("mode: raw\n", "0 30 100 101 255", 5),
            (std::vector<float>{kept(1), kept(0.7), kept(0), kept(0.5), kept(0.5)}));
}

TEST(RosMap, FindsItsImageBesideItselfOrByAbsolutePath) {
  const MapFolder folder, other;
  const std::string image = other.write("map.pgm", kPgm);
  const std::string yaml =
      folder.write("map.yaml", "image: " + image + "\nresolution: 0.5\norigin: [0, 0]\n");
  EXPECT_EQ(read_ros_map(yaml).getSizeX(), 3U);
}

TEST(RosMap, NamesTheKeyThatIsMissing) {
  EXPECT_EQ(refusal("resolution: 0.5\norigin: [0, 0, 0]\n"),
            "map.yaml:1: key 'image' is missing; expected a ROS map_server YAML");
  EXPECT_EQ(refusal("image: map.pgm\norigin: [0, 0, 0]\n"),
            "map.yaml:1: key 'resolution' is missing; expected a ROS map_server YAML");
  EXPECT_EQ(refusal("image: map.pgm\nresolution: 0.5\n"),
            "map.yaml:1: key 'origin' is missing; expected a ROS map_server YAML");
}

TEST(RosMap, NamesTheKeyOfTheWrongKind) {
  EXPECT_EQ(refusal("image: [a, b]\nresolution: 0.5\norigin: [0, 0, 0]\n"),
            "map.yaml:1: image is of the wrong kind; expected a text");
  EXPECT_EQ(refusal("image: map.pgm\nresolution: fine\norigin: [0, 0, 0]\n"),
            "map.yaml:2: resolution is not a finite number; expected a number");
  EXPECT_EQ(refusal("image: map.pgm\nresolution: {a: 1}\norigin: [0, 0, 0]\n"),
            "map.yaml:2: resolution is not a finite number; expected a number");
  EXPECT_EQ(refusal("image: map.pgm\nresolution: 0.5\norigin: [0, .nan, 0]\n"),
            "map.yaml:3: origin is not a finite number; expected a number");
  EXPECT_EQ(refusal(std::string(kHead) + "negate: maybe\n"),
            "map.yaml:4: negate is not a finite number; expected a number");
  EXPECT_EQ(refusal(std::string(kHead) + "mode: {}\n"),
            "map.yaml:4: mode is of the wrong kind; expected a text");
}

TEST(RosMap, RefusesImpossibleValues) {
  for (const std::string resolution : {"0", "-0.5", "1e-60", "1e60"})
    EXPECT_EQ(
        refusal("image: map.pgm\nresolution: " + resolution + "\norigin: [0, 0, 0]\n"),
        "map.yaml:2: resolution " + resolution + " is no size of a cell; expected metres, > 0");
  for (const std::string origin : {"[0]", "[0, 0, 0, 0]", "7"})
    EXPECT_EQ(refusal("image: map.pgm\nresolution: 0.5\norigin: " + origin + "\n"),
              "map.yaml:3: origin has not the right form; expected [x, y, yaw]");
  EXPECT_EQ(refusal("image: map.pgm\nresolution: 0.5\norigin: [1e60, 0, 0]\n"),
            "map.yaml:3: origin is too far away; expected [x, y, yaw] in metres");
  EXPECT_EQ(refusal(std::string(kHead) + "mode: trinity\n"),
            "map.yaml:4: mode 'trinity' is unknown; expected trinary, scale or raw");
  EXPECT_EQ(refusal(std::string(kHead) + "free_thresh: 0.7\n"),
            "map.yaml:1: free_thresh is above occupied_thresh; expected free_thresh <= "
            "occupied_thresh");
}

TEST(RosMap, RefusesWhatIsNoYaml) {
  EXPECT_TRUE(has(refusal("image: [map.pgm\n"), "map.yaml:2: is not YAML ("));
  EXPECT_EQ(refusal("just words\n"), "map.yaml:1: is no map; expected keys and values");
  EXPECT_EQ(refusal(""), "map.yaml: is no map; expected keys and values");
}

TEST(RosMap, NamesAMissingOrBrokenImage) {
  EXPECT_EQ(refusal("image: other.pgm\nresolution: 0.5\norigin: [0, 0, 0]\n"),
            "other.pgm: cannot be read; expected a map file");
  EXPECT_EQ(refusal(kHead, "P5 3 2 255\nabcde"),
            "map.pgm: ends too early at byte 10; expected a PGM image (P5 or P2)");
}

TEST(RosMap, RefusesAMissingFile) {
  EXPECT_EQ(error_text(Culprit::File, [] { read_ros_map("/nowhere/map.yaml"); }),
            "/nowhere/map.yaml: cannot be read; expected a map file");
}

}  // namespace
}  // namespace slalom
