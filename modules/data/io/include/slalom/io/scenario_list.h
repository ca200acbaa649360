// SPDX-License-Identifier: BSD-3-Clause
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

/// The origin of a scenario, as far as known, and its tags.
struct ScenarioOrigin {
  std::string generator;  ///< family; empty if unknown
  std::optional<std::uint64_t> seed;
  std::vector<std::string> tags;
};

/// A scenario list on disk (.scenarios): one SQLite file with ordered scenarios, their origins and
/// tags, computed descriptor values, and indexes. Each modifying function is one transaction: the
/// file is consistent whenever the program is killed. Concurrent writers wait for each other. When
/// another program has replaced the file, modifying functions throw Error (Job). All data read is
/// validated; errors are Error (File) with file and reason.
class ScenarioList : public DescriptorStore {
 public:
  struct Impl;  ///< internal to this module

  /// Creates an empty list, replacing an existing file. Throws Error (Job) when it cannot be
  /// created.
  static ScenarioList create(const std::string& path);
  /// Creates a list with the contents written by `fill`, atomically: an existing file is replaced
  /// when the list is complete, and kept when `fill` throws.
  static void write(const std::string& path, const std::function<void(ScenarioList&)>& fill);
  /// Opens an existing list. The first time in a program its pages and indexes are checked as a
  /// whole. Throws Error (File) when the file is missing, not a scenario list, of an unsupported
  /// version, or damaged.
  static ScenarioList open(const std::string& path);
  /// Throws Error (File) if there is a file of another kind, which write() would not replace.
  static void expect_replaceable(const std::string& path);
  static void remove_file(const std::string& path);  ///< scenario lists only; errors as of open()
  ~ScenarioList() override;
  ScenarioList(ScenarioList&&) noexcept;
  ScenarioList& operator=(ScenarioList&&) noexcept;

  struct Entry {
    std::string id;  ///< first 12 digits of the content hash
    std::string hash;
    std::string name;
    Representation representation;
    std::string generator = {};  ///< empty if unknown
    std::optional<std::uint64_t> seed = {};
    std::vector<std::string> tags = {};  ///< sorted
  };

  const std::string& path() const;
  std::size_t size() const;
  std::vector<Entry> entries() const;  ///< in list order, without geometry
  Scenario read(const std::string& hash) const;
  /// The entry with this id, hash, unique hash prefix or name. Throws Error (Usage) with a
  /// suggestion.
  Entry find_entry(const std::string& id_or_name) const;

  /// The fields of selection expressions for this list; `numbers` are the ids of descriptors, whose
  /// names are accepted too.
  SelectionVocabulary vocabulary(std::vector<std::string> numbers) const;
  /// Visits the selected scenarios one by one until `visit` returns false. Needs memory for a few
  /// of them only. The list may be changed meanwhile; removed scenarios are skipped.
  void for_each(const ListSelection& selection,
                const std::function<bool(const Entry&)>& visit) const;
  std::vector<Entry> select(const ListSelection& selection) const;
  std::size_t count(const ListSelection& selection) const;
  /// SQLite's query plan, which names the indexes that are used.
  std::string query_plan(const ListSelection& selection) const;
  /// Hashes of scenarios that have no value, not even NA, under any of these keys.
  std::vector<std::string> missing_values(const std::vector<ValueKey>& keys) const;

  /// Appends a scenario; returns false if the list already contains its content.
  bool add(const Scenario& scenario, const ScenarioOrigin& origin = {});
  /// Appends scenarios in one transaction; returns the hashes of those that were added. `origins`
  /// has one element per scenario or is empty.
  std::vector<std::string> add_all(const std::vector<Scenario>& scenarios,
                                   const std::vector<ScenarioOrigin>& origins = {});
  bool remove(const std::string& hash);  ///< false if it does not exist
  /// Returns the number of removed scenarios.
  std::size_t remove(const ListSelection& selection, bool restorable = true);
  /// Removed scenarios that restore() brings back, by their removals, the latest first. The file
  /// keeps the last kMaxDeleted with at most 64 MB of content; write() and save_as() keep none.
  std::vector<std::vector<Entry>> deletions() const;
  bool has_deletions() const;
  static constexpr std::size_t kMaxDeleted = 1000;
  /// Brings removed scenarios back with origin, tags and values: where they were, or at the end if
  /// another one is there. Returns their number. Throws Error (File) if one is damaged.
  std::size_t restore(const std::vector<std::string>& hashes);
  /// Adds and removes tags; returns the number of changed scenarios. Throws Error (Usage) for
  /// invalid tags.
  std::size_t tag(const ListSelection& selection, const std::vector<std::string>& add,
                  const std::vector<std::string>& remove);
  void rename(const std::string& hash, const std::string& name);
  /// Replaces a scenario at its position. If the content changes, tags are kept and values and
  /// origin are dropped; Error (Usage) when the list already contains the new content.
  void replace(const std::string& hash, const Scenario& scenario);
  /// Appends a scenario of another list with origin, tags and values. If the list already contains
  /// its content, adds missing tags and values and returns false.
  bool copy_from(ScenarioList& source, const Entry& entry);
  void save_as(const std::string& path);  ///< replaces an existing file

  std::vector<ListIndex> indexes() const;  ///< by name
  ListIndex index(const std::string& name) const;
  /// Throws Error (Usage) for a duplicate or invalid name, and for edges that do not increase.
  void create_index(const ListIndex& index);
  void drop_index(const std::string& name);
  ListIndexCounts index_counts(const std::string& name) const;

  /// Runs several actions in one transaction.
  void in_transaction(const std::function<void()>& act);
  /// The same, recording the changes. Needs memory for removed and overwritten data.
  ListChange record(const std::function<void()>& act);
  /// Undoes or redoes a recorded change. Throws Error (Job) and leaves the list unchanged when the
  /// affected data has changed since.
  void revert(const ListChange& change);
  void apply(const ListChange& change);

  void set_note(const std::string& key, const std::string& text);  ///< origin, .ini, seed, ...
  std::optional<std::string> note(const std::string& key) const;

  std::optional<Value> find(const std::string& scenario_hash, const ValueKey& key) override;
  /// The value stored under any of these keys.
  std::optional<Value> find(const std::string& scenario_hash, const std::vector<ValueKey>& keys);
  void store_value(const std::string& scenario_hash, const KeyedValue& value) override;

 private:
  explicit ScenarioList(std::unique_ptr<Impl> impl);
  void change_content(const std::string& hash, const std::string& next);
  std::unique_ptr<Impl> impl_;
};

/// Serialization of the content of a scenario (zstd-compressed). Reading validates sizes before it
/// allocates and throws Error (File) at `where`.
std::string serialize(const Scenario& scenario);
Scenario deserialize_scenario(const std::string& bytes, const std::string& where);

}  // namespace slalom
