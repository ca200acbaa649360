// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/results/run_record.h>

#include <string>
#include <vector>

namespace slalom {

/// Manifest keys of the methods that were given the tracks of movers and the map of static
/// obstacles, comma-separated; absent if there are none.
constexpr const char* kPrivilegedKey = "methods.privileged";
constexpr const char* kKnownMapKey = "methods.known_map";

/// The methods that were given more than their sensors measure.
struct PrivilegedMethods {
  std::vector<std::string> tracks;  ///< were given the tracks of movers
  std::vector<std::string> map;     ///< were given the map of static obstacles

  void add(const std::string& method, bool uses_tracks, bool uses_map);  ///< unless it is there
  void add(const PrivilegedMethods& others);
  std::vector<std::string> names() const;  ///< of both, each once
  bool empty() const { return tracks.empty() && map.empty(); }
};

PrivilegedMethods privileged_methods(const Manifest& manifest);
void store_privileged(const PrivilegedMethods& methods, Manifest& manifest);

/// The mark behind the names of privileged methods where they are shown beside others, see
/// mark_privileged(). Names of methods in a campaign do not contain it.
constexpr const char* kPrivilegedMark = "*";
/// The name without the mark.
std::string unmarked_name(const std::string& method);

/// The footnote that explains the mark; "" without methods.
std::string privileged_footnote(const PrivilegedMethods& methods);

}  // namespace slalom
