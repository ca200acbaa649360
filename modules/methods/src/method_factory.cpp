#include <slalom/methods/method_factory.h>

namespace slalom {

OptionLocation location_in(const IniFile& ini, const std::string& section) {
  return [ini, section](const std::string& key) {
    return key.empty() ? ini.where(section) : ini.where(section, key);
  };
}

OptionLocation location_of(const std::string& maker) {
  return [maker](const std::string& key) { return key.empty() ? maker : maker + "." + key; };
}

}  // namespace slalom
