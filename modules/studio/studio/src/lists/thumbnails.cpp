// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/io/scenario_list.h>
#include <slalom/scenario/occupancy.h>
#include <slalom/studio/jobs.h>
#include <slalom/studio/palette.h>
#include <slalom/studio/thumbnails.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kCellsPerPixel = 2;
constexpr double kMaxCells = 100000;                        // along a side
constexpr double kDiscRadius = 3.5, kMinMoverRadius = 1.5;  // pixels of kThumbnailSize

struct Cells {
  int first, end;
};

/// Cell size (m) for scenarios without cells; at most the shorter side.
double cell_size(const Bounds& bounds, int pixels) {
  const double longer = std::max(bounds.width(), bounds.height());
  const double shorter = std::min(bounds.width(), bounds.height());
  return std::max(std::min(longer / (kCellsPerPixel * pixels), shorter), longer / kMaxCells);
}

/// The number of cells along a side, without a last one that exceeds the bounds and so counts as
/// occupied.
int count_whole_cells(double length, const Occupancy& cells) {
  return std::max(static_cast<int>(std::floor(length / cells.resolution() * (1 + 1e-6))), 1);
}

/// The cells in a pixel, at least one.
Cells cells_in(int pixel, int pixels, int cells) {
  const auto edge = [&](int p) {
    return static_cast<int>(static_cast<std::int64_t>(p) * cells / pixels);
  };
  const int first = std::min(edge(pixel), cells - 1);
  return {first, std::max(edge(pixel + 1), first + 1)};
}

/// A square image with the scenario in its center.
class Canvas {
 public:
  Canvas(const Bounds& bounds, int size) : bounds_(bounds), size_(size) {
    scale_ = size / std::max(bounds.width(), bounds.height());
    width_ = std::clamp(static_cast<int>(std::lround(bounds.width() * scale_)), 1, size);
    height_ = std::clamp(static_cast<int>(std::lround(bounds.height() * scale_)), 1, size);
    left_ = (size - width_) / 2;
    top_ = (size - height_) / 2;
    rgba_.resize(4 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  }

  void draw_cells(const Occupancy& cells) {
    const int across = count_whole_cells(bounds_.width(), cells),
              up = count_whole_cells(bounds_.height(), cells);
    for (int py = 0; py < height_; ++py)
      for (int px = 0; px < width_; ++px) {
        const double dark =
            darkness(cells, cells_in(px, width_, across), cells_in(height_ - 1 - py, height_, up));
        set(left_ + px, top_ + py, palette().free_space, 1);
        set(left_ + px, top_ + py, palette().obstacle, dark);
      }
  }

  void draw_disc(const TPoint2D& at, const Color& color) {
    draw_disc(at, color, enlarged(kDiscRadius));
  }

  /// `radius` in pixels.
  void draw_disc(const TPoint2D& at, const Color& color, double radius) {
    const TPoint2D c = pixel_of(at);
    for (int y = 0; y < size_; ++y)
      for (int x = 0; x < size_; ++x)
        set(x, y, color, radius + 0.5 - math::hypot(x + 0.5 - c.x, y + 0.5 - c.y));
  }

  /// `radius` in m, enlarged if it could not be seen.
  void draw_moving(const TPoint2D& at, double radius, const Color& color) {
    draw_disc(at, color, std::max(scale_ * radius, enlarged(kMinMoverRadius)));
  }

  /// A line from the center of a disc to 2.2 times its radius.
  void draw_heading(const TPoint2D& at, double angle, const Color& color) {
    const TPoint2D c = pixel_of(at);
    const double length = 2.2 * enlarged(kDiscRadius);
    const TPoint2D tip(c.x + length * math::cos(angle), c.y - length * math::sin(angle));
    for (int y = 0; y < size_; ++y)
      for (int x = 0; x < size_; ++x)
        set(x, y, color, enlarged(0.8) + 0.5 - distance_to_segment({x + 0.5, y + 0.5}, c, tip));
  }

  Thumbnail take() { return {size_, std::move(rgba_)}; }

 private:
  static double darkness(const Occupancy& cells, Cells across, Cells up) {
    int occupied = 0;
    for (int cy = up.first; cy < up.end; ++cy)
      for (int cx = across.first; cx < across.end; ++cx) occupied += cells.occupied(cx, cy) ? 1 : 0;
    const double mean =
        static_cast<double>(occupied) / ((up.end - up.first) * (across.end - across.first));
    return occupied == 0 ? 0 : 0.5 + 0.5 * mean;
  }

  /// Keeps symbols in proportion to the image.
  double enlarged(double pixels) const { return pixels * size_ / kThumbnailSize; }

  TPoint2D pixel_of(const TPoint2D& p) const {
    return {left_ + (p.x - bounds_.x_min) / bounds_.width() * width_,
            top_ + (bounds_.y_max - p.y) / bounds_.height() * height_};
  }

  /// Blends a color over a pixel; no effect if `coverage` is not positive.
  void set(int x, int y, const Color& color, double coverage) {
    if (coverage <= 0) return;
    const double alpha = std::min(coverage, 1.0);
    std::uint8_t* pixel =
        &rgba_[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size_) +
                    static_cast<std::size_t>(x))];
    const double below = pixel[3] / 255.0 * (1 - alpha), opacity = alpha + below;
    const std::array<std::uint8_t, 3> rgb = {color.R, color.G, color.B};
    for (std::size_t i = 0; i < 3; ++i)
      pixel[i] =
          static_cast<std::uint8_t>(std::lround((rgb[i] * alpha + pixel[i] * below) / opacity));
    pixel[3] = static_cast<std::uint8_t>(std::lround(255 * opacity));
  }

  Bounds bounds_;
  int size_, width_, height_, left_, top_;
  double scale_;
  std::vector<std::uint8_t> rgba_;
};

constexpr std::size_t kBatchSize = 4;  // small, so that the visible rows are soon drawn

using Batch = std::vector<std::pair<std::string, Thumbnail>>;

/// Runs in a worker thread. Unreadable scenarios get an empty thumbnail, so that they are not
/// requested again.
Batch make_thumbnails(const std::string& path, const std::vector<std::string>& hashes, int size,
                      Progress& progress) {
  Batch batch;
  progress.start("Drawing thumbnails", hashes.size());
  const ScenarioList list = ScenarioList::open(path);
  for (const std::string& hash : hashes) {
    try {
      batch.emplace_back(hash, make_thumbnail(list.read(hash), size));
    } catch (const Error&) {
      batch.emplace_back(hash, Thumbnail{});
    }
    progress.advance(batch.size());
  }
  return batch;
}

}  // namespace

Thumbnail make_thumbnail(const Scenario& scenario, int size) {
  const Bounds& bounds = scenario.bounds();
  Canvas canvas(bounds, size);
  canvas.draw_cells(make_occupancy(scenario, cell_size(bounds, size)));
  const auto& start = scenario.start();
  for (const Mover& mover : scenario.movers())
    if (mover.present(0)) canvas.draw_moving(mover.position(0), mover.radius, palette().mover);
  for (const Person& person : scenario.people())
    if (person.begin <= 0) canvas.draw_moving(person.start, person.radius, palette().person);
  canvas.draw_disc(scenario.goal(), palette().goal);
  canvas.draw_heading({start.x, start.y}, start.phi, palette().start);
  canvas.draw_disc({start.x, start.y}, palette().start);
  return canvas.take();
}

ThumbnailMaker::ThumbnailMaker(Jobs& jobs, Ready ready)
    : jobs_(jobs), ready_(std::move(ready)), alive_(std::make_shared<ThumbnailMaker*>(this)) {}

void ThumbnailMaker::request(const std::string& list_path, std::vector<std::string> hashes,
                             int size) {
  path_ = list_path;
  size_ = size;
  requested_ = std::move(hashes);
  if (!working_ && !requested_.empty()) work();
}

void ThumbnailMaker::work() {
  working_ = true;
  const std::vector<std::string> now(
      requested_.begin(),
      requested_.begin() + static_cast<std::ptrdiff_t>(std::min(requested_.size(), kBatchSize)));
  const auto deliver = [alive = std::weak_ptr<ThumbnailMaker*>(alive_)](const Batch& batch) {
    const auto maker = alive.lock();
    if (!maker) return;
    ThumbnailMaker& self = **maker;
    self.working_ = false;
    for (const auto& [hash, thumbnail] : batch) {
      self.requested_.erase(std::remove(self.requested_.begin(), self.requested_.end(), hash),
                            self.requested_.end());
      self.ready_(hash, thumbnail);
    }
    if (!self.requested_.empty()) self.work();
  };
  jobs_.start(
      "thumbnails", "Thumbnails",
      [path = path_, now, size = size_, deliver](Progress& progress) -> Jobs::Delivery {
        auto batch = make_thumbnails(path, now, size, progress);
        return [batch = std::move(batch), deliver] { deliver(batch); };
      },
      [now, deliver](const std::string&) {  // the list cannot be opened
        Batch none;
        for (const std::string& hash : now) none.emplace_back(hash, Thumbnail{});
        deliver(none);
      },
      false);
}

}  // namespace slalom
