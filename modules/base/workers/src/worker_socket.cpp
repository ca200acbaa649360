// SPDX-License-Identifier: BSD-3-Clause
#include "worker_socket.h"

#include <cerrno>
#include <climits>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/uio.h>
#include <utility>
#include <vector>

namespace slalom {
namespace {

constexpr char kReply = '?';  // other messages are paths with the zero at their end

bool send_all(int socket, const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t sent = send(socket, data, size, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    data += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}

/// A message with room for descriptors.
class Message {
 public:
  Message(void* data, std::size_t size) : part_{data, size} {
    message_.msg_iov = &part_;
    message_.msg_iovlen = 1;
  }
  Message(const Message&) = delete;
  Message& operator=(const Message&) = delete;

  /// False unless all was sent.
  template <std::size_t N>
  bool send(int socket, const int (&files)[N]) {
    static_assert(N <= kMaxFiles);
    message_.msg_control = control_;
    message_.msg_controllen = CMSG_SPACE(sizeof files);
    cmsghdr* header = CMSG_FIRSTHDR(&message_);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(sizeof files);
    std::memcpy(CMSG_DATA(header), files, sizeof files);
    return sendmsg(socket, &message_, MSG_NOSIGNAL) == static_cast<ssize_t>(part_.iov_len);
  }

  /// The number of bytes; less than one when the connection has ended.
  ssize_t receive(int socket, int flags) {
    message_.msg_control = control_;
    message_.msg_controllen = sizeof control_;
    ssize_t got = 0;
    do {
      got = recvmsg(socket, &message_, flags | MSG_CMSG_CLOEXEC);
    } while (got < 0 && errno == EINTR);
    return got;
  }

  std::vector<FileDescriptor> received_files() {
    std::vector<FileDescriptor> files;
    const cmsghdr* header = CMSG_FIRSTHDR(&message_);
    if (header == nullptr || header->cmsg_type != SCM_RIGHTS) return files;
    const std::size_t count = (header->cmsg_len - CMSG_LEN(0)) / sizeof(int);
    for (std::size_t i = 0; i < count; ++i) {
      int file = -1;
      std::memcpy(&file, CMSG_DATA(header) + i * sizeof file, sizeof file);
      files.emplace_back(file);
    }
    return files;
  }

 private:
  static constexpr std::size_t kMaxFiles = 6;

  iovec part_;
  msghdr message_ = {};
  alignas(cmsghdr) char control_[CMSG_SPACE(kMaxFiles * sizeof(int))] = {};
};

}  // namespace

void send_request(int socket, const Request& request, int file) {
  Request copy = request;
  if (file >= 0 && Message(&copy, sizeof copy).send(socket, {file})) return;
  send_all(socket, reinterpret_cast<const char*>(&request), sizeof request);
}

bool receive_request(int socket, Request& request, FileDescriptor& file) {
  Message message(&request, sizeof request);
  if (message.receive(socket, MSG_WAITALL) != static_cast<ssize_t>(sizeof request)) return false;
  std::vector<FileDescriptor> files = message.received_files();
  file = files.empty() ? FileDescriptor() : std::move(files.front());
  return true;
}

bool send_start(int socket, const WorkerStart& start) {
  std::string path = start.scratch;
  const int files[] = {start.socket.number(),     start.control.number(),
                       start.logs[0].number(),    start.logs[1].number(),
                       start.outputs[0].number(), start.outputs[1].number()};
  return Message(path.data(), path.size() + 1).send(socket, files);  // with the zero at its end
}

KeeperRequest receive_keeper_request(int socket, WorkerStart& start) {
  char path[PATH_MAX] = {};
  Message message(path, sizeof path);
  const ssize_t size = message.receive(socket, 0);
  if (size < 1) return KeeperRequest::End;
  if (size == sizeof kReply && path[0] == kReply) return KeeperRequest::Reply;
  std::vector<FileDescriptor> files = message.received_files();
  if (files.size() != 6) return KeeperRequest::Broken;  // this process may not have as many
  start = {std::move(files[0]),
           std::move(files[1]),
           {std::move(files[2]), std::move(files[3])},
           {std::move(files[4]), std::move(files[5])},
           path};
  return KeeperRequest::Start;
}

bool send_reply_request(int socket) {
  return send_all(socket, &kReply, sizeof kReply);
}

bool send_answer(int socket, const Request& request, char kind, const std::string& payload) {
  const AnswerHeader header = {request, payload.size(), static_cast<unsigned char>(kind)};
  std::string message(reinterpret_cast<const char*>(&header), sizeof header);
  message += payload;  // sent at once: the parent wakes up once
  return send_all(socket, message.data(), message.size());
}

bool is_readable(int socket, int milliseconds) {
  pollfd event = {socket, POLLIN, 0};
  return poll(&event, 1, milliseconds) > 0;
}

SocketState::SocketState(int socket)
    : socket_(socket), flags_(fcntl(socket, F_GETFL)), options_(options()) {}

std::vector<std::string> SocketState::options() const {
  std::vector<std::string> values;
  for (const int option : {SO_RCVTIMEO, SO_SNDTIMEO, SO_RCVLOWAT, SO_RCVBUF, SO_SNDBUF, SO_PASSCRED,
                           SO_PASSSEC, SO_PEEK_OFF}) {
    char value[sizeof(timeval)] = {};
    socklen_t size = sizeof value;
    getsockopt(socket_, SOL_SOCKET, option, value, &size);
    values.emplace_back(value, size);
  }
  return values;
}

bool SocketState::restore() const {
  pollfd shut = {socket_, POLLRDHUP, 0};
  const bool changed =
      fcntl(socket_, F_GETFL) != flags_ || options() != options_ || poll(&shut, 1, 0) != 0;
  if (!changed) return true;
  const timeval unlimited = {};
  fcntl(socket_, F_SETFL, flags_);
  setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &unlimited, sizeof unlimited);
  return false;
}

Error cannot_create(const std::string& what, int error) {
  return job_error("workers", "cannot create a " + what + " (" + std::strerror(error) + ")");
}

SocketPair::SocketPair(int type) {
  int ends[2];
  if (socketpair(AF_UNIX, type | SOCK_CLOEXEC, 0, ends) != 0) throw cannot_create("socket", errno);
  near_end = FileDescriptor(ends[0]);
  far_end = FileDescriptor(ends[1]);
}

}  // namespace slalom
