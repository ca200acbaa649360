// SPDX-License-Identifier: BSD-3-Clause
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

/// A small image: rows from top to bottom, RGBA, not premultiplied. Empty if the scenario could not
/// be read.
struct Thumbnail {
  int size = 0;  ///< pixels on each side
  std::vector<std::uint8_t> rgba;
};

constexpr int kThumbnailSize = 64;  ///< pixels on each side

/// Draws the scenario to scale with its start (a disc with its heading) and goal, on a transparent
/// background. A pixel is darker the more of it is occupied, but thin walls stay visible. May run
/// in any thread.
Thumbnail make_thumbnail(const Scenario& scenario, int size = kThumbnailSize);

/// A cache of up to `capacity` items by hash that evicts the least recently used one.
template <typename T>
class LruCache {
 public:
  explicit LruCache(std::size_t capacity, std::function<void(T&)> on_evict = {})
      : capacity_(capacity), on_evict_(std::move(on_evict)) {}

  /// Null if not found; otherwise the item becomes the most recently used.
  T* find(const std::string& hash) {
    const auto at = by_hash_.find(hash);
    if (at == by_hash_.end()) return nullptr;
    order_.splice(order_.begin(), order_, at->second);
    return &at->second->second;
  }
  void put(const std::string& hash, T item) {
    if (T* found = find(hash)) {
      if (on_evict_) on_evict_(*found);
      *found = std::move(item);
      return;
    }
    order_.emplace_front(hash, std::move(item));
    by_hash_[hash] = order_.begin();
    while (order_.size() > capacity_) {
      if (on_evict_) on_evict_(order_.back().second);
      by_hash_.erase(order_.back().first);
      order_.pop_back();
    }
  }
  /// Takes effect with the next put().
  void set_capacity(std::size_t capacity) { capacity_ = capacity; }
  void clear() {
    for (auto& [hash, item] : order_)
      if (on_evict_) on_evict_(item);
    order_.clear();
    by_hash_.clear();
  }
  std::size_t size() const { return order_.size(); }

 private:
  std::size_t capacity_;
  std::function<void(T&)> on_evict_;
  std::list<std::pair<std::string, T>> order_;  ///< most recently used first
  std::map<std::string, typename std::list<std::pair<std::string, T>>::iterator> by_hash_;
};

/// Draws thumbnails in a background thread, in small batches and only those requested last: rows
/// that were scrolled past are skipped.
class ThumbnailMaker {
 public:
  using Ready = std::function<void(const std::string& hash, const Thumbnail& thumbnail)>;
  /// `ready` is called in the thread of the window. This object and `jobs` may be destroyed in any
  /// order.
  ThumbnailMaker(Jobs& jobs, Ready ready);

  /// Requests thumbnails for the visible scenarios without one, in place of earlier requests.
  /// `size` as for make_thumbnail(); a batch that is being drawn may still have another one.
  void request(const std::string& list_path, std::vector<std::string> hashes,
               int size = kThumbnailSize);

  /// The number of requested thumbnails that are not ready.
  std::size_t pending_count() const { return requested_.size(); }

 private:
  void work();

  Jobs& jobs_;
  Ready ready_;
  std::string path_;
  int size_ = kThumbnailSize;
  std::vector<std::string> requested_;
  bool working_ = false;
  std::shared_ptr<ThumbnailMaker*> alive_;  ///< deliveries are dropped once it has expired
};

}  // namespace slalom
