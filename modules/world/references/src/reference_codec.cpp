// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/byte_stream.h>
#include <slalom/references/reference_codec.h>

namespace slalom {
namespace {

/// Versions of the code; the one for scenarios with moving obstacles has the earliest arrival at
/// the end.
constexpr std::uint8_t kVersion = 3, kVersionWithMovers = 4;

void write_path(ByteWriter& out, const Path& path) {
  out.u64(path.size());
  for (const auto& p : path) out.f64(p.x).f64(p.y);
}

Path read_path(ByteReader& in) {
  Path path(in.count(16));
  for (auto& p : path) {
    p.x = in.f64();
    p.y = in.f64();
  }
  return path;
}

ShortestPath read_shortest(ByteReader& in) {
  ShortestPath shortest;
  shortest.path = read_path(in);
  shortest.length = in.f64();
  shortest.certificate.lower_bound = in.f64();
  shortest.certificate.upper_bound = in.f64();
  shortest.planner = in.text();
  shortest.note = in.text();
  shortest.exact_length = in.f64();
  if (in.u8() != 0) shortest.planner_length = in.f64();
  return shortest;
}

SafestPath read_safest(ByteReader& in) {
  SafestPath safest;
  safest.path = read_path(in);
  safest.bottleneck = in.f64();
  safest.planner = in.text();
  safest.note = in.text();
  return safest;
}

void write_arrival(ByteWriter& out, const References& references) {
  out.text(references.arrival_reason).u8(references.arrival ? 1 : 0);
  if (!references.arrival) return;
  const EarliestArrival& arrival = *references.arrival;
  out.f64(arrival.certificate.lower_bound).f64(arrival.certificate.upper_bound);
  out.u64(arrival.plan.size());
  for (const TimedPoint& p : arrival.plan) out.f64(p.t).f64(p.position.x).f64(p.position.y);
}

EarliestArrival read_arrival(ByteReader& in) {
  EarliestArrival arrival;
  arrival.certificate.lower_bound = in.f64();
  arrival.certificate.upper_bound = in.f64();
  arrival.plan.resize(in.count(24));
  for (TimedPoint& p : arrival.plan) {
    p.t = in.f64();
    p.position.x = in.f64();
    p.position.y = in.f64();
  }
  return arrival;
}

}  // namespace

std::string to_bytes(const References& references) {
  ByteWriter out;
  const bool has_movers = references.arrival || !references.arrival_reason.empty();
  out.u8(has_movers ? kVersionWithMovers : kVersion);
  out.text(references.shortest_reason).text(references.safest_reason);
  out.u8(references.shortest ? 1 : 0);
  if (references.shortest) {
    const ShortestPath& s = *references.shortest;
    write_path(out, s.path);
    out.f64(s.length).f64(s.certificate.lower_bound).f64(s.certificate.upper_bound);
    out.text(s.planner).text(s.note).f64(s.exact_length);
    out.u8(s.planner_length ? 1 : 0);
    if (s.planner_length) out.f64(*s.planner_length);
  }
  out.u8(references.safest ? 1 : 0);
  if (references.safest) {
    write_path(out, references.safest->path);
    out.f64(references.safest->bottleneck);
    out.text(references.safest->planner).text(references.safest->note);
  }
  if (has_movers) write_arrival(out, references);
  return out.take();
}

References references_from_bytes(const std::string& bytes, const std::string& where) {
  ByteReader in(bytes, where);
  const std::uint8_t version = in.u8();
  if (version != kVersion && version != kVersionWithMovers) throw in.broken("unsupported version");
  References references;
  references.shortest_reason = in.text();
  references.safest_reason = in.text();
  if (in.u8() != 0) references.shortest = read_shortest(in);
  if (in.u8() != 0) references.safest = read_safest(in);
  if (version == kVersionWithMovers) {
    references.arrival_reason = in.text();
    if (in.u8() != 0) references.arrival = read_arrival(in);
  }
  in.expect_end();
  return references;
}

}  // namespace slalom
