#include "engine/core/hash.h"

#include <bit>
#include <cstring>

namespace ballpark {
namespace {

static_assert(std::endian::native == std::endian::little, "words are read as they lie in memory");

constexpr std::uint64_t primes[] = {0x9E3779B185EBCA87, 0xC2B2AE3D27D4EB4F, 0x165667B19E3779F9, 0x85EBCA77C2B2AE63,
                                    0x27D4EB2F165667C5};

template <class Word>
std::uint64_t take(const unsigned char*& at) {
  Word word;
  std::memcpy(&word, at, sizeof(Word));
  at += sizeof(Word);
  return word;
}

std::uint64_t mixed(std::uint64_t lane, std::uint64_t word) {
  return std::rotl(lane + word * primes[1], 31) * primes[0];
}

std::uint64_t merged(std::uint64_t sum, std::uint64_t lane) {
  return (sum ^ mixed(0, lane)) * primes[0] + primes[3];
}

/// Consumes whole stripes of four words.
std::uint64_t stripes(const unsigned char*& at, std::size_t count, std::uint64_t seed) {
  std::uint64_t a = seed + primes[0] + primes[1], b = seed + primes[1], c = seed, d = seed - primes[0];
  for (std::size_t i = 0; i < count; ++i) {
    a = mixed(a, take<std::uint64_t>(at));
    b = mixed(b, take<std::uint64_t>(at));
    c = mixed(c, take<std::uint64_t>(at));
    d = mixed(d, take<std::uint64_t>(at));
  }
  const std::uint64_t sum = std::rotl(a, 1) + std::rotl(b, 7) + std::rotl(c, 12) + std::rotl(d, 18);
  return merged(merged(merged(merged(sum, a), b), c), d);
}

}  // namespace

std::uint64_t hash(const void* bytes, std::size_t size, std::uint64_t seed) {
  const auto* at = static_cast<const unsigned char*>(bytes);
  std::uint64_t sum = size >= 32 ? stripes(at, size / 32, seed) : seed + primes[4];
  sum += size;
  std::size_t left = size % 32;
  for (; left >= 8; left -= 8) {
    sum = std::rotl(sum ^ mixed(0, take<std::uint64_t>(at)), 27) * primes[0] + primes[3];
  }
  if (left >= 4) {
    sum = std::rotl(sum ^ take<std::uint32_t>(at) * primes[0], 23) * primes[1] + primes[2];
    left -= 4;
  }
  for (; left > 0; --left) sum = std::rotl(sum ^ take<std::uint8_t>(at) * primes[4], 11) * primes[0];
  sum = (sum ^ sum >> 33) * primes[1];
  sum = (sum ^ sum >> 29) * primes[2];
  return sum ^ sum >> 32;
}

std::uint64_t combine(std::uint64_t before, std::uint64_t next) {
  return hash(&next, sizeof(next), before);
}

}  // namespace ballpark
