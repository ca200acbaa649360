// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/hash.h>
#include <slalom/io/list_hash.h>

#include <algorithm>

namespace slalom {

std::string content_hash(const ScenarioList& list) {
  std::vector<std::string> hashes;
  list.for_each({}, [&](const ScenarioList::Entry& entry) {
    hashes.push_back(entry.hash);
    return true;
  });
  return content_hash(std::move(hashes));
}

std::string content_hash(std::vector<std::string> hashes) {
  std::sort(hashes.begin(), hashes.end());
  Hasher hasher;
  hasher.add(static_cast<std::uint64_t>(hashes.size()));
  for (const std::string& hash : hashes) hasher.add(hash);
  return hasher.hex();
}

}  // namespace slalom
