// SPDX-License-Identifier: BSD-3-Clause
#include "coverage_archive.h"

#include <algorithm>
#include <limits>

namespace slalom {

CoverageArchive::CoverageArchive(const CoverageBins& bins, std::vector<bool> open, int per_bin,
                                 double min_difference)
    : bins_(bins),
      open_(std::move(open)),
      per_bin_(static_cast<std::size_t>(per_bin)),
      min_difference_(min_difference),
      members_(bins.size()),
      nearest_(bins.size()) {
  for (const CoverageAxis& axis : bins.axes()) open_in_slot_.emplace_back(axis.size(), 0);
  for (std::size_t bin = 0; bin < bins.size(); ++bin) {
    if (!open_[bin]) continue;
    const auto position = bins.position(bin);
    for (std::size_t i = 0; i < position.size(); ++i) ++open_in_slot_[i][position[i]];
  }
}

bool CoverageArchive::any_open() const {
  return std::find(open_.begin(), open_.end(), true) != open_.end();
}

void CoverageArchive::close(std::size_t bin) {
  if (!open_[bin]) return;
  open_[bin] = false;
  nearest_[bin].clear();
  const auto position = bins_.position(bin);
  for (std::size_t i = 0; i < position.size(); ++i) --open_in_slot_[i][position[i]];
}

std::shared_ptr<const Scenario> CoverageArchive::parent_for(std::size_t bin,
                                                            RandomEngine& engine) const {
  const std::size_t inside = members_[bin].size(), outside = nearest_[bin].size();
  if (inside + outside == 0) return nullptr;
  const bool from_inside = outside == 0 || (inside > 0 && uniform_int(engine, 0, 1) == 1);
  const int last = static_cast<int>(from_inside ? inside : outside) - 1;
  const auto index = static_cast<std::size_t>(uniform_int(engine, 0, last));
  return from_inside ? members_[bin][index].scenario : nearest_[bin][index].scenario;
}

double CoverageArchive::max_distance(std::size_t bin) const {
  return nearest_[bin].size() < kNearest ? std::numeric_limits<double>::infinity()
                                         : nearest_[bin].back().distance;
}

CoverageArchive::OfferResult CoverageArchive::offer(const Elite& elite, std::size_t target) {
  if (elite.is_exact && elite.bin && open_[*elite.bin]) {
    if (!is_new(elite)) return OfferResult::Duplicate;
    hashes_.insert(elite.scenario->hash());
    members_[*elite.bin].push_back(elite);
    if (members_[*elite.bin].size() >= per_bin_) close(*elite.bin);
    for (std::size_t bin = 0; bin < bins_.size(); ++bin)
      if (open_[bin] && bin != *elite.bin) insert_nearest(bin, elite);
    return OfferResult::Accepted;
  }
  bool closer = false;
  for (std::size_t bin = 0; bin < bins_.size(); ++bin)
    if (open_[bin] && insert_nearest(bin, elite) && bin == target) closer = true;
  return closer ? OfferResult::Closer : OfferResult::Rejected;
}

bool CoverageArchive::is_new(const Elite& elite) const {
  if (hashes_.count(elite.scenario->hash()) > 0) return false;
  for (const auto& members : members_)
    for (const Elite& member : members)
      if (difference(member.sketch, elite.sketch) < min_difference_) return false;
  return true;
}

bool CoverageArchive::insert_nearest(std::size_t bin, const Elite& elite) {
  const double distance = bins_.distance(bin, elite.point);
  if (distance >= max_distance(bin)) return false;
  auto& near = nearest_[bin];
  for (const Neighbor& neighbor : near)
    if (neighbor.scenario->hash() == elite.scenario->hash()) return false;
  const auto position = std::upper_bound(
      near.begin(), near.end(), distance,
      [](double limit, const Neighbor& neighbor) { return limit < neighbor.distance; });
  near.insert(position, {distance, elite.scenario});
  if (near.size() > kNearest) near.pop_back();
  return true;
}

}  // namespace slalom
