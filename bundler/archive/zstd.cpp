// See zstd.hpp. libzstd is known here only.
#include "bundler/archive/zstd.hpp"

#include <zstd.h>

#include <algorithm>
#include <memory>

namespace ros2wasm {
namespace {

constexpr std::uint64_t kMostPromised = 64ULL << 20U;

Diagnostic damaged(const std::string& name, const std::string& why) {
  return Diagnostic{.code = "R2W0202",
                    .kind = FailureKind::kEnvironment,
                    .message = "`" + name + "` cannot be decompressed",
                    .why = {why}};
}

}  // namespace

std::string zstd_compressed(std::string_view bytes, int level) {
  const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(),
                                                                     ZSTD_freeCCtx);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, level);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
  std::string out(ZSTD_compressBound(bytes.size()), '\0');
  out.resize(ZSTD_compress2(context.get(), out.data(), out.size(), bytes.data(), bytes.size()));
  return out;
}

Outcome<Done> zstd_decompress(std::string_view bytes, std::uint64_t limit_bytes,
                              const std::string& name,
                              const std::function<Outcome<Done>(std::string_view)>& take) {
  const std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context(ZSTD_createDCtx(),
                                                                     ZSTD_freeDCtx);
  // No more than what is in it, as far as that is known: small files come in thousands.
  const std::size_t piece_size = std::clamp<std::size_t>(
      ZSTD_getFrameContentSize(bytes.data(), bytes.size()), 1024, 8 * ZSTD_DStreamOutSize());
  const auto piece = std::make_unique_for_overwrite<char[]>(piece_size);
  ZSTD_inBuffer input{bytes.data(), bytes.size(), 0};
  std::size_t state = 0;
  std::uint64_t total = 0;
  while (input.pos < input.size || state != 0) {
    ZSTD_outBuffer output{piece.get(), piece_size, 0};
    const std::size_t read_before = input.pos;
    state = ZSTD_decompressStream(context.get(), &output, &input);
    if (ZSTD_isError(state) != 0) return damaged(name, ZSTD_getErrorName(state));
    total += output.pos;
    if (total > limit_bytes)
      return damaged(name, "it holds more than " + std::to_string(limit_bytes) + " bytes");
    if (output.pos == 0 && input.pos == read_before) return damaged(name, "it ends too early");
    if (auto taken = take({piece.get(), output.pos}); !taken) return taken;
  }
  return Done{};
}

Outcome<std::string> zstd_decompressed(std::string_view bytes, std::uint64_t limit_bytes,
                                       const std::string& name) {
  std::string out;
  // As far as it is known how much comes; what an attacker promises is not made room for.
  const std::uint64_t promised = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  if (promised <= std::min(limit_bytes, kMostPromised)) out.reserve(promised);
  auto done = zstd_decompress(bytes, limit_bytes, name, [&out](std::string_view piece) {
    out += piece;
    return Outcome<Done>(Done{});
  });
  if (!done) return std::move(done).errors();
  return out;
}

}  // namespace ros2wasm
