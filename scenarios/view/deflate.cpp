#include "scenarios/view/deflate.h"

#include <zlib.h>

#include <algorithm>
#include <new>
#include <utility>

namespace ballpark::view {

void Deflater::End::operator()(z_stream_s* stream) const {
  deflateEnd(stream);
  delete stream;
}

Deflater::Deflater() {
  auto stream = std::make_unique<z_stream>();
  if (deflateInit(stream.get(), Z_DEFAULT_COMPRESSION) != Z_OK) throw std::bad_alloc();
  stream_.reset(stream.release());
}

void Deflater::run(int flush) {
  constexpr std::size_t room = 1 << 16;
  do {
    const std::size_t used = out_.size();
    out_.resize(used + room);
    stream_->next_out = reinterpret_cast<Bytef*>(out_.data() + used);
    stream_->avail_out = room;
    deflate(stream_.get(), flush);
    out_.resize(used + room - stream_->avail_out);
  } while (stream_->avail_out == 0);
}

void Deflater::add(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t most = 1 << 30;  // zlib counts in 32 bits
  while (!bytes.empty()) {
    const auto piece = bytes.first(std::min(bytes.size(), most));
    stream_->next_in = const_cast<Bytef*>(piece.data());
    stream_->avail_in = static_cast<uInt>(piece.size());
    run(Z_NO_FLUSH);
    bytes = bytes.subspan(piece.size());
  }
}

std::size_t Deflater::flush() {
  run(Z_SYNC_FLUSH);
  return out_.size();
}

std::string Deflater::finish() {
  run(Z_FINISH);
  return std::move(out_);
}

std::uint32_t crc(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

std::string base64(std::string_view bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t there = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (k < there ? static_cast<unsigned char>(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k) text += k <= there ? digits[three >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

}  // namespace ballpark::view
