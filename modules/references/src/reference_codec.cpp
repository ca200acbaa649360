#include <slalom/core/byte_stream.h>
#include <slalom/references/reference_codec.h>

namespace slalom {
namespace {

constexpr std::uint8_t kVersion = 3;

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

}  // namespace

std::string to_bytes(const References& references) {
  ByteWriter out;
  out.u8(kVersion).text(references.shortest_reason).text(references.safest_reason);
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
  return out.take();
}

References references_from_bytes(const std::string& bytes, const std::string& where) {
  ByteReader in(bytes, where);
  in.expect_version(kVersion);
  References references;
  references.shortest_reason = in.text();
  references.safest_reason = in.text();
  if (in.u8() != 0) references.shortest = read_shortest(in);
  if (in.u8() != 0) references.safest = read_safest(in);
  in.expect_end();
  return references;
}

}  // namespace slalom
