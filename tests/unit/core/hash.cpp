#include "engine/core/hash.h"

#include <cstdint>
#include <cstring>
#include <set>
#include <string>
#include <vector>

#include "tests/catch.h"

using ballpark::combine;
using ballpark::hash;

TEST_CASE("hash of known texts", "[hash]") {
  const auto hash_of = [](const std::string& text) { return hash(text.data(), text.size()); };
  CHECK(hash_of("") == 0xEF46DB3751D8E999);
  CHECK(hash_of("a") == 0xD24EC4F1A98C6E5B);
  CHECK(hash_of("abc") == 0x44BC2CF5AD770999);
  CHECK(hash_of("Nobody inspects the spammish repetition") == 0xFBCEA83C8A378BF1);
  CHECK(hash_of("The quick brown fox jumps over the lazy dog") == 0x0B242D361FDA71BC);
}

TEST_CASE("hash gives XXH64's known answers for every kind of tail, with and without seed", "[hash]") {
  constexpr std::uint32_t prime = 2654435761;
  std::vector<unsigned char> bytes;
  std::uint32_t state = prime;
  for (int i = 0; i < 101; ++i, state *= state) bytes.push_back(static_cast<unsigned char>(state >> 24));
  const struct {
    std::size_t size;
    std::uint64_t plain, seeded;
  } answers[] = {{0, 0xEF46DB3751D8E999, 0xAC75FDA2929B17EF},  {1, 0x4FCE394CC88952D8, 0x739840CB819FA723},
                 {4, 0x9256E58AA397AEF1, 0x09D5FFDFB928AB4B},  {8, 0xF74CB1451B32B8CF, 0x9C44B77FBCC302C5},
                 {14, 0xCFFA8DB881BC3A3D, 0x5B9611585EFCC9CB}, {32, 0xAF5753D39159EDEE, 0xDCAB9233B8CA7B0F},
                 {101, 0x0EAB543384F878AD, 0xCAA65939306F1E21}};
  for (const auto& answer : answers) {
    CAPTURE(answer.size);
    CHECK(hash(bytes.data(), answer.size) == answer.plain);
    CHECK(hash(bytes.data(), answer.size, prime) == answer.seeded);
  }
}

TEST_CASE("hash does not depend on where the bytes lie", "[hash]") {
  std::vector<unsigned char> bytes(200 + 16);
  for (std::size_t offset = 0; offset < 16; ++offset) {
    for (std::size_t i = 0; i < 200; ++i) bytes[offset + i] = static_cast<unsigned char>(7 * i + 3);
    CHECK(hash(bytes.data() + offset, 200) == hash(bytes.data() + offset, 200, 0));
    std::vector<unsigned char> copy(bytes.begin() + static_cast<std::ptrdiff_t>(offset),
                                    bytes.begin() + static_cast<std::ptrdiff_t>(offset) + 200);
    CHECK(hash(bytes.data() + offset, 200) == hash(copy.data(), copy.size()));
  }
}

TEST_CASE("one changed bit changes about half of the hash's bits", "[hash]") {
  for (const std::size_t size : {1, 8, 37, 96}) {
    std::vector<unsigned char> bytes(size, 0x5A);
    const std::uint64_t before = hash(bytes.data(), size);
    double changed = 0;
    for (std::size_t bit = 0; bit < 8 * size; ++bit) {
      bytes[bit / 8] ^= static_cast<unsigned char>(1u << bit % 8);
      changed += __builtin_popcountll(before ^ hash(bytes.data(), size));
      bytes[bit / 8] ^= static_cast<unsigned char>(1u << bit % 8);
    }
    CAPTURE(size, changed);
    const double mean = changed / static_cast<double>(8 * size);
    CHECK(mean > 26);
    CHECK(mean < 38);
  }
}

TEST_CASE("combine depends on order and does not collide on small numbers", "[hash]") {
  CHECK(combine(1, 2) != combine(2, 1));
  CHECK(combine(combine(1, 2), 3) != combine(1, combine(2, 3)));
  CHECK(combine(0, 0) != 0);
  std::set<std::uint64_t> seen;
  for (std::uint64_t a = 0; a < 300; ++a) {
    for (std::uint64_t b = 0; b < 300; ++b) seen.insert(combine(a, b));
  }
  CHECK(seen.size() == 300 * 300);
}
