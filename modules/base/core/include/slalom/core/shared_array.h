// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace slalom {

/// A read-only array in memory that belongs to a vector or to something else, such as a mapping
/// that is shared with other processes. Copies share the memory.
template <typename T>
class SharedArray {
 public:
  SharedArray() = default;
  explicit SharedArray(std::vector<T>&& elements) {
    const auto owner = std::make_shared<const std::vector<T>>(std::move(elements));
    data_ = {owner, owner->data()};
    size_ = owner->size();
  }
  /// `data` keeps the memory of `size` elements alive.
  SharedArray(std::shared_ptr<const T> data, std::size_t size)
      : data_(std::move(data)), size_(size) {}

  const T* data() const { return data_.get(); }
  const std::shared_ptr<const T>& owner() const { return data_; }  ///< keeps the memory alive
  std::size_t size() const { return size_; }
  const T& operator[](std::size_t i) const { return data()[i]; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }

 private:
  std::shared_ptr<const T> data_;
  std::size_t size_ = 0;
};

}  // namespace slalom
