#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/generation/generator.h>
#include <slalom/generation/random_generator.h>

#include <algorithm>

namespace slalom {
namespace {

struct Family {
  const char* name;
  std::unique_ptr<Generator> (*make)(const IniFile& ini);
};

/// All families: the one list to add a line to.
constexpr Family kFamilies[] = {
    {"random", make_random_generator},
};

}  // namespace

std::vector<std::string> generator_names() {
  std::vector<std::string> names;
  for (const Family& family : kFamilies) names.emplace_back(family.name);
  return names;
}

std::unique_ptr<Generator> make_generator(const std::string& name, const IniFile& ini) {
  for (const Family& family : kFamilies)
    if (name == family.name) return family.make(ini);
  const std::vector<std::string> names = generator_names();
  const std::string nearest = nearest_name(name, names);
  throw usage_error(ini.name(), "unknown generator '" + name + "'",
                    nearest.empty() ? "one of " + join(names, ", ") : "'" + nearest + "'");
}

}  // namespace slalom
