// SPDX-License-Identifier: BSD-3-Clause
#include "figure_file.h"

#include <slalom/core/error.h>
#include <slalom/core/temporary_file.h>
#include <slalom/core/text.h>
#include <slalom/io/result_file.h>

#include <array>
#include <cerrno>
#include <spawn.h>
#include <sys/wait.h>

namespace slalom {
namespace {

/// The exit status of rsvg-convert, or -1 if it was not started or did not exit.
int convert(const std::string& format, std::string svg, std::string output) {
  std::array<std::string, 5> words = {"rsvg-convert", "--format=" + format, "--output",
                                      std::move(output), std::move(svg)};
  std::array<char*, 6> arguments{};
  for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
  pid_t child = 0;
  if (posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0)
    return -1;
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

void write_figure(const std::string& svg, const std::string& path) {
  if (ends_with(path, ".svg")) return write_file_atomically(path, svg);
  const std::string format = ends_with(path, ".pdf") ? "pdf" : ends_with(path, ".png") ? "png" : "";
  if (format.empty()) throw usage_error("--output", "unknown format", ".svg, .pdf or .png");
  const TemporaryFile source(path, ".svg");
  write_file_atomically(source.name(), svg);
  TemporaryFile converted(path, "." + format);
  if (convert(format, source.name(), converted.name()) != 0)
    throw job_error(path, "rsvg-convert cannot be started or failed", "the package librsvg2-bin");
  converted.publish();
}

}  // namespace slalom
