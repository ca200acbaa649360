// SPDX-License-Identifier: BSD-3-Clause
#include "checked_archive.h"
#include "gzip.h"
#include "memory_guard.h"
#include "rawlog_objects.h"

#include <slalom/bags/bag.h>
#include <slalom/core/error.h>
#include <slalom/core/file_format.h>
#include <slalom/core/read_file.h>
#include <slalom/rawlog/log_objects.h>

#include <mrpt/obs/CRawlog.h>

#include <new>

namespace slalom {
namespace {

using mrpt::serialization::CSerializable;
using Objects = std::vector<CSerializable::Ptr>;

constexpr std::size_t kMaxLogSize = 2000 * kMegabyte;  ///< of an uncompressed log, bytes

std::string content_of(const std::string& path) {
  std::string content = gunzip(read_file(path, "a rawlog", kMaxLogSize), kMaxLogSize, path);
  if (content.empty()) throw file_error(path, "is empty", "a rawlog");
  refuse_foreign_format(content, path, "a recorded run", false);
  return content;
}

void add(Objects& objects, const CSerializable::Ptr& object) {
  const auto log = std::dynamic_pointer_cast<mrpt::obs::CRawlog>(object);
  if (!log) return objects.push_back(object);
  for (std::size_t i = 0; i < log->size(); ++i) objects.push_back(log->getAsGeneric(i));
}

}  // namespace

LogObjects load_log(const std::string& path, const BagSelection& selection) {
  if (is_bag(path)) return import_bag(path, selection);
  if (!selection.is_default())
    throw usage_error(path, "is not a bag, whose topics and frames can be chosen",
                      "no --scan, --odom, --command and --base, or a bag of ROS");
  return {path, read_objects(path), {}};
}

Objects read_objects(const std::string& path) {
  const std::string content = content_of(path);
  CheckedArchive archive(content);
  // Objects need more memory than in the file; tens of times more only if a count is corrupt.
  constexpr std::size_t kFactor = 16, kMinAllowance = std::size_t(64) << 20;
  const MemoryGuard guard(kMinAllowance + kFactor * content.size());
  Objects objects;
  const auto where = [&] { return path + ": object " + std::to_string(objects.size() + 1); };
  while (!archive.at_end()) try {
      add(objects, archive.ReadObject());
    } catch (const std::bad_alloc&) {
      throw file_error(where(), "requires more memory than expected of a log of this size",
                       "a rawlog");
    } catch (const std::exception& error) {
      const std::string reason = archive.error().empty() ? reason_of(error) : archive.error();
      throw file_error(where(), "cannot be read (" + reason + ")", "a complete rawlog");
    }
  return objects;
}

}  // namespace slalom
