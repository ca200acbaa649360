// SPDX-License-Identifier: BSD-3-Clause
#include "compression.h"
#include "fuzz_target.h"

#include <slalom/core/read_file.h>
#include <slalom/io/bundle.h>
#include <slalom/io/read_results.h>
#include <slalom/io/result_file.h>

namespace {

using namespace slalom;

/// The pages of a bundle with two runs.
std::string sample_pages() {
  const fuzz::InputFile file("sample.results", ""), bundle("sample.slalom", "");
  {
    ResultFile results = ResultFile::create(file.path(), {{"campaign", "c"}}, {}, {});
    const Scenario scenario = Scenario::continuous("s", {0, 0, 9, 9}, {}, {1, 1, 0}, {8, 8});
    results.add_scenario({scenario.hash(), scenario.name(), {}}, scenario, References{});
    for (const std::string method : {"a", "b"}) {
      RunRecord run;
      run.scenario_hash = scenario.hash();
      run.scenario_name = scenario.name();
      run.method = method;
      run.outcome = "stuck";
      results.add_run(run, {}, PackedTrajectory());
    }
    results.commit();
  }
  write_bundle(file.path(), bundle.path(), {{{"method.a.plugin", "content"}}});
  return decompress(read_file(bundle.path()), bundle.path());
}

}  // namespace

/// Bundles with changed bytes in the pages of their database: offset (two bytes), value.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string sample = sample_pages();
  std::string pages = sample;
  for (std::size_t i = 0; i + 2 < size; i += 3)
    pages[(data[i] | std::size_t{data[i + 1]} << 8U) % pages.size()] =
        static_cast<char>(data[i + 2]);
  const fuzz::InputFile file("pages.slalom", compress(pages));
  fuzz::read_or_refuse([&] { read_detailed_results(file.path()); });
  fuzz::read_or_refuse([&] { read_bundled_files(file.path()); });
  fuzz::read_or_refuse([&] {
    const ResultFile results = ResultFile::open(file.path());
    results.for_each_run([&](const RunRecord& run) {
      fuzz::read_or_refuse([&] { results.read_trajectory(run); });
      fuzz::read_or_refuse([&] { results.read_references(run.scenario_hash); });
      fuzz::read_or_refuse([&] { results.read_scenario(run.scenario_hash); });
    });
  });
  return 0;
}
