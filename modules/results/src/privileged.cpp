#include <slalom/core/text.h>
#include <slalom/results/privileged.h>

namespace slalom {
namespace {

/// Whether a name that ends or begins beside this character is only a part of a longer one.
bool continues_name(char c) {
  const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  return letter || c == '_' || c == '+' || c == '-' || c == '/';
}

/// A dot ends a sentence, or is part of a name.
bool ends_at(const std::string& text, std::size_t end) {
  if (end == text.size()) return true;
  if (text[end] == '.') return end + 1 == text.size() || !continues_name(text[end + 1]);
  return !continues_name(text[end]) && text[end] != kPrivilegedMark[0];
}

bool begins_at(const std::string& text, std::size_t begin) {
  return begin == 0 || (!continues_name(text[begin - 1]) && text[begin - 1] != '.');
}

}  // namespace

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

std::string with_privileged_marks(const std::string& text, const std::vector<std::string>& names) {
  std::string marked = text;
  for (const std::string& name : names) {
    std::size_t at = name.empty() ? std::string::npos : marked.find(name);
    for (; at != std::string::npos; at = marked.find(name, at)) {
      const std::size_t end = at + name.size();
      const bool is_word = begins_at(marked, at) && ends_at(marked, end);
      if (is_word) marked.insert(end, kPrivilegedMark);
      at = end;
    }
  }
  return marked;
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
