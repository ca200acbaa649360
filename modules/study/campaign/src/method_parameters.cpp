// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/campaign/method_parameters.h>
#include <slalom/campaign/method_pool.h>
#include <slalom/core/byte_stream.h>
#include <slalom/core/error.h>
#include <slalom/results/untimely_commands.h>
#include <slalom/workers/worker_pool.h>

#include <cmath>
#include <optional>

namespace slalom {
namespace {

constexpr std::uint8_t kMade = 1, kRefused = 0;

std::string to_bytes(const std::vector<TunableParameter>& parameters) {
  ByteWriter writer;
  writer.u8(kMade).u64(parameters.size());
  for (const TunableParameter& p : parameters)
    writer.text(p.name)
        .f64(p.default_value)
        .f64(p.low)
        .f64(p.high)
        .u8(p.log ? 1 : 0)
        .u8(p.integer ? 1 : 0);
  return writer.take();
}

std::vector<TunableParameter> read(ByteReader& reader, const std::string& where) {
  std::vector<TunableParameter> parameters;
  for (std::uint64_t left = reader.u64(); left > 0; --left) {
    TunableParameter& p = parameters.emplace_back();
    p.name = reader.text();
    p.default_value = reader.f64();
    p.low = reader.f64();
    p.high = reader.f64();
    p.log = reader.u8() == 1;
    p.integer = reader.u8() == 1;
    for (const double number : {p.default_value, p.low, p.high})
      if (!std::isfinite(number))
        throw usage_error(where, "the range of " + p.name + " is not finite", "finite numbers");
  }
  return parameters;
}

}  // namespace

std::vector<TunableParameter> tunable_parameters(const NamedMethod& method,
                                                 const CampaignOptions& options) {
  std::vector<TunableParameter> parameters;
  const WorkItem item = [&](std::size_t, SharedTaskLog&) {
    try {
      const auto made = method.make(options.robot, options.sensor);
      made->check();
      return to_bytes(made->tunable_parameters());
    } catch (const std::exception& error) {
      return ByteWriter().u8(kRefused).text(reason_of(error)).take();
    }
  };
  const auto receive = [&](std::size_t, WorkResult&& result) {
    const std::string printed = error_printed_clause(result.output);
    if (result.status != WorkResult::Status::Done)
      throw usage_error(method.where, "the method could not be built: " + result.detail + printed);
    ByteReader reader(result.payload, method.where);
    if (reader.u8() != kMade)
      throw Error(ErrorKind::Usage, reader.text() + printed);  // a complete message
    parameters = read(reader, method.where);
  };
  run_in_workers(1, pool_of_runs(options, 1), item, receive, nullptr);
  return parameters;
}

}  // namespace slalom
