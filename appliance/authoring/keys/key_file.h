// A picture as the keys of a deck take it.
#pragma once

#include <cstdint>
#include <vector>

#include "drivers/base/result.h"
#include "drivers/decode/stream_deck.h"
#include "render/image/png.h"

namespace kaori::authoring {

// The file for the keys of that shape, turned as they want it. The picture is upright, and as large as a key.
// Errors: invalid_argument (it is of another size), not_enough_memory.
Result<std::vector<std::uint8_t>> KeyFile(const image::Picture& picture, const decode::DeckShape& shape);

}  // namespace kaori::authoring
