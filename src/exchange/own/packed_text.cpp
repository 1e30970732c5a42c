#include "exchange/own/packed_text.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include <fmt/format.h>

#include "base/check.h"

namespace coaster::exchange {
namespace {

constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
constexpr int kRawDeflate = -15;  // zlib's windowBits: the largest window, without header and checksum
constexpr std::size_t kUnpackStep = std::size_t{64} << 10;  // bytes unpacked at once

base::Status damaged(std::string message) { return {base::Code::bad_file, std::move(message)}; }

// zlib reads through a pointer that is not const, but does not write.
Bytef* bytes_of(std::string_view text) { return reinterpret_cast<Bytef*>(const_cast<char*>(text.data())); }

std::string deflate_raw(std::string_view text) {
  constexpr int kMemory = 9;  // the maximum, for the best compression
  z_stream stream{};
  COASTER_CHECK(deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kRawDeflate, kMemory, Z_DEFAULT_STRATEGY) == Z_OK,
                "deflate starts if there is memory");
  std::string out(deflateBound(&stream, static_cast<uLong>(text.size())), '\0');
  stream.next_in = bytes_of(text), stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data()), stream.avail_out = static_cast<uInt>(out.size());
  const int ended = deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  COASTER_CHECK(ended == Z_STREAM_END, "the bound of deflate holds");
  return out;
}

base::Result<std::string> inflate_raw(std::string_view bytes, std::size_t most_bytes) {
  z_stream stream{};
  COASTER_CHECK(inflateInit2(&stream, kRawDeflate) == Z_OK, "inflate starts if there is memory");
  stream.next_in = bytes_of(bytes), stream.avail_in = static_cast<uInt>(bytes.size());
  std::string out;
  int state = Z_OK;
  while (state == Z_OK && out.size() <= most_bytes) {
    const std::size_t before = out.size();
    out.resize(before + std::min(kUnpackStep, most_bytes + 1 - before));
    stream.next_out = reinterpret_cast<Bytef*>(out.data()) + before;
    stream.avail_out = static_cast<uInt>(out.size() - before);
    state = inflate(&stream, Z_NO_FLUSH);
    out.resize(out.size() - stream.avail_out);
  }
  const bool all_read = stream.avail_in == 0;
  inflateEnd(&stream);
  if (out.size() > most_bytes) return damaged(fmt::format("it unpacks to more than {} bytes", most_bytes));
  if (state == Z_BUF_ERROR) return damaged("it is cut off");
  if (state != Z_STREAM_END || !all_read) return damaged("it is damaged");
  return out;
}

}  // namespace

std::string pack(std::string_view text) {
  const std::string bytes = deflate_raw(text);
  std::string packed;
  packed.reserve(bytes.size() * 4 / 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : bytes) {
    bits = bits << 8 | static_cast<unsigned char>(c);
    for (count += 8; count >= 6; count -= 6) packed += kAlphabet[bits >> (count - 6) & 63];
  }
  if (count > 0) packed += kAlphabet[bits << (6 - count) & 63];
  return packed;
}

base::Result<std::string> unpack(std::string_view packed, std::size_t most_bytes) {
  std::string bytes;
  bytes.reserve(packed.size() * 3 / 4);
  std::uint32_t bits = 0;
  int count = 0;
  for (std::size_t i = 0; i < packed.size(); ++i) {
    const std::size_t value = kAlphabet.find(packed[i]);
    if (value == std::string_view::npos)
      return damaged(fmt::format("character {} is none of A-Z, a-z, 0-9, - and _", i + 1));
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    if ((count += 6) >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 255);
  }
  return inflate_raw(bytes, most_bytes);
}

}  // namespace coaster::exchange
