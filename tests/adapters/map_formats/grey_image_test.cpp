#include "map_files.h"
#include "map_readers.h"

#include <gtest/gtest.h>
#include <mrpt/img/CImage.h>

namespace slalom {
namespace {

using namespace std::string_literals;
using Pixels = std::vector<std::uint8_t>;

std::string pgm_refusal(const std::string& bytes) {
  return error_text(Culprit::File, [&] { parse_pgm(bytes, "a.pgm"); });
}

/// Big-endian, as PNG has it.
std::string four_bytes(std::uint32_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xff);
  return bytes;
}

/// A PNG of the grey values 10 x + 100 y, 3 wide and 2 high.
std::string write_png(const MapFolder& folder) {
  mrpt::img::CImage image(3, 2, mrpt::img::CH_GRAY);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x)
      *image.ptr<std::uint8_t>(x, y) = static_cast<std::uint8_t>(10 * x + 100 * y);
  const std::string path = folder.path("image.png");
  EXPECT_TRUE(image.saveToFile(path));
  return path;
}

TEST(ParsePgm, ReadsTextWithCommentsTopRowFirst) {
  const GreyImage image = parse_pgm("P2 # text\n3 2 # size\n255\n0 1 2\n# row\n253 254 255", "a");
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  EXPECT_EQ(image.pixels, (Pixels{0, 1, 2, 253, 254, 255}));
}

TEST(ParsePgm, ReadsBinaryWithBytesThatLookLikeBlanksAndComments) {
  const GreyImage image = parse_pgm("P5\n#CREATOR: a tool\n2 2\n255\n\n#\0 "s, "a");
  EXPECT_EQ(image.pixels, (Pixels{'\n', '#', 0, ' '}));
}

TEST(ParsePgm, IgnoresWhatFollowsTheImage) {
  EXPECT_EQ(parse_pgm("P5 1 1 255\nAand more", "a").pixels, (Pixels{'A'}));
}

TEST(ParsePgm, StretchesAnotherWhiteTo255) {
  // v * 255 / 15, in whole numbers: 0, 17, 255.
  EXPECT_EQ(parse_pgm("P2 3 1 15 0 1 15", "a").pixels, (Pixels{0, 17, 255}));
  // Beyond white is white: 16 * 255 / 15 = 272.
  EXPECT_EQ(parse_pgm("P5 1 1 15\n\x10", "a").pixels, (Pixels{255}));
}

TEST(ParsePgm, SaysWhereItEndsTooEarly) {
  EXPECT_EQ(pgm_refusal("P5 2 2 255\nabc"),
            "a.pgm: ends too early at byte 10; expected a PGM image (P5 or P2)");
  EXPECT_EQ(pgm_refusal("P5 2 2 255"),
            "a.pgm: ends too early at byte 10; expected a PGM image (P5 or P2)");
  EXPECT_EQ(pgm_refusal("P2 2 2 255 1 2 3 "),
            "a.pgm: has no grey value at byte 17; expected a PGM image (P5 or P2)");
  EXPECT_EQ(pgm_refusal("P5 2"), "a.pgm: has no height at byte 4; expected a PGM image (P5 or P2)");
}

TEST(ParsePgm, RefusesWhatItCannotBe) {
  EXPECT_TRUE(has(pgm_refusal(""), "does not begin with P5 or P2 at byte 0"));
  EXPECT_TRUE(has(pgm_refusal("P6 1 1 255\nabc"), "does not begin with P5 or P2 at byte 0"));
  EXPECT_TRUE(has(pgm_refusal("P5 x 1 255\na"), "has no width at byte 3"));
  EXPECT_TRUE(has(pgm_refusal("P5 -1 1 255\na"), "has no width at byte 3"));
  EXPECT_TRUE(has(pgm_refusal("P5 0 1 255\na"), "has an impossible size"));
  EXPECT_TRUE(has(pgm_refusal("P5 1 1 0\na"), "has an impossible size"));
  EXPECT_TRUE(has(pgm_refusal("P5 1 1 65535\naa"), "has a largest grey value that is too large"));
  EXPECT_TRUE(has(pgm_refusal("P2 1 1 15 16"), "has a grey value that is too large"));
}

TEST(ParsePgm, RefusesHugeSizesBeforeItTakesMemory) {
  EXPECT_TRUE(has(pgm_refusal("P5 1000000 1000000 255\na"), "has an impossible size"));
  EXPECT_TRUE(
      has(pgm_refusal("P5 99999999999999999999 1 255\na"), "has a width that is too large"));
  // 400 million cells are allowed, but a file of 20 bytes does not hold them.
  EXPECT_TRUE(has(pgm_refusal("P5 20000 20000 255\na"), "ends too early"));
  EXPECT_TRUE(has(pgm_refusal("P2 20000 20000 255\n1"), "ends too early"));
}

TEST(ReadGreyImage, ReadsPngTopRowFirst) {
  const MapFolder folder;
  const GreyImage image = read_grey_image(write_png(folder));
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  EXPECT_EQ(image.pixels, (Pixels{0, 10, 20, 100, 110, 120}));
}

TEST(ReadGreyImage, KnowsAPgmByItsContentNotItsName) {
  const MapFolder folder;
  EXPECT_EQ(read_grey_image(folder.write("map.png", "P2 1 1 255 7")).pixels, (Pixels{7}));
}

TEST(ReadGreyImage, RefusesAMissingFileAndAFolder) {
  const MapFolder folder;
  for (const std::string& path : {folder.path("absent.pgm"), folder.path("")})
    EXPECT_EQ(error_text(Culprit::File, [&] { read_grey_image(path); }),
              path + ": cannot be read; expected a map file");
}

TEST(ReadGreyImage, RefusesWhatIsNoImage) {
  const MapFolder folder;
  for (const std::string bytes : {"", "P", "hello"}) {
    const std::string path = folder.write("map.png", bytes);
    EXPECT_EQ(error_text(Culprit::File, [&] { read_grey_image(path); }),
              path + ": is no image that can be read; expected PGM, PNG, JPEG or BMP");
  }
}

TEST(ReadGreyImage, RefusesAPngThatEndsTooEarlyAtAnyByte) {
  const MapFolder folder;
  const std::string whole = bytes_of_file(write_png(folder));
  for (std::size_t size = 0; size + 12 < whole.size(); ++size) {  // 12: the empty last chunk
    const std::string path = folder.write("cut.png", whole.substr(0, size));
    EXPECT_EQ(error_text(Culprit::File, [&] { read_grey_image(path); }),
              path + ": is no image that can be read; expected PGM, PNG, JPEG or BMP")
        << size;
  }
}

TEST(ReadGreyImage, RefusesAPngOfHugeAnnouncedSize) {
  const MapFolder folder;
  std::string bytes = bytes_of_file(write_png(folder));
  // Signature 8, chunk length 4, "IHDR" 4, then width and height.
  bytes.replace(16, 8, four_bytes(100000) + four_bytes(100000));
  const std::string path = folder.write("huge.png", bytes);
  EXPECT_EQ(error_text(Culprit::File, [&] { read_grey_image(path); }),
            path + ": is a PNG of 100000 x 100000 pixels; expected at most 400000000 pixels");
}

}  // namespace
}  // namespace slalom
