// SPDX-License-Identifier: BSD-3-Clause
#include "cell_parts.h"

#include <algorithm>

namespace slalom {
namespace {

const std::vector<CellIndex> kFourSteps = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
const std::vector<CellIndex> kEightSteps = {{1, 0}, {-1, 0}, {0, 1},  {0, -1},
                                            {1, 1}, {-1, 1}, {1, -1}, {-1, -1}};

}  // namespace

/// Labels the cells of one kind from bottom to top by flood fill along steps for which `connected`
/// holds.
template <typename Connected>
void CellParts::label_components(bool occupied, const std::vector<CellIndex>& steps,
                                 const Connected& connected) {
  labels_.assign(cells_.cells().size(), -1);
  first_cells_.clear();
  spans_.clear();
  at_border_.clear();
  std::vector<CellIndex> open;
  const auto take = [&](const CellIndex& at, std::int32_t label) {
    labels_[cells_.index(at.cx, at.cy)] = label;
    RowSpan& span = spans_.back();
    span.last = std::max(span.last, at.cy);
    if (at.cx == 0 || at.cy == 0 || at.cx == cells_.size_x() - 1 || at.cy == cells_.size_y() - 1)
      at_border_.back() = true;
    open.push_back(at);
  };
  for (int cy = 0; cy < cells_.size_y(); ++cy)
    for (int cx = 0; cx < cells_.size_x(); ++cx) {
      if (cells_.occupied(cx, cy) != occupied || part(cx, cy) >= 0) continue;
      const auto label = static_cast<std::int32_t>(first_cells_.size());
      first_cells_.push_back({cx, cy});
      spans_.push_back({cy, cy});
      at_border_.push_back(false);
      take({cx, cy}, label);
      while (!open.empty()) {
        const CellIndex from = open.back();
        open.pop_back();
        for (const CellIndex& step : steps) {
          const CellIndex to{from.cx + step.cx, from.cy + step.cy};
          if (cells_.inside(to.cx, to.cy) && cells_.occupied(to.cx, to.cy) == occupied &&
              part(to.cx, to.cy) < 0 && connected(from, to))
            take(to, label);
        }
      }
    }
}

/// A cut below any of a hole's rows, or above its last row, opens the hole. A hole is enclosed by
/// the component of the cell below the hole's lowest cell.
CellParts::Cuts CellParts::find_cuts() {
  const auto always = [](const CellIndex&, const CellIndex&) { return true; };
  label_components(false, kEightSteps, always);
  std::vector<CellIndex> below;
  std::vector<RowSpan> holes;
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    if (at_border_[i]) continue;
    below.push_back({first_cells_[i].cx, first_cells_[i].cy - 1});
    holes.push_back({spans_[i].first, spans_[i].last + 1});
  }
  label_components(true, kFourSteps, always);
  std::vector<std::vector<RowSpan>> by_component(first_cells_.size());
  for (std::size_t i = 0; i < holes.size(); ++i)
    by_component[static_cast<std::size_t>(part(below[i].cx, below[i].cy))].push_back(holes[i]);
  Cuts cuts(by_component.size());
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    auto& spans = by_component[i];
    std::sort(spans.begin(), spans.end(),
              [](const RowSpan& a, const RowSpan& b) { return a.last < b.last; });
    for (const RowSpan& span : spans)
      if (cuts[i].empty() || cuts[i].back() < span.first) cuts[i].push_back(span.last);
  }
  return cuts;
}

CellParts::CellParts(const Occupancy& cells) : cells_(cells) {
  const Cuts cuts = find_cuts();
  const std::vector<std::int32_t> components = labels_;
  label_components(true, kFourSteps, [&](const CellIndex& from, const CellIndex& to) {
    if (from.cy == to.cy) return true;
    const auto& rows = cuts[static_cast<std::size_t>(components[cells.index(to.cx, to.cy)])];
    return !std::binary_search(rows.begin(), rows.end(), std::max(from.cy, to.cy));
  });
}

}  // namespace slalom
