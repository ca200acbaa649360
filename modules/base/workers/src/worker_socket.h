// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "file_descriptor.h"

#include <slalom/core/error.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <sys/socket.h>
#include <vector>

namespace slalom {

/// Request of the parent to a worker. The answer repeats the random number, so that no other answer
/// is taken for it.
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

/// File descriptors that a worker is started with. The worker keeps its end of the socket, and
/// those of its outputs. Its work items use the two logs and outputs by turns.
struct WorkerStart {
  FileDescriptor socket;                  ///< to the process that starts it
  FileDescriptor control;                 ///< for its keeper: see WorkerKeeper::start_worker()
  std::array<FileDescriptor, 2> logs;     ///< of SharedTaskLog::make_file()
  std::array<FileDescriptor, 2> outputs;  ///< of pipes: its standard output and error
  std::string scratch;                    ///< a folder of its own; "" if it has none
};

/// Sends a request and with it a descriptor, unless it is -1 or the system does not allow it.
void send_request(int socket, const Request& request, int file);

/// Waits for a request and the descriptor that was sent with it. False when the connection ends.
bool receive_request(int socket, Request& request, FileDescriptor& file);

/// A request to a keeper, one message of its connection.
enum class KeeperRequest { Start, Reply, End, Broken };

/// False when the connection has ended.
bool send_start(int socket, const WorkerStart& start);
/// Start with what it is to start, End when the connection has ended, or Broken if this process
/// could not receive all descriptors.
KeeperRequest receive_keeper_request(int socket, WorkerStart& start);

/// Asks a keeper for a reply, and sends it. False when the connection has ended.
bool send_reply_request(int socket);

/// False when the connection has ended.
bool send_answer(int socket, const Request& request, char kind, const std::string& payload);

bool is_readable(int socket, int milliseconds);

/// The state of a connection that the method of its worker can change.
class SocketState {
 public:
  explicit SocketState(int socket);  ///< the current state

  /// Restores what an answer needs. False if anything had changed: the process is to be replaced.
  bool restore() const;

 private:
  std::vector<std::string> options() const;

  int socket_, flags_;
  std::vector<std::string> options_;
};

/// Error about a process or socket, with the system's reason.
Error cannot_create(const std::string& what, int error);

/// Two connected sockets.
struct SocketPair {
  explicit SocketPair(int type = SOCK_STREAM);  ///< throws Error (Job)
  FileDescriptor near_end, far_end;
};

}  // namespace slalom
