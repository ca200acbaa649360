// SPDX-License-Identifier: BSD-3-Clause
// A method that moves straight ahead and does what `fault` names, once in each run, after one
// second.
#include <slalom/methods/slalom_method.h>

#include <array>
#include <cfenv>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>

namespace {

constexpr int kDescriptors = 64;  // more than a worker has

struct Method {
  std::string fault, file;
  bool done = false;
  double max_v = 0;
};

[[noreturn]] void live_on() {
  while (true) pause();
}

void spoil_signals() {
  for (const int signal : {SIGTERM, SIGINT, SIGSEGV, SIGCHLD, SIGALRM})
    std::signal(signal, SIG_IGN);
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_BLOCK, &all, nullptr);
  alarm(1);
}

void spoil_limits() {
  for (const auto resource : {RLIMIT_NOFILE, RLIMIT_FSIZE}) {
    const rlimit none = {3, 3};
    setrlimit(resource, &none);
  }
}

void start_daemon() {
  if (fork() != 0) return;
  setsid();
  if (fork() != 0) _exit(0);
  live_on();
}

void for_each_descriptor(void (*use)(int)) {
  for (int descriptor = 3; descriptor < kDescriptors; ++descriptor) use(descriptor);
}

/// An answer as the worker would send it, but not of the requested run; and what follows it.
void forge_answer(int descriptor) {
  const std::array<std::uint64_t, 4> answer = {1, 0, 0, 'D'};
  send(descriptor, answer.data(), sizeof answer, MSG_NOSIGNAL);
}

void write_garbage(int descriptor) {
  const std::array<char, 4096> garbage = {};
  if (write(descriptor, garbage.data(), garbage.size()) < 0) return;
}

void exhaust_memory() {
  while (void* block = std::malloc(std::size_t{16} << 20U))
    std::memset(block, 1, std::size_t{16} << 20U);
  std::abort();
}

/// Empties a file of somebody else, and removes it.
void destroy_file(const std::string& path) {
  const int file = open(path.c_str(), O_WRONLY | O_TRUNC);
  if (file >= 0) close(file);
  unlink(path.c_str());
}

void misbehave(const Method& method) {
  const std::string& fault = method.fault;
  if (fault == "rounding") std::fesetround(FE_UPWARD);
  if (fault == "signals") spoil_signals();
  if (fault == "limits") spoil_limits();
  if (fault == "thread") std::thread([] { live_on(); }).detach();
  if (fault == "late_crash")
    std::thread([] {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      std::abort();
    }).detach();
  if (fault == "daemon") start_daemon();
  if (fault == "clone" && syscall(SYS_clone, 0, nullptr, nullptr, nullptr, nullptr) == 0) live_on();
  if (fault == "kill_keeper") {
    start_daemon();
    kill(getppid(), SIGKILL);
    live_on();
  }
  if (fault == "nonblocking")
    for_each_descriptor([](int descriptor) { fcntl(descriptor, F_SETFL, O_NONBLOCK); });
  if (fault == "shut") for_each_descriptor([](int descriptor) { shutdown(descriptor, SHUT_RD); });
  if (fault == "kill_keeper_and_go_on") kill(getppid(), SIGKILL);
  if (fault == "close") for_each_descriptor([](int descriptor) { close(descriptor); });
  if (fault == "garbage") for_each_descriptor(write_garbage);
  if (fault == "forge") for_each_descriptor(forge_answer);
  if (fault == "returns_twice" && fork() < 0) std::abort();
  if (fault == "slow") std::this_thread::sleep_for(std::chrono::milliseconds(300));
  if (fault == "hang") live_on();
  if (fault == "crash") std::abort();
  if (fault == "exit") std::_Exit(0);
  if (fault == "kill") kill(getpid(), SIGKILL);
  if (fault == "kill_group") kill(0, SIGKILL);
  if (fault == "memory") exhaust_memory();
  if (fault == "destroy") destroy_file(method.file);
}

void* create(const slalom_setting* settings, size_t count, const slalom_robot* robot, char*,
             size_t) {
  auto* method = new Method;
  method->max_v = robot->max_v;
  for (size_t i = 0; i < count; ++i)
    (settings[i].key == std::string("fault") ? method->fault : method->file) = settings[i].value;
  return method;
}

int reset(void* method, const slalom_task*) {
  static_cast<Method*>(method)->done = false;
  return 0;
}

int step(void* state, const slalom_observation* observation, slalom_command* command) {
  auto& method = *static_cast<Method*>(state);
  if (observation->time >= 1 && !method.done) {
    method.done = true;
    misbehave(method);
  }
  *command = {0.1 * method.max_v, 0, 0};
  if (method.fault == "random") command->w = 1e-3 * (getpid() % 100);  // not reproducible
  return 0;
}

void destroy(void* method) {
  delete static_cast<Method*>(method);
}

constexpr slalom_parameter kParameters[] = {{"fault", "none", "-", "what it does wrong"},
                                            {"file", "", "-", "the file that it destroys"}};

}  // namespace

const slalom_method_api* slalom_method_get_api(void) {
  static const slalom_method_api api = {
      SLALOM_METHOD_ABI_VERSION, "faulty", kParameters, 2, create, reset, step, destroy};
  return &api;
}
