// The content of a pack: a show as a FlatBuffer, without the header that guards it.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "appliance/core/show/pack_keys.h"
#include "appliance/core/show/show.h"
#include "drivers/base/result.h"

namespace kaori::show {

// The bytes of a show's content, with pictures of keys where there are some; DecodeContent and DecodeKeys are the
// inverse. Pure: equal shows give equal bytes. The show must be sound (see check.h), and the content smaller than
// kLargestPack_bytes; for a moment it takes at least twice its bytes of memory. Any thread.
std::vector<std::uint8_t> EncodeContent(const Show& show, const std::vector<KeyPicture>& keys = {});

// Safe for any bytes; `content` starts at a multiple of 16. Copies everything out, and never more bytes than
// the content has: a forged one in which tables share their arrays is refused, not unfolded. But where
// `keeper` keeps the content alive, textures stay in it, and hold on to the keeper. Does not check the show
// (see check.h). Errors:
//   invalid_argument  the words follow on a file's name: "is damaged: ..."
// A null keeper copies the textures as well.
Result<Show> DecodeContent(std::span<const std::uint8_t> content,
                           std::shared_ptr<const void> keeper = nullptr);

// The pictures of keys alone; as DecodeContent. Errors: also invalid_argument (more than the bounds of pack_keys.h).
Result<std::vector<KeyPicture>> DecodeKeys(std::span<const std::uint8_t> content);

// The sounds of its motions alone, in their order, an empty one for a motion without; as DecodeContent. Nothing else
// of the content is copied.
Result<std::vector<Sound>> DecodeSounds(std::span<const std::uint8_t> content);

}  // namespace kaori::show
