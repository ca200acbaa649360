#pragma once

#include <slalom/scenario/scenario.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace slalom {

class Jobs;

/// A small picture: rows from top to bottom, four bytes a pixel (red, green, blue, opacity, not
/// premultiplied). Empty where the scenario could not be read.
struct Thumbnail {
  int size = 0;  ///< pixels on each side
  std::vector<std::uint8_t> rgba;
};

/// The place to scale with its start (a disc with its heading) and goal, see-through beside it. A
/// pixel is the darker the more of it is occupied, and never so light that a thin wall is lost. May
/// run in any thread.
Thumbnail make_thumbnail(const Scenario& scenario, int size = 64);

/// What was used last, by hash, up to a number of things.
template <typename T>
class RecentlyUsed {
 public:
  explicit RecentlyUsed(std::size_t most, std::function<void(T&)> on_drop = {})
      : most_(most), on_drop_(std::move(on_drop)) {}

  /// Null when it is not there; else it counts as just used.
  T* find(const std::string& hash) {
    const auto at = by_hash_.find(hash);
    if (at == by_hash_.end()) return nullptr;
    order_.splice(order_.begin(), order_, at->second);
    return &at->second->second;
  }
  void put(const std::string& hash, T thing) {
    if (T* there = find(hash)) {
      if (on_drop_) on_drop_(*there);
      *there = std::move(thing);
      return;
    }
    order_.emplace_front(hash, std::move(thing));
    by_hash_[hash] = order_.begin();
    while (order_.size() > most_) {
      if (on_drop_) on_drop_(order_.back().second);
      by_hash_.erase(order_.back().first);
      order_.pop_back();
    }
  }
  void clear() {
    for (auto& [hash, thing] : order_)
      if (on_drop_) on_drop_(thing);
    order_.clear();
    by_hash_.clear();
  }
  std::size_t size() const { return order_.size(); }

 private:
  std::size_t most_;
  std::function<void(T&)> on_drop_;
  std::list<std::pair<std::string, T>> order_;  ///< the last one used first
  std::map<std::string, typename std::list<std::pair<std::string, T>>::iterator> by_hash_;
};

/// Makes thumbnails beside the window, a few at a time and only of what was wanted last: what
/// scrolled by is not made.
class ThumbnailMaker {
 public:
  explicit ThumbnailMaker(Jobs& jobs);

  /// On the window's thread. `jobs` may end before this does, and this before `jobs`.
  std::function<void(const std::string& hash, const Thumbnail& picture)> on_ready;

  /// These scenarios of the list are seen and have no picture yet.
  void want(const std::string& list_path, std::vector<std::string> hashes);

  /// How many were wanted and are not there yet.
  std::size_t missing() const { return wanted_.size(); }

 private:
  void work();

  Jobs& jobs_;
  std::string path_;
  std::vector<std::string> wanted_;
  bool working_ = false;
  std::shared_ptr<ThumbnailMaker*> alive_;  ///< deliveries find nobody once this is gone
};

}  // namespace slalom
