// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstring>
#include <net/if.h>
#include <net/route.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

namespace slalom {

/// Moves this process and its children into a network namespace with only a loopback device with
/// multicast: tests are isolated and need no network interface. To be called before any thread is
/// started. Returns false if the system does not permit it; nothing has changed then.
inline bool enter_private_network() {
  if (unshare(CLONE_NEWNET) != 0 && unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0) return false;
  const int control = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  ifreq loopback = {};
  std::strcpy(loopback.ifr_name, "lo");
  bool done = ioctl(control, SIOCGIFFLAGS, &loopback) == 0;
  loopback.ifr_flags = static_cast<short>(loopback.ifr_flags | IFF_UP | IFF_MULTICAST);
  done = done && ioctl(control, SIOCSIFFLAGS, &loopback) == 0;
  const auto address = [](in_addr_t value) {
    sockaddr_in in = {};
    in.sin_family = AF_INET;
    in.sin_addr.s_addr = htonl(value);
    sockaddr result = {};
    std::memcpy(&result, &in, sizeof result);
    return result;
  };
  rtentry route = {};
  route.rt_dst = address(0xE0000000);      // 224.0.0.0
  route.rt_genmask = address(0xF0000000);  // /4
  route.rt_flags = RTF_UP;
  route.rt_dev = loopback.ifr_name;
  done = done && ioctl(control, SIOCADDRT, &route) == 0;
  close(control);
  return done;
}

/// Whether a multicast message of this process is received by it.
inline bool has_multicast() {
  const int udp = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_ANY);
  socklen_t size = sizeof address;
  ip_mreq group = {};
  group.imr_multiaddr.s_addr = htonl(0xEFFF4C43);  // 239.255.76.67, LCM's
  const timeval timeout = {1, 0};
  const unsigned char ttl = 0;
  char received = 0;
  bool works = bind(udp, reinterpret_cast<sockaddr*>(&address), size) == 0 &&
               getsockname(udp, reinterpret_cast<sockaddr*>(&address), &size) == 0 &&
               setsockopt(udp, IPPROTO_IP, IP_ADD_MEMBERSHIP, &group, sizeof group) == 0 &&
               setsockopt(udp, IPPROTO_IP, IP_MULTICAST_TTL, &ttl, sizeof ttl) == 0 &&
               setsockopt(udp, SOL_SOCKET, SO_RCVTIMEO, &timeout, sizeof timeout) == 0;
  address.sin_addr = group.imr_multiaddr;
  works = works && sendto(udp, "x", 1, 0, reinterpret_cast<sockaddr*>(&address), size) == 1 &&
          recv(udp, &received, 1, 0) == 1;
  close(udp);
  return works;
}

}  // namespace slalom
