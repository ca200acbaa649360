// SPDX-License-Identifier: BSD-3-Clause
#include "map_readers.h"
#include "rotated_grid.h"
#include "stage_world.h"
#include "world_parts.h"

#include <slalom/core/error.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/scenario/grid_map.h>

#include <mrpt/core/bits_math.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>

namespace slalom {
namespace {

namespace fs = std::filesystem;
using mrpt::maps::COccupancyGridMap2D;
using mrpt::math::TPoint2D;

constexpr int kMaxNesting = 12;  // of entities, files and definitions
constexpr std::size_t kMaxFiles = 100, kMaxEntities = 200'000;
constexpr double kBoundaryWidth = 0.01;  // m, as in Stage

struct StageToken {
  enum class Kind { Word, Text, Mark, End } kind = Kind::End;
  std::string text;
  int line = 0;
};

class StageTokens {
 public:
  StageTokens(const std::string& text, std::string where) : text_(text), where_(std::move(where)) {
    advance();
  }

  const StageToken& peek() const { return token_; }
  bool at_mark(char mark) const {
    return token_.kind == StageToken::Kind::Mark && token_.text[0] == mark;
  }
  StageToken take() {
    StageToken token = token_;
    advance();
    return token;
  }
  void expect(char mark) {
    if (!at_mark(mark)) throw error("'" + token_.text.substr(0, 40) + "'", std::string(1, mark));
    advance();
  }
  Error error(const std::string& what, const std::string& expected) const {
    return file_error(where_ + ":" + std::to_string(token_.line),
                      token_.kind == StageToken::Kind::End ? "ends early" : "has " + what,
                      expected);
  }

 private:
  void advance() {
    skip_blanks();
    token_ = {StageToken::Kind::End, "", line_};
    if (at_ >= text_.size()) return;
    const char c = text_[at_];
    if (c == '"') {
      const std::size_t end = text_.find('"', at_ + 1);
      if (end == std::string::npos)
        throw file_error(where_ + ":" + std::to_string(line_), "has a text without an end", "\"");
      token_ = {StageToken::Kind::Text, text_.substr(at_ + 1, end - at_ - 1), line_};
      at_ = end + 1;
    } else if (std::string("()[]").find(c) != std::string::npos) {
      token_ = {StageToken::Kind::Mark, std::string(1, c), line_};
      ++at_;
    } else {
      const std::size_t end = std::min(text_.find_first_of(" \t\r\n,()[]\"#", at_), text_.size());
      token_ = {StageToken::Kind::Word, text_.substr(at_, end - at_), line_};
      at_ = end;
    }
  }

  void skip_blanks() {
    while (at_ < text_.size()) {
      if (text_[at_] == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (std::string(" \t\r\n,").find(text_[at_]) != std::string::npos) {
        line_ += text_[at_] == '\n' ? 1 : 0;
        ++at_;
      } else {
        return;
      }
    }
  }

  const std::string& text_;
  std::string where_;
  std::size_t at_ = 0;
  int line_ = 1;
  StageToken token_;
};

struct StageEntity {
  std::string type;
  std::map<std::string, std::vector<std::string>> properties;
  std::vector<std::pair<int, std::vector<std::string>>> points;  ///< point[i] of a block
  std::vector<StageEntity> children;
  int line = 0;
};

class StageReader {
 public:
  StageReader(const std::string& path, const WorldOptions& options) : parts_(path, options) {}

  ImportedWorld read(const std::string& path) {
    read_file_of(path, 0);
    if (grid_) parts_.set_grid(std::move(*grid_));
    parts_.set_task(start_, std::nullopt);
    return parts_.finish(fs::path(path).stem().string());
  }

 private:
  void read_file_of(const std::string& path, int depth) {
    parts_.count(files_, kMaxFiles, "included files");
    const std::string text = read_text(path, "a world of Stage", kMaxConfigSize);
    StageTokens tokens(text, path);
    while (tokens.peek().kind != StageToken::Kind::End) {
      const std::string word = word_of(tokens);
      if (word == "include") {
        const std::string file = (fs::path(path).parent_path() / tokens.take().text).string();
        std::error_code ignored;
        if (depth < kMaxNesting && fs::is_regular_file(file, ignored))
          read_file_of(file, depth + 1);
        else
          parts_.leave_out("included files", file);
      } else if (word == "define") {
        const std::string name = word_of(tokens);
        definitions_[name] = body_of(tokens, word_of(tokens), 0);
      } else if (tokens.at_mark('(')) {
        add(body_of(tokens, word, 0), path);
      } else {
        const auto values = values_of(tokens);
        const bool other_unit =
            (word == "unit_length" && values != std::vector<std::string>{"m"}) ||
            (word == "unit_angle" && values != std::vector<std::string>{"degrees"});
        if (other_unit) throw tokens.error("another " + word, "m and degrees");
      }
    }
  }

  static std::string word_of(StageTokens& tokens) {
    if (tokens.peek().kind != StageToken::Kind::Word)
      throw tokens.error("'" + tokens.peek().text.substr(0, 40) + "'", "a name");
    return tokens.take().text;
  }

  static std::vector<std::string> values_of(StageTokens& tokens) {
    if (!tokens.at_mark('[')) {
      if (tokens.peek().kind == StageToken::Kind::Mark ||
          tokens.peek().kind == StageToken::Kind::End)
        throw tokens.error("'" + tokens.peek().text + "'", "a value");
      return {tokens.take().text};
    }
    tokens.expect('[');
    std::vector<std::string> values;
    while (!tokens.at_mark(']')) {
      if (tokens.peek().kind == StageToken::Kind::Mark ||
          tokens.peek().kind == StageToken::Kind::End)
        throw tokens.error("'" + tokens.peek().text + "'", "values and ]");
      values.push_back(tokens.take().text);
    }
    tokens.expect(']');
    return values;
  }

  StageEntity body_of(StageTokens& tokens, const std::string& type, int depth) {
    parts_.count(entities_, kMaxEntities, "models");
    StageEntity entity;
    entity.type = type;
    entity.line = tokens.peek().line;
    if (depth > kMaxNesting) throw tokens.error("models nested too deeply", "at most 12 levels");
    tokens.expect('(');
    while (!tokens.at_mark(')')) {
      const std::string word = word_of(tokens);
      if (tokens.at_mark('(')) {
        entity.children.push_back(body_of(tokens, word, depth + 1));
        continue;
      }
      auto values = values_of(tokens);
      if (!tokens.at_mark('[')) {
        entity.properties[word] = std::move(values);
        continue;
      }
      long long index = 0;
      if (word == "point" && values.size() == 1 && parse_integer(values[0], index) &&
          std::abs(index) < 1'000'000)
        entity.points.emplace_back(static_cast<int>(index), values_of(tokens));
      else
        values_of(tokens);
    }
    tokens.expect(')');
    return entity;
  }

  /// The definitions of an entity from its own to that of its most general type.
  std::vector<const StageEntity*> chain_of(const StageEntity& entity) const {
    std::vector<const StageEntity*> chain{&entity};
    for (int depth = 0; depth < kMaxNesting; ++depth) {
      const auto found = definitions_.find(chain.back()->type);
      if (found == definitions_.end()) break;
      chain.push_back(&found->second);
    }
    return chain;
  }

  using Chain = std::vector<const StageEntity*>;

  static const std::vector<std::string>* property(const Chain& chain, const std::string& name) {
    for (const StageEntity* entity : chain) {
      const auto found = entity->properties.find(name);
      if (found != entity->properties.end() && !found->second.empty()) return &found->second;
    }
    return nullptr;
  }

  static std::vector<double> numbers(const std::vector<std::string>& texts, const std::string& what,
                                     const std::string& where) {
    std::vector<double> values;
    for (const std::string& text : texts) {
      double value = 0;
      if (!parse_number(text, value))
        throw file_error(where, what + " has '" + text.substr(0, 40) + "'", "numbers");
      values.push_back(value);
    }
    return values;
  }

  static std::vector<double> numbers_or(const Chain& chain, const std::string& name,
                                        std::vector<double> otherwise, const std::string& where) {
    const auto* texts = property(chain, name);
    if (texts == nullptr) return otherwise;
    const auto given = numbers(*texts, name, where);
    for (std::size_t i = 0; i < std::min(given.size(), otherwise.size()); ++i)
      otherwise[i] = given[i];
    return otherwise;
  }

  /// A model and those on it, which are placed relative to `parent`.
  void add(const StageEntity& entity, const std::string& path, const Placement& parent = {}) {
    const Chain chain = chain_of(entity);
    const std::string root = chain.back()->type, where = path + ":" + std::to_string(entity.line);
    const auto* names = property(chain, "name");
    const std::string name = names == nullptr ? entity.type : names->front();
    const auto pose = numbers_or(chain, "pose", {0, 0, 0, 0}, where);
    const Placement place =
        parent + Placement(pose[0], pose[1], pose[2], mrpt::DEG2RAD(pose[3]), 0, 0);
    if (root == "position") {
      if (start_) return parts_.leave_out("robots", name);
      start_ = {place.x(), place.y(), place.yaw()};
      return;
    }
    if (root != "model" && root != "floorplan" && root != "map") return;
    const auto size = numbers_or(chain, "size", {0.4, 0.4, 1}, where);
    if (!(size[0] > 0 && size[1] > 0 && size[2] > 0))
      throw file_error(where, "a size is not above 0", "lengths in m");
    const auto origin = numbers_or(chain, "origin", {0, 0, 0, 0}, where);
    const Placement center = place + Placement(origin[0], origin[1], origin[2] + size[2] / 2,
                                               mrpt::DEG2RAD(origin[3]), 0, 0);
    const bool is_transparent = numbers_or(chain, "obstacle_return", {1}, where)[0] == 0 &&
                                numbers_or(chain, "ranger_return", {1}, where)[0] < 0;
    if (is_transparent)
      parts_.leave_out("models that nothing sees or touches", name);
    else
      add_shape(chain, center, size, path, name, where);
    const bool stacked = numbers_or(chain, "stack_children", {1}, where)[0] != 0;
    const Placement base = place + Placement(0, 0, stacked ? size[2] : 0, 0, 0, 0);
    for (const StageEntity* one : chain)
      for (const StageEntity& child : one->children) {
        parts_.count(entities_, kMaxEntities, "models");
        if (child.type != "block") add(child, path, base);
      }
  }

  void add_shape(const Chain& chain, const Placement& center, const std::vector<double>& size,
                 const std::string& path, const std::string& name, const std::string& where) {
    if (const auto* bitmap = property(chain, "bitmap"))
      add_bitmap((fs::path(path).parent_path() / bitmap->front()).string(), center, size, name);
    else
      add_blocks(chain, center, size, name, where);
    if (numbers_or(chain, "boundary", {0}, where)[0] != 0) add_boundary(center, size);
  }

  void add_boundary(const Placement& center, const std::vector<double>& size) {
    const double x = (size[0] - kBoundaryWidth) / 2, y = (size[1] - kBoundaryWidth) / 2;
    for (const double side : {-1.0, 1.0}) {
      parts_.add_box(center + Placement(side * x, 0, 0, 0, 0, 0), kBoundaryWidth, size[1], size[2]);
      parts_.add_box(center + Placement(0, side * y, 0, 0, 0, 0), size[0], kBoundaryWidth, size[2]);
    }
  }

  /// The blocks of a model, scaled to its size; a box if it has none.
  void add_blocks(const Chain& chain, const Placement& center, const std::vector<double>& size,
                  const std::string& name, const std::string& where) {
    std::vector<Polygon> blocks;
    Bounds all{HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (const StageEntity* entity : chain)
      for (const StageEntity& child : entity->children) {
        if (child.type != "block") continue;
        auto points = child.points;
        std::sort(points.begin(), points.end());
        blocks.emplace_back();
        for (const auto& [index, texts] : points) {
          const auto v = numbers(texts, "a point", where);
          if (v.size() != 2) throw file_error(where, "has a point of a block", "two numbers");
          blocks.back().vertices.emplace_back(v[0], v[1]);
          all = {std::min(all.x_min, v[0]), std::min(all.y_min, v[1]), std::max(all.x_max, v[0]),
                 std::max(all.y_max, v[1])};
        }
      }
    if (blocks.empty()) return parts_.add_box(center, size[0], size[1], size[2]);
    for (Polygon& block : blocks) {
      for (TPoint2D& p : block.vertices)
        p = {((p.x - all.x_min) / all.width() - 0.5) * size[0],
             ((p.y - all.y_min) / all.height() - 0.5) * size[1]};
      if (!is_simple(block) || !parts_.add_prism(center, block, -size[2] / 2, size[2] / 2))
        parts_.leave_out("blocks that cross themselves of", name);
    }
  }

  /// The dark pixels, whose extent Stage scales to the size of the model, as square cells that they
  /// overlap.
  void add_bitmap(const std::string& path, const Placement& center, const std::vector<double>& size,
                  const std::string& name) {
    if (grid_) return parts_.leave_out("further bitmaps of", name);
    ImageMapOptions options;
    options.resolution = 1;
    const COccupancyGridMap2D pixels = read_image_map(path, options);
    const int width = static_cast<int>(pixels.getSizeX()),
              height = static_cast<int>(pixels.getSizeY());
    const auto is_dark = [&](int x, int y) { return pixels.getCell(x, y) < 0.5F; };
    int left = width, right = -1, below = height, above = -1;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (is_dark(x, y)) {
          left = std::min(left, x), right = std::max(right, x);
          below = std::min(below, y), above = std::max(above, y);
        }
    if (right < 0) return parts_.leave_out("bitmaps without dark pixels of", name);
    const double pixel_x = size[0] / (right - left + 1), pixel_y = size[1] / (above - below + 1),
                 cell = std::min(pixel_x, pixel_y);
    const auto first = [&](double at) { return static_cast<int>(std::floor(at / cell + 1e-6)); };
    const auto end = [&](double at) { return static_cast<int>(std::ceil(at / cell - 1e-6)); };
    if (size[0] / cell * (size[1] / cell) > kMaxGridCells)
      throw file_error(path, "has pixels of very different sides", "at most 400 million cells");
    const double yaw = center.yaw();
    const Placement corner = center + Placement(-size[0] / 2, -size[1] / 2, 0, 0, 0, 0);
    auto grid = make_grid_map(end(size[0]), end(size[1]), cell, {corner.x(), corner.y()});
    for (int y = below; y <= above; ++y)
      for (int x = left; x <= right; ++x) {
        if (!is_dark(x, y)) continue;
        for (int cy = first((y - below) * pixel_y); cy < end((y - below + 1) * pixel_y); ++cy)
          for (int cx = first((x - left) * pixel_x); cx < end((x - left + 1) * pixel_x); ++cx)
            grid.setCell(cx, cy, 0.0F);
      }
    grid_ = yaw == 0 ? grid : rotated_grid(grid, yaw, path);
  }

  WorldParts parts_;
  std::map<std::string, StageEntity> definitions_;
  std::optional<COccupancyGridMap2D> grid_;
  std::optional<mrpt::math::TPose2D> start_;
  std::size_t files_ = 0, entities_ = 0;
};

}  // namespace

ImportedWorld stage_world(const std::string& path, const WorldOptions& options) {
  return StageReader(path, options).read(path);
}

}  // namespace slalom
