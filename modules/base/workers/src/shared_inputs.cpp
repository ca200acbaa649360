// SPDX-License-Identifier: BSD-3-Clause
#include "shared_inputs.h"
#include "shared_memory.h"

#include <slalom/core/error.h>

#include <algorithm>
#include <optional>

namespace slalom {
namespace {

PoolOptions for_makers(PoolOptions options) {
  options.schedule.trusted = true;
  options.limits.sandbox = false;
  options.limits.network = true;
  options.log_size = 0;
  options.hooks.is_valid = nullptr;
  options.hooks.at_end = nullptr;
  return options;
}

/// Writes inputs, in the process of a maker.
class InputWriter {
 public:
  explicit InputWriter(const SharedInputs& inputs) : inputs_(inputs) {}

  void write(std::size_t input, int file) {
    SharedWriter& memory = memory_of(file);
    memory.clear();
    inputs_.make(input,
                 [&](const void* data, std::size_t size) { memory.append(file, data, size); });
    memory.finish();
  }

 private:
  SharedInputs inputs_;
  std::vector<SharedWriter> memories_;

  SharedWriter& memory_of(int file) {
    for (SharedWriter& memory : memories_)
      if (memory.writes(file)) return memory;
    return memories_.emplace_back(file);
  }
};

}  // namespace

SharedInputPool::SharedInputPool(std::size_t count, const PoolOptions& options)
    : count_(count),
      options_(for_makers(options)),
      nothing_([](std::size_t, SharedTaskLog&) { return std::string(); }) {}

std::optional<std::size_t> SharedInputPool::input_of(std::size_t item) const {
  return options_.inputs.of ? options_.inputs.of(item) : std::nullopt;
}

bool SharedInputPool::is_awaited(std::size_t item) const {
  const auto key = input_of(item);
  if (!key) return false;
  const auto input = inputs_.find(*key);
  return input == inputs_.end() ? item >= ahead_ : !input->second.is_made;
}

bool SharedInputPool::make_next() {
  const auto waiting = std::count_if(inputs_.begin(), inputs_.end(),
                                     [](const auto& input) { return !input.second.is_used; });
  if (waiting >= std::max(1, options_.schedule.workers)) return false;
  while (ahead_ < count_ && !input_of(ahead_)) ++ahead_;
  if (ahead_ == count_) return false;
  const std::size_t key = *input_of(ahead_);
  Input& input = inputs_[key];
  for (; ahead_ < count_ && input_of(ahead_) == key; ++ahead_) ++input.items;
  const std::shared_ptr<Maker> maker = idle_maker();
  if (maker->free_memory.empty()) {
    input.memory = create_shared_memory();
  } else {
    input.memory = std::move(maker->free_memory.back());
    maker->free_memory.pop_back();
  }
  input.maker = maker;
  input.is_made = !input.memory;
  if (input.memory) maker->process->assign(key, input.memory.number());
  return true;
}

std::shared_ptr<SharedInputPool::Maker> SharedInputPool::idle_maker() {
  for (const auto& maker : makers_)
    if (maker->process->idle() && maker->process->is_sound()) return maker;
  for (auto& maker : makers_)
    if (!maker->process->busy()) maker.reset();
  makers_.erase(std::remove(makers_.begin(), makers_.end(), nullptr), makers_.end());
  const auto writer = std::make_shared<InputWriter>(options_.inputs);
  makers_.push_back(std::make_shared<Maker>());
  makers_.back()->process = std::make_unique<WorkerProcess>(
      options_, nothing_, [writer](std::size_t key, int file) { writer->write(key, file); });
  makers_.back()->process->start(0);
  return makers_.back();
}

int SharedInputPool::descriptor_for(std::size_t item) {
  const auto key = input_of(item);
  const auto input = key ? inputs_.find(*key) : inputs_.end();
  if (input == inputs_.end()) return -1;
  input->second.is_used = true;
  return input->second.memory.number();
}

void SharedInputPool::release(std::size_t item) {
  const auto key = input_of(item);
  const auto input = key ? inputs_.find(*key) : inputs_.end();
  if (input == inputs_.end() || --input->second.items > 0) return;
  const std::shared_ptr<Maker> maker = input->second.maker.lock();
  if (maker && input->second.memory) maker->free_memory.push_back(std::move(input->second.memory));
  inputs_.erase(input);
}

std::size_t SharedInputPool::busy() const {
  return static_cast<std::size_t>(std::count_if(
      makers_.begin(), makers_.end(), [](const auto& maker) { return maker->process->busy(); }));
}

void SharedInputPool::add_events(std::vector<pollfd>& events) const {
  for (const auto& maker : makers_) maker->process->add_events(events);
}

void SharedInputPool::collect() {
  for (const auto& maker : makers_) {
    if (!maker->process->busy()) continue;
    maker->process->read();
    const auto result = maker->process->receive(true);
    if (!result) continue;
    Input& input = inputs_.at(maker->process->last_item());
    input.is_made = true;
    const bool is_complete = result->status == WorkResult::Status::Done;
    if (!is_complete || !is_sealed(input.memory.number())) input.memory = FileDescriptor();
  }
}

FileReceiver SharedInputPool::receiver() const {
  const auto reader = std::make_shared<SharedReader>();  // each process has its own after the fork
  return [inputs = options_.inputs, reader](std::size_t item, int file) {
    const SharedArray<std::byte> memory = reader->read(file);
    if (memory.size() == 0) return;
    try {
      inputs.use(*inputs.of(item), memory);
    } catch (const Error&) {
      // A method has mapped something else over it: the work item does without it.
    }
  };
}

}  // namespace slalom
