#pragma once

#include <slalom/results/result_table.h>

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

/// Puts the mark behind the names of those methods, so that all that is made of the table shows it.
/// Ids of runs, names of files and random streams have the names without it.
void mark_privileged(ResultTable& table, const PrivilegedMethods& methods);
/// The same as the manifest says. Nothing changes in a table with marks.
void mark_privileged(ResultTable& table);
/// The name as it is marked in the table; a name that is not in it stays.
std::string marked_name(const ResultTable& table, const std::string& method);

/// The footnote that explains the mark; "" without methods.
std::string privileged_footnote(const PrivilegedMethods& methods);
/// The same for a table with marks.
std::string privileged_footnote(const ResultTable& table);

}  // namespace slalom
