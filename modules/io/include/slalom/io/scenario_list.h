#pragma once

#include <slalom/descriptors/descriptor_cache.h>
#include <slalom/scenario/scenario.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Where a scenario came from, as far as known, and the tags it is to carry.
struct ScenarioOrigin {
  std::string generator;  ///< family; empty where unknown
  std::optional<std::uint64_t> seed;
  std::vector<std::string> tags;
};

/// A scenario list on disk (.scenarios): one SQLite file with scenarios in order and cached
/// descriptor values. Writes are transactions: the file is whole whenever the program is killed.
/// Everything read is checked; errors are Error (File) with file and reason.
class ScenarioList : public DescriptorStore {
 public:
  struct Impl;  ///< of the files of this room

  /// A new, empty list; an existing file is replaced. Throws Error (Job) when it cannot be made.
  static ScenarioList create(const std::string& path);
  /// An existing list. Throws Error (File) when missing, not a scenario list, or of another
  /// version.
  static ScenarioList open(const std::string& path);
  ~ScenarioList();
  ScenarioList(ScenarioList&&) noexcept;
  ScenarioList& operator=(ScenarioList&&) noexcept;

  struct Entry {
    std::string id;  ///< first 12 digits of the content hash
    std::string hash;
    std::string name;
    Representation representation;
    std::string generator = {};  ///< empty where unknown
    std::optional<std::uint64_t> seed = {};
    std::vector<std::string> tags = {};  ///< sorted
  };

  std::vector<Entry> entries() const;  ///< in list order, without geometry
  std::size_t size() const;
  Scenario read(const std::string& hash) const;
  /// The entry whose id, hash, unique hash prefix or name this is; throws Error (Usage) naming what
  /// is there.
  Entry find_entry(const std::string& id_or_name) const;

  /// Appends; a scenario whose content is already there is left out (returns false).
  bool add(const Scenario& scenario, const ScenarioOrigin& origin = {});
  /// In one transaction; the hashes of those that were not there before. `origins` holds one for
  /// each scenario, or nothing.
  std::vector<std::string> add_all(const std::vector<Scenario>& scenarios,
                                   const std::vector<ScenarioOrigin>& origins = {});
  bool remove(const std::string& hash);  ///< false when it is not there
  void set_note(const std::string& key,
                const std::string& text);  ///< origin, generator .ini, seed ...
  std::optional<std::string> note(const std::string& key) const;

  std::optional<Value> find(const std::string& scenario_hash, const std::string& id, int version,
                            const std::string& parameters) override;
  void keep(const std::string& scenario_hash, const std::string& id, int version,
            const std::string& parameters, const Value& value) override;

 private:
  explicit ScenarioList(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// The content of a scenario as bytes and back (zstd inside). Reading checks sizes before it
/// allocates and throws Error (File) naming `where`.
std::string serialize(const Scenario& scenario);
Scenario deserialize_scenario(const std::string& bytes, const std::string& where);

}  // namespace slalom
