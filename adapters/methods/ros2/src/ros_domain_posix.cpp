// SPDX-License-Identifier: BSD-3-Clause
#include "ros_domain.h"

#include <cstddef>
#include <cstring>
#include <netinet/in.h>
#include <string>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#include <utility>

namespace slalom {
namespace {

constexpr int kMaxParticipants = 33;  // that are found on one machine

/// Returns a socket with this name, or -1 if there is one: its scope is the network namespace, as
/// that of domains, and the system removes it with the process.
int lock_domain(int id) {
  const int lock = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (lock < 0) return -1;
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string name = "slalom_ros2_domain_" + std::to_string(id);
  std::memcpy(&address.sun_path[1], name.data(), name.size());  // a leading 0: not a file
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  if (bind(lock, reinterpret_cast<const sockaddr*>(&address), size) == 0) return lock;
  close(lock);
  return -1;
}

/// Whether a port of the participants of a domain is in use (RTPS 2.5, section 9.6.1.4).
bool has_participant(int id) {
  bool used = false;
  for (int participant = 0; participant < kMaxParticipants && !used; ++participant) {
    const int probe = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_ANY);
    address.sin_port = htons(static_cast<std::uint16_t>(7400 + 250 * id + 10 + 2 * participant));
    used = bind(probe, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0;
    close(probe);
  }
  return used;
}

}  // namespace

std::optional<RosDomain> RosDomain::find_free(int first, int last) {
  for (int id = first; id <= last; ++id) {
    if (has_participant(id)) continue;
    if (auto domain = share(id)) return domain;
  }
  return std::nullopt;
}

std::optional<RosDomain> RosDomain::share(int id) {
  const int lock = lock_domain(id);
  if (lock < 0) return std::nullopt;
  return RosDomain(id, lock);
}

RosDomain::RosDomain(RosDomain&& other) noexcept
    : id_(other.id_), lock_(std::exchange(other.lock_, -1)) {}

RosDomain::~RosDomain() {
  if (lock_ >= 0) close(lock_);
}

}  // namespace slalom
