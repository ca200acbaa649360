// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace slalom {

/// A DDS domain of this machine that one worker of Slalom uses. There is one implementation file
/// per operating system.
class RosDomain {
 public:
  /// The first domain from `first` to `last` that neither a worker of Slalom nor another program of
  /// this machine uses; nothing if there is none.
  static std::optional<RosDomain> find_free(int first, int last);
  /// This domain, which other programs use; nothing if a worker of Slalom uses it.
  static std::optional<RosDomain> share(int id);

  RosDomain(RosDomain&& other) noexcept;
  RosDomain& operator=(RosDomain&& other) = delete;
  ~RosDomain();

  int id() const { return id_; }

 private:
  RosDomain(int id, int lock) : id_(id), lock_(lock) {}

  int id_;
  int lock_;  ///< a socket whose name one process can have
};

}  // namespace slalom
