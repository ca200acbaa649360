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

/// Each line arrives, also if the process dies.
void print_lines() {
  static char buffer[BUFSIZ];  // another one, since lines are not ended in one that is in use
  std::setvbuf(stdout, buffer, _IOLBF, sizeof buffer);
}

void print_to(int file) {
  dup2(file, STDOUT_FILENO);
  dup2(file, STDERR_FILENO);
}

/// A worker without its sandbox must not run a method.
void enter_sandbox(const std::string& scratch, std::vector<std::string> writable) {
  writable.push_back(scratch);
  setenv("TMPDIR", scratch.c_str(), 1);
  if (!confine_writing_to(writable)) _exit(EXIT_FAILURE);
}

}  // namespace

void serve_work_items(int socket, const WorkItem& item, const PoolOptions& options,
                      const FileReceiver& receive_file, const WorkerChannel (&channels)[2]) {
  // Interrupts are handled by the parent.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
  limit_memory(static_cast<std::size_t>(options.limits.memory_mb * 1024 * 1024));
  const pid_t self = getpid();
  Request request = {};
  FileDescriptor file;
  const SocketState connection(socket);
  for (std::size_t count = 1; receive_request(socket, request, file); ++count) {
    const WorkerChannel& channel = channels[count % 2];
    SharedTaskLog& log = *channel.log;
    if (channel.output >= 0) print_to(channel.output);
    limit_cpu_time(options.limits.item_cpu_time);
    const Answer answer = execute(item, request.index, log, std::move(file), receive_file);
    std::cout.flush();
    std::fflush(stdout);
    if (getpid() != self) return;  // a copy, made by a method that forked
    if (!connection.restore()) log.retire_worker();
    if (!send_answer(socket, request, answer.kind, answer.payload))
      return log.report_disconnected();
    while (log.is_retired()) pause();  // until this process is killed
  }
  if (options.hooks.at_end) options.hooks.at_end();
}

void serve_confined(const WorkerStart& start, const WorkItem& item, const PoolOptions& options,
                    const FileReceiver& receive_file) {
  WorkerChannel channels[2];
  for (int i : {0, 1}) {
    channels[i].log = std::make_unique<SharedTaskLog>(options.log_size, start.logs[i].number());
    if (!options.keep_stderr) channels[i].output = start.outputs[i].number();
  }
  drop_descriptors(options.keep_stderr,
                   {start.socket.number(), start.outputs[0].number(), start.outputs[1].number()});
  // The program's own standard output may be data.
  print_to(options.keep_stderr ? STDERR_FILENO : start.outputs[1].number());
  print_lines();
  if (options.limits.sandbox) enter_sandbox(start.scratch, options.limits.writable);
  if (!options.limits.network && !close_networks()) _exit(EXIT_FAILURE);
  serve_work_items(start.socket.number(), item, options, receive_file, channels);
}

}  // namespace slalom
