#include "shared_inputs.h"
#include "shared_memory.h"

#include <algorithm>
#include <optional>

namespace slalom {
namespace {

PoolOptions for_makers(PoolOptions options) {
  options.trusted = true;
  options.sandbox = false;
  options.log_size = 0;
  options.is_valid = nullptr;
  options.at_end = nullptr;
  return options;
}

}  // namespace

InputStore::InputStore(std::size_t count, const PoolOptions& options)
    : count_(count),
      options_(for_makers(options)),
      nothing_([](std::size_t, SharedTaskLog&) { return std::string(); }) {}

std::optional<std::size_t> InputStore::input_of(std::size_t item) const {
  return options_.inputs.of ? options_.inputs.of(item) : std::nullopt;
}

bool InputStore::is_awaited(std::size_t item) const {
  const auto key = input_of(item);
  if (!key) return false;
  const auto input = inputs_.find(*key);
  return input == inputs_.end() ? item >= ahead_ : !input->second.is_made;
}

bool InputStore::make_next() {
  const auto waiting = std::count_if(inputs_.begin(), inputs_.end(),
                                     [](const auto& input) { return !input.second.is_used; });
  if (waiting >= std::max(1, options_.workers)) return false;
  while (ahead_ < count_ && !input_of(ahead_)) ++ahead_;
  if (ahead_ == count_) return false;
  const std::size_t key = *input_of(ahead_);
  Input& input = inputs_[key];
  for (; ahead_ < count_ && input_of(ahead_) == key; ++ahead_) ++input.items;
  input.memory = create_shared_memory();
  input.is_made = !input.memory;
  if (input.memory) idle_maker().assign(key, input.memory.number());
  return true;
}

WorkerProcess& InputStore::idle_maker() {
  for (const auto& maker : makers_)
    if (maker->idle() && maker->is_sound()) return *maker;
  const auto& make = options_.inputs.make;
  const auto write = [make](std::size_t key, int file) {
    make(key,
         [file](const void* data, std::size_t size) { append_to_shared_memory(file, data, size); });
  };
  for (auto& maker : makers_)
    if (!maker->busy()) maker.reset();
  makers_.erase(std::remove(makers_.begin(), makers_.end(), nullptr), makers_.end());
  makers_.push_back(std::make_unique<WorkerProcess>(options_, write));
  makers_.back()->start(nothing_, 0);
  return *makers_.back();
}

int InputStore::descriptor_for(std::size_t item) {
  const auto key = input_of(item);
  const auto input = key ? inputs_.find(*key) : inputs_.end();
  if (input == inputs_.end()) return -1;
  input->second.is_used = true;
  return input->second.memory.number();
}

void InputStore::release(std::size_t item) {
  const auto key = input_of(item);
  const auto input = key ? inputs_.find(*key) : inputs_.end();
  if (input != inputs_.end() && --input->second.items == 0) inputs_.erase(input);
}

std::size_t InputStore::busy() const {
  return static_cast<std::size_t>(std::count_if(makers_.begin(), makers_.end(),
                                                [](const auto& maker) { return maker->busy(); }));
}

void InputStore::add_events(std::vector<pollfd>& events) const {
  for (const auto& maker : makers_) maker->add_events(events);
}

void InputStore::collect() {
  for (const auto& maker : makers_) {
    if (!maker->busy()) continue;
    const auto result = maker->receive();
    if (!result) continue;
    Input& input = inputs_.at(maker->last_item());
    input.is_made = true;
    const bool is_complete = result->status == WorkResult::Status::Done;
    if (!is_complete || !seal_shared_memory(input.memory.number())) input.memory = FileDescriptor();
  }
}

FileReceiver InputStore::receiver() const {
  const SharedInputs inputs = options_.inputs;
  return [inputs](std::size_t item, int file) {
    const SharedArray<std::byte> memory = map_shared_memory(file);
    if (memory.size() > 0) inputs.use(*inputs.of(item), memory);
  };
}

}  // namespace slalom
