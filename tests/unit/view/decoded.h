// The page's way back: a run's data as whole numbers.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scenarios/view/encode.h"

inline std::string unbase64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t held = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    held = held << 6 | static_cast<std::uint32_t>(digits.find(c));
    bits += 6;
    if (bits >= 8) bytes += static_cast<char>(held >> (bits -= 8) & 255);
  }
  return bytes;
}

inline std::string inflated(const std::string& bytes) {
  std::string out(1 << 24, '\0');
  uLongf size = out.size();
  const auto* from = reinterpret_cast<const Bytef*>(bytes.data());
  const int result = uncompress(reinterpret_cast<Bytef*>(out.data()), &size, from, bytes.size());
  out.resize(result == Z_OK ? size : 0);
  return out;
}

struct Decoded {
  nlohmann::json header;
  std::map<std::string, std::vector<unsigned>> columns;  ///< by frame, body, component
  std::size_t bytes = 0;                                 ///< inflated
};

inline Decoded decoded(const ballpark::view::Encoded& run) {
  Decoded result{nlohmann::json::parse(run.header), {}, 0};
  const std::string data = inflated(unbase64(run.data));
  result.bytes = data.size();
  const std::size_t frames = result.header["times"].size(), bodies = result.header["shown"];
  std::size_t at = 0;
  for (const auto& column : result.header["columns"]) {
    const std::size_t components = column["components"], bits = column["bits"];
    const unsigned mask = (1U << bits) - 1;
    std::vector<unsigned>& values = result.columns[column["name"]];
    values.resize(frames * bodies * components);
    for (std::size_t f = 0; f < frames; ++f) {
      for (std::size_t c = 0; c < components; ++c) {
        for (std::size_t body = 0; body < bodies; ++body) {
          unsigned change = static_cast<unsigned char>(data.at(at + body));
          if (bits == 16) change |= static_cast<unsigned>(static_cast<unsigned char>(data.at(at + bodies + body))) << 8;
          const auto before = [&](std::size_t k) {
            return f < k ? 0 : values[((f - k) * bodies + body) * components + c];
          };
          const bool second = column["differences"] == 2;
          const unsigned value = second ? change + 2 * before(1) - before(2) : change + before(1);
          values[(f * bodies + body) * components + c] = value & mask;
        }
        at += bodies * bits / 8;
      }
    }
  }
  return result;
}
