// SPDX-License-Identifier: BSD-3-Clause
#include "barn_enclosed.h"
#include "map_readers.h"
#include "npy.h"

#include <slalom/core/error.h>
#include <slalom/core/read_file.h>
#include <slalom/core/text.h>
#include <slalom/map_formats/barn.h>
#include <slalom/map_formats/world_import.h>
#include <slalom/scenario/grid_map.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>

namespace slalom {
namespace {

namespace fs = std::filesystem;
using mrpt::math::TPoint2D;

constexpr int kSide = 30;        // rows and columns of a world
constexpr double kCell = 0.15;   // m
constexpr int kLength = 100;     // cells in y of the workspace
constexpr int kFieldBegin = 34;  // cells in y before column 0 of the grid
constexpr int kMaxWorlds = 1'000'000;

/// Whether a cell before the field, in x and y, belongs to the walls behind (y cell 0) or at the
/// sides of the start.
bool is_wall(int x, int y) {
  return y == 0 || x == 0 || x == kSide - 1;
}

/// x of a row, y of a row of cells (the back wall is in cell 0, column c in cell 34 + c), m.
double x_of(int row) {
  return -4.425 + kCell * row;
}
double y_of(int cell) {
  return 0.075 + kCell * cell;
}

/// The number of a file: 7 for "grid_7.npy".
std::optional<int> number_of(const fs::path& file, const std::string& begin,
                             const std::string& end) {
  const std::string name = file.filename().string();
  if (name.size() <= begin.size() + end.size() || !starts_with(name, begin) ||
      !ends_with(name, end))
    return std::nullopt;
  const std::string digits = name.substr(begin.size(), name.size() - begin.size() - end.size());
  long long number = 0;
  if (digits.find_first_not_of("0123456789") != std::string::npos ||
      !parse_integer(digits, number) || number >= kMaxWorlds)
    return std::nullopt;
  return static_cast<int>(number);
}

std::optional<int> grid_number(const fs::path& file) {
  return number_of(file, "grid_", ".npy");
}
std::optional<int> world_number(const fs::path& file) {
  return number_of(file, "world_", ".world");
}

/// A world as a grid of the data set or as a world of Gazebo of the challenge.
struct WorldFile {
  int number;
  fs::path path;
};

std::vector<WorldFile> numbered_files(const fs::path& folder,
                                      std::optional<int> (*number_in)(const fs::path&)) {
  std::error_code error;
  std::vector<WorldFile> files;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (const auto number = number_in(entry.path())) files.push_back({*number, entry.path()});
  std::sort(files.begin(), files.end(),
            [](const WorldFile& a, const WorldFile& b) { return a.number < b.number; });
  return files;
}

/// The worlds of a folder, sorted by number: its grids, or if there are none its worlds of Gazebo.
std::vector<WorldFile> worlds_in(const fs::path& folder) {
  std::error_code error;
  const fs::path inner = folder / "grid_files";
  const auto grids = numbered_files(fs::is_directory(inner, error) ? inner : folder, grid_number);
  return grids.empty() ? numbered_files(folder, world_number) : grids;
}

/// One part of a selection of worlds: "7", "0-299" or "0-299/even".
struct WorldRange {
  int first = 0, last = 0, step = 1;
  bool contains(int world) const {
    return world >= first && world <= last && (world - first) % step == 0;
  }
};

int parse_world(const std::string& text, const std::string& part) {
  long long number = 0;
  if (!parse_integer(text, number) || number < 0 || number >= kMaxWorlds)
    throw usage_error("--worlds " + part.substr(0, 60), "invalid selection of worlds",
                      "parts like 7, 0-299, 0-299/even, 0-299/odd or 0-299/10");
  return static_cast<int>(number);
}

WorldRange parse_range(const std::string& part) {
  const std::size_t slash = part.find('/');
  const std::string ends = part.substr(0, slash);
  const std::size_t dash = ends.find('-');
  WorldRange range;
  range.first = parse_world(ends.substr(0, dash), part);
  range.last = dash == std::string::npos ? range.first : parse_world(ends.substr(dash + 1), part);
  if (slash == std::string::npos) return range;
  const std::string step = part.substr(slash + 1);
  const bool even = step == "even", odd = step == "odd";
  if (!even && !odd) {
    range.step = std::max(1, parse_world(step, part));
    return range;
  }
  range.step = 2;
  if (range.first % 2 != (odd ? 1 : 0)) ++range.first;
  return range;
}

std::vector<WorldFile> select_worlds(const std::vector<WorldFile>& files, const std::string& worlds,
                                     const std::string& path) {
  if (worlds.empty()) return files;
  std::vector<WorldRange> ranges;
  for (const std::string& part : split(worlds, ',')) ranges.push_back(parse_range(part));
  std::vector<WorldFile> wanted;
  for (const WorldFile& file : files)
    if (std::any_of(ranges.begin(), ranges.end(),
                    [&](const WorldRange& range) { return range.contains(file.number); }))
      wanted.push_back(file);
  if (wanted.empty())
    throw usage_error("--worlds " + worlds.substr(0, 60), "selects no world in " + path,
                      "worlds from " + std::to_string(files.front().number) + " to " +
                          std::to_string(files.back().number));
  return wanted;
}

NpyTable read_grid(const std::string& path) {
  NpyTable grid = read_npy(path);
  if (grid.rows != kSide || grid.columns != kSide)
    throw file_error(
        path, "has " + std::to_string(grid.rows) + " x " + std::to_string(grid.columns) + " cells",
        "a BARN world of 30 x 30 cells");
  for (std::size_t i = 0; i < grid.values.size(); ++i)
    if (grid.values[i] != 0 && grid.values[i] != 1)
      throw file_error(path,
                       "has " + std::to_string(grid.values[i]) + " in row " +
                           std::to_string(i / kSide) + ", column " + std::to_string(i % kSide),
                       "0 (free) or 1 (obstacle)");
  return grid;
}

/// The cell of a cylinder, in x and y from the corner of the workspace; none beside a cell.
std::optional<std::pair<int, int>> cell_of(const Disc& disc) {
  constexpr double kTolerance = 1e-3;  // m
  const double x = std::round((disc.center.x - x_of(0)) / kCell),
               y = std::round((disc.center.y - y_of(0)) / kCell);
  if (!(x >= 0 && x < kSide && y >= 0 && y < kFieldBegin + kSide) ||
      std::abs(disc.radius - kCell / 2) > kTolerance)
    return std::nullopt;
  const std::pair<int, int> cell(static_cast<int>(x), static_cast<int>(y));
  const bool is_centered = std::abs(disc.center.x - x_of(cell.first)) < kTolerance &&
                           std::abs(disc.center.y - y_of(cell.second)) < kTolerance;
  return is_centered ? std::optional(cell) : std::nullopt;
}

/// The grid of a world of Gazebo, which must consist of the cylinders of BARN.
NpyTable grid_of_world(const std::string& path) {
  const Scenario world = import_world(path, {}).scenario;
  const auto refuse = [&](const std::string& what) {
    return file_error(path, "is not a world of BARN: " + what,
                      "cylinders of radius 0.075 m on its cells");
  };
  const Primitives& obstacles = world.primitives();
  if (!world.movers().empty() || !obstacles.polygons.empty())
    throw refuse("it has other obstacles");
  NpyTable grid{kSide, kSide, std::vector<std::int64_t>(std::size_t{kSide} * kSide, 0)};
  std::set<std::pair<int, int>> walls;
  for (const Disc& disc : obstacles.discs) {
    const auto cell = cell_of(disc);
    const bool in_field = cell && cell->second >= kFieldBegin;
    if (!cell || (!in_field && !is_wall(cell->first, cell->second)))
      throw refuse("a cylinder of radius " + format_number(disc.radius) + " m is at (" +
                   format_number(disc.center.x) + ", " + format_number(disc.center.y) + ")");
    if (in_field)
      grid.values[static_cast<std::size_t>(cell->first * kSide + cell->second - kFieldBegin)] = 1;
    else
      walls.insert(*cell);
  }
  if (walls.size() != kSide + 2 * (kFieldBegin - 1))
    throw refuse("its walls around the start are not complete");
  fill_enclosed(grid);
  return grid;
}

/// Another file of the same world: next to it, or in `folder` in or next to its folder.
std::optional<fs::path> companion(const fs::path& world, const std::string& folder,
                                  const std::string& name) {
  std::error_code error;
  const fs::path own = world.parent_path();
  for (const fs::path& place : {own, own / folder, own / ".." / folder})
    if (fs::exists(place / name, error)) return place / name;
  return std::nullopt;
}

PublishedPathPtr read_path(const std::string& path) {
  const NpyTable table = read_npy(path);
  if (table.columns != 2)
    throw file_error(path, "has " + std::to_string(table.columns) + " numbers per point",
                     "row and column");
  auto published = std::make_shared<PublishedPath>();
  published->field = {-4.5, 5.1, 0, 9.6};
  published->cell_size = kCell;
  for (std::size_t i = 0; i < table.rows; ++i) {
    const auto row = table.at(i, 0), column = table.at(i, 1);
    if (row < 0 || row >= kSide || column < 0 || column >= kSide)
      throw file_error(path,
                       "point " + std::to_string(i) + " is in row " + std::to_string(row) +
                           ", column " + std::to_string(column),
                       "rows and columns from 0 to 29");
    published->points.emplace_back(x_of(static_cast<int>(row)),
                                   y_of(kFieldBegin + static_cast<int>(column)));
  }
  return published;
}

/// Checks that a map matches the grid. The maps are shifted by -0.15 m: column c is in pixel row
/// 33 + c from below, x is the row.
void check_map(const GrayImage& image, const NpyTable& grid, const std::string& path) {
  constexpr int kBelow = 33;
  const int middle = (image.white + 1) / 2;
  if (image.width != kSide || image.height < kBelow + kSide)
    throw file_error(
        path,
        "has " + std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels",
        "a BARN map of 30 x 66 pixels");
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column) {
      const int line = image.height - 1 - kBelow - column;
      const bool in_map =
          image.pixels[static_cast<std::size_t>(line) * kSide + static_cast<std::size_t>(row)] <
          middle;
      const bool in_grid =
          grid.at(static_cast<std::size_t>(row), static_cast<std::size_t>(column)) == 1;
      if (in_map != in_grid)
        throw file_error(path,
                         "differs from the grid in row " + std::to_string(row) + ", column " +
                             std::to_string(column),
                         "the map of the same world");
    }
}

/// All cells with a cylinder, relative to the corner of the workspace: the walls and the field.
std::vector<std::pair<int, int>> cylinders(const NpyTable& grid) {
  std::vector<std::pair<int, int>> cells;
  for (int y = 0; y < kFieldBegin; ++y)
    for (int x = 0; x < kSide; ++x)
      if (is_wall(x, y)) cells.emplace_back(x, y);
  for (int column = 0; column < kSide; ++column)
    for (int row = 0; row < kSide; ++row)
      if (grid.at(static_cast<std::size_t>(row), static_cast<std::size_t>(column)) == 1)
        cells.emplace_back(row, kFieldBegin + column);
  return cells;
}

struct StartAndGoal {
  mrpt::math::TPose2D start;
  TPoint2D goal;
};

/// The task of the trials, see BarnTask; of the challenge if there is no path.
StartAndGoal task_of(const PublishedPath* path) {
  if (path == nullptr) return {{-2.25, 3, M_PI / 2}, {-2.25, 13}};
  const TPoint2D displaced(-0.15, -0.1);
  const TPoint2D first = path->points.front() + displaced, last = path->points.back() + displaced;
  return {{std::clamp(first.x, -3.9, -0.5), first.y - 1, M_PI / 2}, {last.x, last.y + 0.3}};
}

Scenario make_world(const std::string& name, const NpyTable& grid, Representation representation,
                    const StartAndGoal& task) {
  const auto& [start, goal] = task;
  if (representation == Representation::Grid) {
    auto map = make_grid_map(kSide, kLength, kCell, {-4.5, 0});
    for (const auto& [x, y] : cylinders(grid)) map.setCell(x, y, 0.0F);
    return Scenario::grid(name, map, start, goal);
  }
  Primitives obstacles;
  for (const auto& [x, y] : cylinders(grid)) obstacles.discs.push_back({{x_of(x), y_of(y)}, 0.075});
  return Scenario::continuous(name, {-4.5, 0, 0, kLength * kCell}, std::move(obstacles), start,
                              goal);
}

Scenario read_world(const WorldFile& file, const BarnOptions& options) {
  const std::string number = std::to_string(file.number);
  const NpyTable grid =
      grid_number(file.path) ? read_grid(file.path.string()) : grid_of_world(file.path.string());
  if (const auto map = companion(file.path, "map_files", "map_pgm_" + number + ".pgm"))
    check_map(parse_pgm(read_file(map->string(), "a map of BARN", kMaxMapSize), map->string()),
              grid, map->string());
  const auto path_file = companion(file.path, "path_files", "path_" + number + ".npy");
  const PublishedPathPtr path = path_file ? read_path(path_file->string()) : nullptr;
  const bool trials = options.task == BarnTask::Trials;
  if (trials && (path == nullptr || path->points.empty()))
    throw file_error(file.path.string(), "has no path, which the task of the trials begins with",
                     "path_" + number + ".npy beside it or in path_files");
  const Scenario world = make_world("barn_" + number, grid, options.representation,
                                    task_of(trials ? path.get() : nullptr));
  return path == nullptr ? world : world.with_published_path(path);
}

}  // namespace

bool is_barn(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) return !worlds_in(path).empty();
  if (!world_number(path)) return grid_number(path).has_value();
  try {
    grid_of_world(path);
    return true;
  } catch (const Error&) {
    return false;  // a world of Gazebo with a name like those of BARN
  }
}

std::vector<Scenario> import_barn(const std::string& path, const BarnOptions& options) {
  if (options.representation == Representation::Points)
    throw usage_error(path, "BARN worlds cannot be imported as points", "continuous or grid");
  std::error_code error;
  std::vector<WorldFile> files;
  if (fs::is_directory(path, error)) {
    files = worlds_in(path);
  } else if (const auto number = grid_number(path) ? grid_number(path) : world_number(path)) {
    files = {{*number, path}};
  }
  if (files.empty())
    throw file_error(path, "contains no BARN worlds",
                     "a folder with grid_files or world_7.world, or a grid such as grid_7.npy");
  std::vector<Scenario> scenarios;
  for (const WorldFile& file : select_worlds(files, options.worlds, path))
    scenarios.push_back(read_world(file, options));
  return scenarios;
}

}  // namespace slalom
