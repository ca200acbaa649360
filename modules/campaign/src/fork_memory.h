#pragma once

#include <cstddef>

namespace slalom {

/// The large memory of a process that forks, such as that of a long scenario list. In huge pages
/// fork() copies it in no time; the page tables of pages of 4 KiB take it 9 ms for 100 MB.
class ForkMemory {
 public:
  static constexpr std::size_t kStep = std::size_t{32} << 20;  ///< bytes

  /// Puts large memory of this process into huge pages if there are kStep bytes in small ones.
  /// Looks at it in the first call, and when the process has grown by kStep since it last did.
  /// Contents and addresses stay. Without effect where the kernel cannot do it on request (before
  /// Linux 6.1). Returns whether it tried.
  bool collapse();

 private:
  std::size_t known_ = 0;  ///< bytes of the process when it last looked
};

}  // namespace slalom
