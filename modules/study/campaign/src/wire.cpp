// SPDX-License-Identifier: BSD-3-Clause
#include "wire.h"

#include <slalom/core/byte_stream.h>
#include <slalom/core/error.h>
#include <slalom/core/hash.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <string_view>

namespace slalom {
namespace {

constexpr char kSource[] = "a worker";

enum class ValueForm : std::uint8_t { Number, WithError, Na };

void write(ByteWriter& out, const std::map<std::string, VersionedValue>& values) {
  out.u64(values.size());
  for (const auto& [id, versioned] : values) {
    const Value& value = versioned.value;
    const ValueForm form = value.is_na()            ? ValueForm::Na
                           : value.standard_error() ? ValueForm::WithError
                                                    : ValueForm::Number;
    out.text(id).u64(static_cast<std::uint64_t>(versioned.version));
    out.u8(static_cast<std::uint8_t>(form));
    if (form == ValueForm::Na)
      out.text(value.reason());
    else
      out.f64(value.number());
    if (form == ValueForm::WithError) out.f64(*value.standard_error());
  }
}

Value read_value(ByteReader& in) {
  const auto form = static_cast<ValueForm>(in.u8());
  if (form == ValueForm::Na) return Value::na(in.text());
  const double number = in.f64();
  if (form == ValueForm::Number) return Value::of(number);
  if (form != ValueForm::WithError) throw in.broken("unknown form of a value");
  return Value::of(number, in.f64());
}

/// An integer that fits.
int read_int(ByteReader& in) {
  const std::uint64_t value = in.u64();
  if (value > INT_MAX) throw in.broken("a number that is too large");
  return static_cast<int>(value);
}

std::map<std::string, VersionedValue> read_values(ByteReader& in) {
  constexpr std::size_t kLeast = 8 + 8 + 1 + 8;  // length of the id, version, form, number
  std::map<std::string, VersionedValue> values;
  for (std::size_t left = in.count(kLeast); left > 0; --left) {
    const std::string id = in.text();
    const int version = read_int(in);
    values[id] = {version, read_value(in)};
  }
  return values;
}

/// Throws for a time that cannot be stored.
double read_seconds(ByteReader& in) {
  const double seconds = in.f64();
  if (!std::isfinite(seconds)) throw in.broken("a time that is not finite");
  return seconds;
}

/// With a checksum: methods share the process that sends the bytes.
std::string sealed(const std::string& bytes) {
  return Hasher().add(bytes).hex() + bytes;
}

std::string_view opened(std::string_view bytes) {
  constexpr std::size_t kChecksum = 32;
  const std::string_view content = bytes.substr(std::min(kChecksum, bytes.size()));
  if (bytes.substr(0, kChecksum) != Hasher().add(content).hex())
    throw file_error(kSource, "sent bytes that do not match their checksum");
  return content;
}

}  // namespace

std::string to_wire(const ScenarioFindings& findings) {
  const ReferenceTiming& timing = findings.references.timing;
  ByteWriter out;
  out.text(findings.record.hash).text(findings.record.name);
  write(out, findings.record.descriptors);
  out.text(findings.packed.content).text(findings.packed.refs);
  out.f64(timing.exact).f64(timing.planner).f64(timing.safest);
  return sealed(out.take());
}

ScenarioFindings scenario_findings_from_wire(const std::string& bytes) {
  ByteReader in(opened(bytes), kSource);
  ScenarioFindings findings;
  findings.record.hash = in.text();
  findings.record.name = in.text();
  findings.record.descriptors = read_values(in);
  findings.packed.content = in.text();
  findings.packed.refs = in.text();
  findings.references = findings.packed.unpack_references(kSource);
  ReferenceTiming& timing = findings.references.timing;
  timing.exact = read_seconds(in);
  timing.planner = read_seconds(in);
  timing.safest = read_seconds(in);
  in.expect_end();
  return findings;
}

std::string to_wire(const RunFindings& findings) {
  const RunRecord& r = findings.record;
  ByteWriter out;
  out.text(r.scenario_hash).text(r.scenario_name).text(r.method);
  out.u64(static_cast<std::uint64_t>(r.repetition)).u64(r.seed);
  out.text(r.outcome).text(r.outcome_detail).text(r.trajectory_hash);
  write(out, r.metrics);
  out.f64(findings.timing.wall_seconds).u64(findings.timing.values.size());
  for (const auto& [id, seconds] : findings.timing.values) out.text(id).f64(seconds);
  out.text(findings.trajectory.bytes());
  return sealed(out.take());
}

RunFindings run_findings_from_wire(const std::string& bytes) {
  ByteReader in(opened(bytes), kSource);
  RunFindings findings;
  RunRecord& r = findings.record;
  r.scenario_hash = in.text();
  r.scenario_name = in.text();
  r.method = in.text();
  r.repetition = read_int(in);
  r.seed = in.u64();
  r.outcome = in.text();
  r.outcome_detail = in.text();
  r.trajectory_hash = in.text();
  r.metrics = read_values(in);
  findings.timing.wall_seconds = read_seconds(in);
  for (std::size_t left = in.count(8 + 8); left > 0; --left) {
    const std::string id = in.text();
    findings.timing.values[id] = in.f64();
  }
  findings.trajectory = PackedTrajectory::of_bytes(in.text());
  in.expect_end();
  return findings;
}

}  // namespace slalom
