// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"
#include "wire.h"

#include <slalom/core/hash.h>

namespace {

/// The bytes of what was read are those that are read again.
template <typename Read>
void read_twice(const std::string& bytes, Read read) {
  std::string written;
  try {
    written = slalom::to_wire(read(bytes));
  } catch (const std::exception&) {  // the campaign takes it for a crash of the method
    return;
  }
  slalom::fuzz::expect(slalom::to_wire(read(written)) == written,
                       "findings do not change when sent again");
}

}  // namespace

/// Decodes the answer of a worker process, which may be hostile: with a correct checksum, findings
/// of a run or of a scenario.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string content = slalom::fuzz::text_of(data, size);
  const std::string bytes = slalom::Hasher().add(content).hex() + content;
  read_twice(bytes, slalom::run_findings_from_wire);
  read_twice(bytes, slalom::scenario_findings_from_wire);
  return 0;
}
