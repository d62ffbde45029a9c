// See deflate.hpp. zlib is known here only.
#include "bundler/archive/deflate.hpp"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <new>

namespace ros2wasm {
namespace {

constexpr int kWithoutHeader = -15;  // the largest window
constexpr int kMemory = 9;
/// Deflate, no flags, no time, as small as it gets, from Unix.
constexpr std::string_view kGzipHeader("\x1f\x8b\x08\0\0\0\0\0\2\3", 10);
constexpr std::size_t kGzipEnd = 8;
constexpr std::size_t kPiece = std::size_t{1} << 20U;

/// zlib counts in 32 bits: it is given a part at a time.
uInt part_of(std::size_t rest) {
  return static_cast<uInt>(std::min<std::size_t>(rest, std::numeric_limits<uInt>::max()));
}

Diagnostic damaged(const std::string& name, std::string why) {
  return Diagnostic{.code = "R2W0202",
                    .kind = FailureKind::kEnvironment,
                    .message = "`" + name + "` cannot be decompressed",
                    .why = {std::move(why)}};
}

Bytef* bytes_of(const char* text) {
  return reinterpret_cast<Bytef*>(const_cast<char*>(text));  // NOLINT: zlib reads them only
}

/// Sum and size, least significant byte first.
std::string gzip_end(std::string_view bytes) {
  std::uint32_t sum = 0;
  for (std::size_t at = 0; at < bytes.size(); at += kPiece) {
    const std::string_view part = bytes.substr(at, kPiece);
    sum = static_cast<std::uint32_t>(crc32(sum, bytes_of(part.data()), part_of(part.size())));
  }
  std::string end;
  for (const std::uint32_t number : {sum, static_cast<std::uint32_t>(bytes.size())}) {
    for (unsigned shift = 0; shift < 32; shift += 8) end += static_cast<char>(number >> shift);
  }
  return end;
}

}  // namespace

std::string deflated(std::string_view bytes) {
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kWithoutHeader, kMemory,
                   Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
  std::string out;
  std::string piece(kPiece, '\0');
  std::size_t given = 0;
  int state = Z_OK;
  while (state != Z_STREAM_END) {
    if (stream.avail_in == 0 && given < bytes.size()) {
      stream.next_in = bytes_of(bytes.data() + given);
      stream.avail_in = part_of(bytes.size() - given);
      given += stream.avail_in;
    }
    stream.next_out = bytes_of(piece.data());
    stream.avail_out = part_of(piece.size());
    state = deflate(&stream, given == bytes.size() ? Z_FINISH : Z_NO_FLUSH);
    out.append(piece.data(), piece.size() - stream.avail_out);
  }
  deflateEnd(&stream);
  return out;
}

std::string gzipped(std::string_view bytes) {
  return std::string(kGzipHeader) + deflated(bytes) + gzip_end(bytes);
}

Outcome<std::string> gunzipped(std::string_view bytes, std::uint64_t limit_bytes,
                               const std::string& name) {
  if (!bytes.starts_with(kGzipHeader) || bytes.size() < kGzipHeader.size() + kGzipEnd)
    return damaged(name, "it does not begin as what ros2wasm writes");
  const std::string_view end = bytes.substr(bytes.size() - kGzipEnd);
  bytes.remove_prefix(kGzipHeader.size());
  bytes.remove_suffix(kGzipEnd);
  auto inside = inflated(bytes, limit_bytes, name);
  if (inside && gzip_end(*inside) != end) return damaged(name, "its sum is another one");
  return inside;
}

Outcome<std::string> inflated(std::string_view bytes, std::uint64_t limit_bytes,
                              const std::string& name) {
  z_stream stream{};
  if (inflateInit2(&stream, kWithoutHeader) != Z_OK) throw std::bad_alloc();
  const std::unique_ptr<z_stream, decltype(&inflateEnd)> end(&stream, inflateEnd);
  std::string out;
  std::string piece(std::min<std::uint64_t>(kPiece, limit_bytes + 1), '\0');
  std::size_t given = 0;
  int state = Z_OK;
  while (state != Z_STREAM_END) {
    if (stream.avail_in == 0) {
      if (given == bytes.size()) return damaged(name, "it ends too early");
      stream.next_in = bytes_of(bytes.data() + given);
      stream.avail_in = part_of(bytes.size() - given);
      given += stream.avail_in;
    }
    stream.next_out = bytes_of(piece.data());
    stream.avail_out = part_of(piece.size());
    state = inflate(&stream, Z_NO_FLUSH);
    if (state != Z_OK && state != Z_STREAM_END && state != Z_BUF_ERROR)
      return damaged(name, stream.msg == nullptr ? "it is damaged" : stream.msg);
    out.append(piece.data(), piece.size() - stream.avail_out);
    if (out.size() > limit_bytes)
      return damaged(name, "it holds more than " + std::to_string(limit_bytes) + " bytes");
  }
  return out;
}

}  // namespace ros2wasm
