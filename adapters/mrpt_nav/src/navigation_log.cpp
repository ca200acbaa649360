#include "navigation_log.h"

#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>

#include <filesystem>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace slalom {
namespace {

using mrpt::nav::CAbstractPTGBasedReactive;
using mrpt::nav::CLogFileRecord;
using mrpt::nav::CParameterizedTrajectoryGenerator;

std::string as_hex(std::uint64_t number) {
  std::ostringstream text;
  text << std::hex << std::setfill('0') << std::setw(16) << number;
  return text.str();
}

/// A copy by its parameters, without the heavy grids: viewers build those themselves.
CParameterizedTrajectoryGenerator::Ptr parameters_of(const CParameterizedTrajectoryGenerator& ptg) {
  mrpt::io::CMemoryStream buffer;
  auto archive = mrpt::serialization::archiveFrom(buffer);
  archive << ptg;
  buffer.Seek(0);
  return archive.ReadObject<CParameterizedTrajectoryGenerator>();
}

/// The first record of a file tells the trajectory generators.
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

void NavigationLog::start_run(const Task& task, CAbstractPTGBasedReactive& navigator) {
  path_ = folder_ + "/" + method_ + "_" + as_hex(task.seed) + ".reactivenavlog";
  std::filesystem::remove(path_);
  navigator.enableKeepLogRecords(true);
  is_first_ = true;
}

void NavigationLog::add(CAbstractPTGBasedReactive& navigator) {
  CLogFileRecord record;
  navigator.getLastLogRecord(record);
  const auto begun = record.timestamps.find("tim_start_iteration");
  if (begun == record.timestamps.end() || begun->second == last_) return;
  last_ = begun->second;
  if (is_first_) add_generators(record, navigator);
  is_first_ = false;
  // Each record is a compressed block of its own, and blocks in a row are one file.
  mrpt::io::CFileGZOutputStream file(path_, mrpt::io::OpenMode::APPEND);
  mrpt::serialization::archiveFrom(file) << record;
}

}  // namespace slalom
