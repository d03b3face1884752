#include "appliance/programs/input/input_service.h"

namespace kaori::input {

// All or none: writers that were acquired before the one that fails are given back when this returns.
Result<InputWriters> InputWriters::Acquire(const board::Board& board) {
  auto surface = board.AcquireWriter<board::Surface>();
  if (!surface) return tl::unexpected(surface.error());
  auto left = board.AcquireWriter<board::Stick>(0);
  if (!left) return tl::unexpected(left.error());
  auto right = board.AcquireWriter<board::Stick>(1);
  if (!right) return tl::unexpected(right.error());
  auto keys = board.AcquireWriter<board::Keys>();
  if (!keys) return tl::unexpected(keys.error());
  auto pointer = board.AcquireWriter<board::Pointer>();
  if (!pointer) return tl::unexpected(pointer.error());
  auto lines = board.AcquireWriter<board::Lines>();
  if (!lines) return tl::unexpected(lines.error());
  auto calls = board::Caller::Acquire(board, board::CallWriter::kInput);
  if (!calls) return tl::unexpected(calls.error());
  auto midi = board.AcquireWriter<board::MidiHeard>();
  if (!midi) return tl::unexpected(midi.error());
  return InputWriters{std::move(*surface), {std::move(*left), std::move(*right)},
                      std::move(*keys),    std::move(*pointer),
                      std::move(*lines),   std::move(*calls),
                      std::move(*midi)};
}

}  // namespace kaori::input
