#include "worker_socket.h"

#include <cerrno>
#include <cstring>
#include <poll.h>
#include <sys/socket.h>
#include <sys/uio.h>

namespace slalom {
namespace {

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

/// A message with room for a descriptor.
class RequestMessage {
 public:
  explicit RequestMessage(Request& request) : part_{&request, sizeof request} {
    message_.msg_iov = &part_;
    message_.msg_iovlen = 1;
    message_.msg_control = control_;
    message_.msg_controllen = sizeof control_;
  }
  RequestMessage(const RequestMessage&) = delete;
  RequestMessage& operator=(const RequestMessage&) = delete;

  msghdr* get() { return &message_; }

  void put(int file) {
    cmsghdr* header = CMSG_FIRSTHDR(&message_);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(sizeof file);
    std::memcpy(CMSG_DATA(header), &file, sizeof file);
  }

  FileDescriptor received_file() {
    const cmsghdr* header = CMSG_FIRSTHDR(&message_);
    if (header == nullptr || header->cmsg_type != SCM_RIGHTS) return FileDescriptor();
    int file = -1;
    std::memcpy(&file, CMSG_DATA(header), sizeof file);
    return FileDescriptor(file);
  }

 private:
  iovec part_;
  msghdr message_ = {};
  alignas(cmsghdr) char control_[CMSG_SPACE(sizeof(int))] = {};
};

}  // namespace

void send_request(int socket, const Request& request, int file) {
  Request copy = request;
  RequestMessage message(copy);
  if (file >= 0) {
    message.put(file);
    if (sendmsg(socket, message.get(), MSG_NOSIGNAL) == sizeof request) return;
  }
  send_all(socket, reinterpret_cast<const char*>(&request), sizeof request);
}

bool receive_request(int socket, Request& request, FileDescriptor& file) {
  RequestMessage message(request);
  ssize_t got = 0;
  do {
    got = recvmsg(socket, message.get(), MSG_WAITALL | MSG_CMSG_CLOEXEC);
  } while (got < 0 && errno == EINTR);
  if (got <= 0) return false;
  file = message.received_file();
  return got == static_cast<ssize_t>(sizeof request);
}

bool send_answer(int socket, const Request& request, char kind, const std::string& payload) {
  const AnswerHeader header = {request, payload.size(), static_cast<unsigned char>(kind)};
  return send_all(socket, reinterpret_cast<const char*>(&header), sizeof header) &&
         send_all(socket, payload.data(), payload.size());
}

bool is_readable(int socket, int milliseconds) {
  pollfd event = {socket, POLLIN, 0};
  return poll(&event, 1, milliseconds) > 0;
}

Error cannot_create(const std::string& what, int error) {
  return job_error("workers", "cannot create a " + what + " (" + std::strerror(error) + ")");
}

SocketPair::SocketPair() {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw cannot_create("socket", errno);
  near_end = FileDescriptor(ends[0]);
  far_end = FileDescriptor(ends[1]);
}

}  // namespace slalom
