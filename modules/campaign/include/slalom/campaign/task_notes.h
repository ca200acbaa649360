#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace slalom {

/// A sheet of memory that a worker shares with the process that forked it. What a task writes there
/// survives the task's death.
class TaskNotes {
 public:
  /// Throws Error (Job) when the system has no memory left.
  explicit TaskNotes(std::size_t capacity);
  ~TaskNotes();
  TaskNotes(const TaskNotes&) = delete;
  TaskNotes& operator=(const TaskNotes&) = delete;

  void clear();  ///< a new task begins

  void append(const void* data, std::size_t size);  ///< nothing where it would not fit
  std::string contents() const;

  void beat();  ///< a sign of life, for the limit on silence
  std::uint64_t beats() const;

  /// The worker is to be replaced after this task: it may have been damaged.
  void retire_worker();
  bool is_retired() const;

 private:
  struct Sheet;
  std::size_t capacity_;
  Sheet* sheet_;
};

}  // namespace slalom
