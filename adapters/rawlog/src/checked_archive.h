#pragma once

#include <mrpt/serialization/CArchive.h>

#include <cstdint>
#include <string>

namespace slalom {

/// Reads MRPT objects from bytes in memory. MRPT takes memory for as many rays as a scan claims to
/// have before it reads them, and does not survive where there is none: here a scan that claims
/// more rays than bytes are left is refused by a std::runtime_error first.
class CheckedArchive : public mrpt::serialization::CArchive {
 public:
  explicit CheckedArchive(const std::string& bytes) : bytes_(bytes) {}

  /// Why the archive itself refused to go on (MRPT hides that); "" otherwise.
  const std::string& refusal() const { return refusal_; }
  bool at_end() const { return position_ >= bytes_.size(); }
  std::string getArchiveDescription() const override { return "bytes of a rawlog"; }

 protected:
  std::size_t read(void* to, std::size_t size) override;
  std::size_t write(const void* from, std::size_t size) override;

 private:
  /// Where within a scan the reader is: its count of rays is the first number of four bytes, behind
  /// the name of its pose, by which many ranges are then read.
  enum class Place { Elsewhere, InScan, BehindPose };

  void look_at(const char* data, std::size_t size);

  const std::string& bytes_;
  std::size_t position_ = 0;
  Place place_ = Place::Elsewhere;
  std::uint32_t last_count_ = 0;
  std::string refusal_;
};

}  // namespace slalom
