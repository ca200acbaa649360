// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/testbeds.h>

#include <map>

namespace slalom {

std::string testbed_of(const std::string& content_hash) {
  static const std::map<std::string, std::string> names = {
      {"04203288f4478c5641527e24e4f2f53f", "slalom-small"},
      {"6934782a5776f93e3c050b26f5253d54", "slalom-standard"},
      {"d71632dc42d49be706b307f587fda453", "slalom-hard"},
      {"781fc195933be852b9d74276e5446500", "slalom-rectangle"},
      {"474415ec00c67a72a8732242617f91bc", "slalom-dynamic-small"},
      {"85b9a6e83713cdb1b9bf4d92d961e5b0", "slalom-dynamic-standard"},
      {"776314bdffac0b913dc5f10a7eb14cfa", "slalom-people-small"},
      {"4dc9724b1c3316d9b941b2fad327a0dd", "slalom-people-standard"},
      {"7407b798ba54561489bd6a2a3a3c3145", "crowdnav-500"},
  };
  const auto found = names.find(content_hash);
  return found == names.end() ? "" : found->second;
}

}  // namespace slalom
