#pragma once

#include "file_descriptor.h"

#include <slalom/core/error.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace slalom {

/// What the parent asks a worker to do. The random number is in the answer, so that only the answer
/// to this request is taken for it.
struct Request {
  std::uint64_t nonce, index;
};

struct AnswerHeader {
  Request request;
  std::uint64_t size;  ///< of the payload that follows
  std::uint64_t kind;
};

constexpr char kDone = 'D';
constexpr char kThrew = 'E';
constexpr char kOutOfMemory = 'M';

/// Sends a request and with it a descriptor, unless it is -1 or the system does not allow it.
void send_request(int socket, const Request& request, int file);

/// Waits for a request and the descriptor that was sent with it. False when the connection ends.
bool receive_request(int socket, Request& request, FileDescriptor& file);

/// False when the connection has ended.
bool send_answer(int socket, const Request& request, char kind, const std::string& payload);

bool is_readable(int socket, int milliseconds);

/// Of a process or socket, with the system's reason.
Error cannot_create(const std::string& what, int error);

/// Two connected sockets.
struct SocketPair {
  SocketPair();  ///< throws Error (Job)
  FileDescriptor near_end, far_end;
};

}  // namespace slalom
