// SPDX-License-Identifier: BSD-3-Clause
#include "worker_keeper.h"
#include "worker_limits.h"
#include "worker_main.h"

#include <slalom/core/error.h>
#include <slalom/workers/worker_sandbox.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

namespace slalom {
namespace {

struct Answer {
  char kind;
  std::string payload;
};

Answer execute(const WorkItem& item, std::size_t index, SharedTaskLog& log, FileDescriptor file,
               const FileReceiver& receive_file) {
  try {
    if (file) receive_file(index, file.number());
    file = FileDescriptor();
    return {kDone, item(index, log)};
  } catch (const std::bad_alloc&) {
    return {kOutOfMemory, "out of memory"};
  } catch (const std::exception& e) {
    return {kThrew, reason_of(e)};
  }
}

/// Each line arrives, also if the process dies. Output that is shown is that of `keep_stderr`,
/// since the program's own output may be data.
void print_to(int file, bool keep_stderr) {
  dup2(keep_stderr ? STDERR_FILENO : file, STDOUT_FILENO);
  if (!keep_stderr) dup2(file, STDERR_FILENO);
  close(file);
  static char buffer[BUFSIZ];  // another one, since lines are not ended in one that is in use
  std::setvbuf(stdout, buffer, _IOLBF, sizeof buffer);
}

/// A worker without its sandbox must not run a method.
void enter_sandbox(const std::string& scratch, std::vector<std::string> writable) {
  writable.push_back(scratch);
  setenv("TMPDIR", scratch.c_str(), 1);
  if (!confine_writing_to(writable)) _exit(EXIT_FAILURE);
}

}  // namespace

void serve_work_items(int socket, const WorkItem& item, const PoolOptions& options,
                      const FileReceiver& receive_file, SharedTaskLog& log) {
  // Interrupts are handled by the parent.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
  limit_memory(static_cast<std::size_t>(options.limits.memory_mb * 1024 * 1024));
  const pid_t self = getpid();
  Request request = {};
  FileDescriptor file;
  const SocketState connection(socket);
  while (receive_request(socket, request, file)) {
    limit_cpu_time(options.limits.item_cpu_time);
    const Answer answer = execute(item, request.index, log, std::move(file), receive_file);
    std::cout.flush();
    std::fflush(stdout);
    if (getpid() != self) return;  // a copy, made by a method that forked
    if (!connection.restore()) log.retire_worker();
    if (!send_answer(socket, request, answer.kind, answer.payload))
      return log.report_disconnected();
  }
  if (options.hooks.at_end) options.hooks.at_end();
}

void serve_confined(const WorkerStart& start, const WorkItem& item, const PoolOptions& options,
                    const FileReceiver& receive_file) {
  SharedTaskLog log(options.log_size, start.log.number());
  drop_descriptors(options.keep_stderr, start.socket.number(), start.output.number());
  print_to(start.output.number(), options.keep_stderr);
  if (options.limits.sandbox) enter_sandbox(start.scratch, options.limits.writable);
  if (!options.limits.network && !close_networks()) _exit(EXIT_FAILURE);
  serve_work_items(start.socket.number(), item, options, receive_file, log);
}

}  // namespace slalom
