#include "checked_archive.h"
#include "gzip.h"
#include "memory_guard.h"
#include "rawlog_objects.h"

#include <slalom/core/error.h>
#include <slalom/io/result_file.h>

#include <mrpt/obs/CRawlog.h>

#include <filesystem>
#include <new>

namespace slalom {
namespace {

using mrpt::serialization::CSerializable;
using Objects = std::vector<CSerializable::Ptr>;

constexpr std::size_t kLargest = std::size_t(2) << 30;  ///< bytes of a log, uncompressed

std::string content_of(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) throw file_error(path, "cannot be read");
  if (std::filesystem::file_size(path, error) > kLargest || error)
    throw file_error(path, "is too large", "a rawlog of at most 2 GiB");
  std::string content = gunzip(read_file(path), kLargest, path);
  if (content.empty()) throw file_error(path, "is empty", "a rawlog");
  return content;
}

void add(Objects& objects, const CSerializable::Ptr& object) {
  const auto log = std::dynamic_pointer_cast<mrpt::obs::CRawlog>(object);
  if (!log) return objects.push_back(object);
  for (std::size_t i = 0; i < log->size(); ++i) objects.push_back(log->getAsGeneric(i));
}

}  // namespace

Objects read_objects(const std::string& path) {
  const std::string content = content_of(path);
  CheckedArchive archive(content);
  // Objects take more than their bytes in the file; tens of times more only when a count is wrong.
  constexpr std::size_t kShare = 16, kAtLeast = std::size_t(64) << 20;
  const MemoryGuard guard(kAtLeast + kShare * content.size());
  Objects objects;
  const auto where = [&] { return path + ": object " + std::to_string(objects.size() + 1); };
  while (!archive.at_end()) try {
      add(objects, archive.ReadObject());
    } catch (const std::bad_alloc&) {
      throw file_error(where(), "asks for more memory than a log of this size needs", "a rawlog");
    } catch (const std::exception& error) {
      const std::string reason = archive.refusal().empty() ? reason_of(error) : archive.refusal();
      throw file_error(where(), "cannot be read (" + reason + ")", "a whole rawlog");
    }
  return objects;
}

}  // namespace slalom
