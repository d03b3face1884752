// Splits a HID report descriptor into its items (HID 1.11, section 6.2.2).
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "drivers/base/result.h"

namespace kaori::decode {

// HID 1.11, section 6.2.2.2: main items make fields, global ones hold until they are
// changed, local ones hold for the next main item alone.
enum class ItemType : std::uint8_t { kMain = 0, kGlobal = 1, kLocal = 2, kReserved = 3 };

// One short item (HID 1.11, section 6.2.2.2). Whether its data are signed
// depends on the tag, so both readings are here.
struct Item {
  // Which of the three groups of items; reserved ones are passed over.
  ItemType type = ItemType::kMain;
  // Which item of its group (HID 1.11, sections 6.2.2.4, 6.2.2.7 and 6.2.2.8).
  std::uint8_t tag = 0;
  std::uint8_t data_bytes = 0;       // 0, 1, 2 or 4.
  std::uint32_t unsigned_value = 0;  // The data, widened with zeros.
  std::int32_t signed_value = 0;     // The data, widened with its sign.
  std::size_t offset_bytes = 0;      // Of the item in the descriptor.
};

// Reads one item after the other, from the first byte to the last. Long items, for which HID defines no
// use, are skipped. Every call steps on or fails, so that a loop over any bytes ends. Pure.
class ItemReader {
 public:
  // `descriptor` must outlive the reader.
  explicit ItemReader(std::span<const std::uint8_t> descriptor) : descriptor_(descriptor) {}

  // The next item; none at the end. Errors: invalid_argument (the descriptor ends inside an item).
  Result<std::optional<Item>> Next();

 private:
  // Steps over the long item at `at_`, and fails where the descriptor ends within it.
  Result<void> SkipLongItem();
  // The short item at `at_`, whose data were checked to be there; steps over it.
  Item ParseShortItem(std::uint8_t data_bytes);

  std::span<const std::uint8_t> descriptor_;
  // The byte at which the next item begins.
  std::size_t at_ = 0;
};

// An invalid_argument with the attempt "report descriptor, byte 12: <reason>". The byte is
// where the item begins, so that a person finds it in a dump.
tl::unexpected<Error> FailAt(std::size_t offset_bytes, std::string_view reason);

}  // namespace kaori::decode
