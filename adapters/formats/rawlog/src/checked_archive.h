// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/serialization/CArchive.h>

#include <cstdint>
#include <string>

namespace slalom {

/// Reads MRPT objects from bytes in memory. MRPT allocates memory for the ray count of a scan
/// before it reads the rays, and crashes if the allocation fails: this class throws
/// std::runtime_error first if a scan has more rays than bytes are left.
class CheckedArchive : public mrpt::serialization::CArchive {
 public:
  explicit CheckedArchive(const std::string& bytes) : bytes_(bytes) {}

  /// The error thrown by this class (MRPT hides it); "" if there was none.
  const std::string& error() const { return error_; }
  bool at_end() const { return position_ >= bytes_.size(); }
  std::string getArchiveDescription() const override { return "bytes of a rawlog"; }

 protected:
  std::size_t read(void* to, std::size_t size) override;
  std::size_t write(const void* from, std::size_t size) override;

 private:
  /// The position within a scan: the ray count is the first number of four bytes after the class
  /// name of the pose that is followed by a read of that many ranges.
  enum class State { Outside, InScan, AfterPose };

  void inspect(const char* data, std::size_t size);

  const std::string& bytes_;
  std::size_t position_ = 0;
  State state_ = State::Outside;
  std::uint32_t last_count_ = 0;
  std::string error_;
};

}  // namespace slalom
