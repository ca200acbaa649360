// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/hash.h>

#include <fmt/format.h>

#include <cstring>
#include <xxhash.h>

namespace slalom {
namespace {

std::uint64_t bits_of(double number) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);
  return bits;
}

}  // namespace

Hasher::Hasher() : state_(XXH3_createState()) {
  XXH3_128bits_reset(state_);
}

Hasher::~Hasher() {
  XXH3_freeState(state_);
}

Hasher& Hasher::add_bytes(const void* data, std::size_t size) {
  XXH3_128bits_update(state_, data, size);
  return *this;
}

Hasher& Hasher::add(std::uint64_t number) {
  unsigned char bytes[8];
  for (int i = 0; i < 8; ++i) bytes[i] = static_cast<unsigned char>(number >> (8 * i));
  return add_bytes(bytes, sizeof bytes);
}

Hasher& Hasher::add(double number) {
  if (number == 0) number = 0;  // -0.0 and 0.0 are the same content
  return add(bits_of(number));
}

Hasher& Hasher::add(std::string_view text) {
  add(static_cast<std::uint64_t>(text.size()));
  return add_bytes(text.data(), text.size());
}

std::string Hasher::hex() const {
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, XXH3_128bits_digest(state_));
  std::string text;
  for (const unsigned char byte : canonical.digest) text += fmt::format("{:02x}", byte);
  return text;
}

bool same_bits(double a, double b) {
  return bits_of(a) == bits_of(b);
}

}  // namespace slalom
