// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/text.h>
#include <slalom/results/privileged.h>

namespace slalom {

void PrivilegedMethods::add(const std::string& method, bool uses_tracks, bool uses_map) {
  if (uses_tracks && !contains(tracks, method)) tracks.push_back(method);
  if (uses_map && !contains(map, method)) map.push_back(method);
}

void PrivilegedMethods::add(const PrivilegedMethods& others) {
  for (const std::string& name : others.tracks) add(name, true, false);
  for (const std::string& name : others.map) add(name, false, true);
}

std::vector<std::string> PrivilegedMethods::names() const {
  std::vector<std::string> result = tracks;
  for (const std::string& name : map)
    if (!contains(result, name)) result.push_back(name);
  return result;
}

PrivilegedMethods privileged_methods(const Manifest& manifest) {
  const auto names = [&](const char* key) {
    const auto found = manifest.find(key);
    return found == manifest.end() ? std::vector<std::string>() : split(found->second, ',');
  };
  return {names(kPrivilegedKey), names(kKnownMapKey)};
}

void store_privileged(const PrivilegedMethods& methods, Manifest& manifest) {
  if (!methods.tracks.empty()) manifest[kPrivilegedKey] = join(methods.tracks, ", ");
  if (!methods.map.empty()) manifest[kKnownMapKey] = join(methods.map, ", ");
}

std::string unmarked_name(const std::string& method) {
  return method.substr(0, method.size() - (ends_with(method, kPrivilegedMark) ? 1 : 0));
}

std::string privileged_footnote(const PrivilegedMethods& methods) {
  if (methods.empty()) return "";
  std::vector<std::string> parts;
  const auto add = [&](const std::vector<std::string>& names, const std::string& what) {
    if (!names.empty())
      parts.push_back(join(names, ", ") + (names.size() == 1 ? " is" : " are") + " given " + what);
  };
  add(methods.tracks, "the tracks of movers (positions, velocities, radii)");
  add(methods.map, "the map of static obstacles");
  return std::string(kPrivilegedMark) + " privileged: " + join(parts, "; ") +
         "; methods without the mark are not";
}

}  // namespace slalom
