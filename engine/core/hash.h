// A fast 64-bit hash: equal bytes give equal hashes on every machine. Not for secrets.
#pragma once

#include <cstddef>
#include <cstdint>

namespace ballpark {

/// XXH64 of a range of bytes (specification: github.com/Cyan4973/xxHash, doc/xxhash_spec.md).
std::uint64_t hash(const void* bytes, std::size_t size, std::uint64_t seed = 0);

/// The hash of a sequence, from that of what came before and of what comes next: combine(a, b) != combine(b, a).
std::uint64_t combine(std::uint64_t before, std::uint64_t next);

}  // namespace ballpark
