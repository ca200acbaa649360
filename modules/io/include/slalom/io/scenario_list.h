#pragma once

#include <slalom/descriptors/descriptor_cache.h>
#include <slalom/io/list_selection.h>
#include <slalom/scenario/scenario.h>

#include <cstdint>
#include <functional>
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

/// A scenario list on disk (.scenarios): one SQLite file with scenarios in order, their origins and
/// tags, descriptor values that were computed, and indexes. Each function that writes does all or
/// nothing, as one transaction: the file is whole whenever the program is killed. Programs that
/// write the same list wait for each other; one whose file was replaced by another program refuses
/// to write (Error (Job)). Everything read is checked; errors are Error (File) with file and
/// reason.
class ScenarioList : public DescriptorStore {
 public:
  struct Impl;  ///< of the files of this room

  /// A new, empty list; takes the place of a file that is there. Throws Error (Job) when it cannot
  /// be made.
  static ScenarioList create(const std::string& path);
  /// A new list that `fill` fills beside `path`. It takes the place of what is there once it is
  /// whole; when `fill` throws, what is there stays.
  static void write(const std::string& path, const std::function<void(ScenarioList&)>& fill);
  /// An existing list; one of an older version is brought up to date. Throws Error (File) when
  /// missing, not a scenario list, or of another version.
  static ScenarioList open(const std::string& path);
  static void remove_file(const std::string& path);  ///< only a scenario list; Error as of open()
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

  const std::string& path() const;
  std::size_t size() const;
  std::vector<Entry> entries() const;  ///< in list order, without geometry
  Scenario read(const std::string& hash) const;
  /// The entry whose id, hash, unique hash prefix or name this is; throws Error (Usage) naming what
  /// is there.
  Entry find_entry(const std::string& id_or_name) const;

  /// What expressions about this list may speak of: `numbers` are the ids of descriptors.
  SelectionVocabulary vocabulary(std::vector<std::string> numbers) const;
  /// Shows the chosen scenarios one by one until `visit` says false. Needs memory for a few of them
  /// only; the list may be changed meanwhile: those that are gone are left out.
  void for_each(const ListSelection& selection,
                const std::function<bool(const Entry&)>& visit) const;
  std::vector<Entry> select(const ListSelection& selection) const;
  std::size_t count(const ListSelection& selection) const;
  /// How SQLite goes about it: names the indexes that are used.
  std::string query_plan(const ListSelection& selection) const;
  /// Hashes of scenarios that have no value, not even NA, under any of these keys.
  std::vector<std::string> lacking(const std::vector<DescriptorKey>& keys) const;

  /// Appends; a scenario whose content is already there is left out (returns false).
  bool add(const Scenario& scenario, const ScenarioOrigin& origin = {});
  /// In one transaction; the hashes of those that were not there before. `origins` holds one for
  /// each scenario, or nothing.
  std::vector<std::string> add_all(const std::vector<Scenario>& scenarios,
                                   const std::vector<ScenarioOrigin>& origins = {});
  bool remove(const std::string& hash);                ///< false when it is not there
  std::size_t remove(const ListSelection& selection);  ///< how many
  /// Adds and removes tags; how many scenarios that changed. Throws Error (Usage) for what cannot
  /// be a tag.
  std::size_t tag(const ListSelection& selection, const std::vector<std::string>& add,
                  const std::vector<std::string>& remove);
  void rename(const std::string& hash, const std::string& name);
  /// Puts another scenario in its place. With another content it keeps its tags and loses its
  /// values and origin; Error (Usage) when the list has that content elsewhere.
  void replace(const std::string& hash, const Scenario& scenario);
  /// Appends a scenario of another list with origin, tags and values. When its content is there
  /// already, adds what tags and values are missing and returns false.
  bool copy_from(ScenarioList& source, const Entry& entry);
  void save_as(const std::string& path);  ///< a copy of the whole list, in place of what is there

  std::vector<ListIndex> indexes() const;  ///< by name
  ListIndex index(const std::string& name) const;
  /// Throws Error (Usage) for a name that is taken or no word, and for edges that do not grow.
  void create_index(const ListIndex& index);
  void drop_index(const std::string& name);
  ListIndexCounts index_counts(const std::string& name) const;

  /// Several actions as one: all of them are done, or none.
  void in_one_step(const std::function<void()>& act);
  /// The same, noting what changed. The note needs memory for what was removed or overwritten.
  ListChange record(const std::function<void()>& act);
  /// Takes a recorded change back, or does it again. Throws Error (Job) and leaves the list as it
  /// is when what it touched has changed since.
  void revert(const ListChange& change);
  void apply(const ListChange& change);

  void set_note(const std::string& key,
                const std::string& text);  ///< origin, generator .ini, seed ...
  std::optional<std::string> note(const std::string& key) const;

  std::optional<Value> find(const std::string& scenario_hash, const std::string& id, int version,
                            const std::string& parameters) override;
  /// The value under any of these keys.
  std::optional<Value> find(const std::string& scenario_hash,
                            const std::vector<DescriptorKey>& keys);
  void keep(const std::string& scenario_hash, const std::string& id, int version,
            const std::string& parameters, const Value& value) override;

 private:
  explicit ScenarioList(std::unique_ptr<Impl> impl);
  void forget_content(const std::string& hash, const std::string& next);
  std::unique_ptr<Impl> impl_;
};

/// The content of a scenario as bytes and back (zstd inside). Reading checks sizes before it
/// allocates and throws Error (File) naming `where`.
std::string serialize(const Scenario& scenario);
Scenario deserialize_scenario(const std::string& bytes, const std::string& where);

}  // namespace slalom
