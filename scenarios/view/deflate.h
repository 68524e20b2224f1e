// Bytes made smaller, in zlib's format (RFC 1950), and text that stands for bytes.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

struct z_stream_s;

namespace ballpark::view {

class Deflater {
 public:
  Deflater();
  void add(std::span<const std::uint8_t> bytes);
  /// Bytes that all that was added has taken so far.
  std::size_t flush();
  std::string finish();

 private:
  struct End {
    void operator()(z_stream_s* stream) const;
  };
  void run(int flush);

  std::unique_ptr<z_stream_s, End> stream_;
  std::string out_;
};

/// As PNG wants it of its chunks.
std::uint32_t crc(std::string_view bytes);

std::string base64(std::string_view bytes);

}  // namespace ballpark::view
