// SPDX-License-Identifier: BSD-3-Clause
#include "navigation_log.h"

#include <fmt/format.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>

#include <filesystem>
#include <stdexcept>

namespace slalom {
namespace {

using mrpt::nav::CAbstractPTGBasedReactive;
using mrpt::nav::CLogFileRecord;
using mrpt::nav::CParameterizedTrajectoryGenerator;

/// Copies the parameters without the large collision grids, which viewers compute themselves.
CParameterizedTrajectoryGenerator::Ptr parameters_of(const CParameterizedTrajectoryGenerator& ptg) {
  mrpt::io::CMemoryStream buffer;
  auto archive = mrpt::serialization::archiveFrom(buffer);
  archive << ptg;
  buffer.Seek(0);
  return archive.ReadObject<CParameterizedTrajectoryGenerator>();
}

/// The first record of a file contains the trajectory generators.
void add_generators(CLogFileRecord& record, CAbstractPTGBasedReactive& navigator) {
  const std::size_t count = navigator.getPTG_count();
  if (record.infoPerPTG.size() < count) record.infoPerPTG.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    record.infoPerPTG[i].ptg = parameters_of(*navigator.getPTG(i));
}

}  // namespace

NavigationLog::NavigationLog(std::string folder, std::string method)
    : folder_(std::move(folder)), method_(std::move(method)) {}

void NavigationLog::prepare() const {
  std::filesystem::create_directories(folder_);
}

void NavigationLog::start_run(const NavigationTask& task, CAbstractPTGBasedReactive& navigator) {
  path_ = fmt::format("{}/{}_{:016x}.reactivenavlog", folder_, method_, task.seed);
  std::filesystem::remove(path_);
  navigator.enableKeepLogRecords(true);
  is_first_ = true;
}

void NavigationLog::add(CAbstractPTGBasedReactive& navigator) {
  CLogFileRecord record;
  navigator.getLastLogRecord(record);
  const auto start_time = record.timestamps.find("tim_start_iteration");
  if (start_time == record.timestamps.end() || start_time->second == last_) return;
  last_ = start_time->second;
  if (is_first_) add_generators(record, navigator);
  is_first_ = false;
  // Each record is a separate gzip member; concatenated members form one file.
  mrpt::io::CFileGZOutputStream file(path_, mrpt::io::OpenMode::APPEND);
  mrpt::serialization::archiveFrom(file) << record;
}

}  // namespace slalom
