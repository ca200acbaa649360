// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/results/recorded_ini.h>

namespace slalom {

IniFile recorded_ini(const Manifest& manifest, const std::string& origin) {
  const auto text = manifest.find("campaign.ini");
  return IniFile::from_text(text == manifest.end() ? "" : text->second, origin);
}

}  // namespace slalom
