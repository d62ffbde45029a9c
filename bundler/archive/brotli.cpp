// See brotli.hpp. libbrotli is known here only.
#include "bundler/archive/brotli.hpp"

#include <brotli/decode.h>
#include <brotli/encode.h>

#include <algorithm>
#include <memory>
#include <new>

namespace ros2wasm {
namespace {

constexpr std::size_t kBrotliPiece = std::size_t{1} << 16U;

const std::uint8_t* bytes_of(std::string_view text) {
  return reinterpret_cast<const std::uint8_t*>(text.data());  // NOLINT: bytes are bytes
}

std::uint8_t* bytes_of(std::string& text) {
  return reinterpret_cast<std::uint8_t*>(text.data());  // NOLINT: bytes are bytes
}

}  // namespace

std::string brotli_compressed(std::string_view bytes) {
  std::string out(BrotliEncoderMaxCompressedSize(bytes.size()), '\0');
  std::size_t size = out.size();
  if (BrotliEncoderCompress(BROTLI_MAX_QUALITY, BROTLI_MAX_WINDOW_BITS, BROTLI_MODE_GENERIC,
                            bytes.size(), bytes_of(bytes), &size, bytes_of(out)) == BROTLI_FALSE)
    throw std::bad_alloc();
  out.resize(size);
  return out;
}

Outcome<std::string> brotli_unpacked(std::string_view bytes, std::uint64_t limit_bytes,
                                     const std::string& name) {
  const std::unique_ptr<BrotliDecoderState, decltype(&BrotliDecoderDestroyInstance)> state(
      BrotliDecoderCreateInstance(nullptr, nullptr, nullptr), &BrotliDecoderDestroyInstance);
  if (!state) throw std::bad_alloc();
  std::string out;
  std::string piece(kBrotliPiece, '\0');
  std::size_t left = bytes.size();
  const std::uint8_t* next = bytes_of(bytes);
  BrotliDecoderResult result = BROTLI_DECODER_RESULT_NEEDS_MORE_OUTPUT;
  while (result == BROTLI_DECODER_RESULT_NEEDS_MORE_OUTPUT && out.size() <= limit_bytes) {
    std::size_t room = piece.size();
    std::uint8_t* place = bytes_of(piece);
    result = BrotliDecoderDecompressStream(state.get(), &left, &next, &room, &place, nullptr);
    out.append(piece.data(), piece.size() - room);
  }
  if (result == BROTLI_DECODER_RESULT_SUCCESS && left == 0 && out.size() <= limit_bytes) return out;
  return Diagnostic{
      .code = "R2W0202",
      .kind = FailureKind::kEnvironment,
      .message = "`" + name + "` cannot be decompressed",
      .why = {out.size() > limit_bytes ? "more comes out than it should have" : "it is damaged"}};
}

}  // namespace ros2wasm
