#include "appliance/core/update/compression.h"

#include <zstd.h>

namespace kaori::update {
namespace {

// zstd's. As images and those of boards are weighed (rootfs/image/pack.py).
constexpr int kQuickLevel = 12, kSmallestLevel = 19;

}  // namespace

// libzstd's, freed with this.
struct Unpacker::Context {
  std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> zstd{ZSTD_createDCtx(), ZSTD_freeDCtx};
};

Unpacker::Unpacker() : context_(std::make_unique<Context>()) {
  ZSTD_DCtx_setParameter(context_->zstd.get(), ZSTD_d_windowLogMax, kWindow_log2);
}
Unpacker::~Unpacker() = default;
Unpacker::Unpacker(Unpacker&&) noexcept = default;
Unpacker& Unpacker::operator=(Unpacker&&) noexcept = default;

// libzstd is asked again while it takes or gives anything: it may hold content back of a packed text that it has
// read whole.
Result<std::size_t> Unpacker::Unpack(std::span<const std::uint8_t>& packed, std::span<std::uint8_t> into) {
  ZSTD_inBuffer in{packed.data(), packed.size(), 0};
  ZSTD_outBuffer out{into.data(), into.size(), 0};
  while (!ended_ && out.pos < out.size) {
    const std::size_t read = in.pos, given = out.pos;
    const std::size_t left = ZSTD_decompressStream(context_->zstd.get(), &out, &in);
    if (ZSTD_isError(left) != 0) return FailInput("is damaged: a part of it cannot be unpacked");
    ended_ = left == 0;
    if (in.pos == read && out.pos == given) break;
  }
  packed = packed.subspan(in.pos);
  return out.pos;
}

Result<std::vector<std::uint8_t>> Pack(std::span<const std::uint8_t> content, Packing packing) {
  const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(), ZSTD_freeCCtx);
  std::vector<std::uint8_t> packed(ZSTD_compressBound(content.size()));
  if (!context) return Fail(std::errc::not_enough_memory, "pack a part of an update");
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel,
                         packing == Packing::kSmallest ? kSmallestLevel : kQuickLevel);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_windowLog, kWindow_log2);
  const std::size_t bytes =
      ZSTD_compress2(context.get(), packed.data(), packed.size(), content.data(), content.size());
  if (ZSTD_isError(bytes) != 0) return Fail(std::errc::not_enough_memory, "pack a part of an update");
  packed.resize(bytes);
  return packed;
}

}  // namespace kaori::update
