// The items of a HID report descriptor, one after another (HID 1.11, section 6.2.2).
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "drivers/base/result.h"

namespace kaori::decode {

enum class ItemType : std::uint8_t { kMain = 0, kGlobal = 1, kLocal = 2, kReserved = 3 };

struct Item {
  ItemType type = ItemType::kMain;
  std::uint8_t tag = 0;
  std::uint8_t data_bytes = 0;       // 0, 1, 2 or 4.
  std::uint32_t unsigned_value = 0;  // The data, widened with zeros.
  std::int32_t signed_value = 0;     // The data, widened with its sign.
  std::size_t offset_bytes = 0;      // Of the item in the descriptor.
};

// Walks over a descriptor. Long items, for which HID defines no use, are stepped over.
class ItemReader {
 public:
  // Borrows `descriptor`.
  explicit ItemReader(std::span<const std::uint8_t> descriptor) : descriptor_(descriptor) {}

  // The next item; nothing at the end. Errors: invalid_argument  the descriptor ends inside an item.
  Result<std::optional<Item>> Next();

 private:
  Result<void> SkipLongItem();
  Item ParseShortItem(std::uint8_t data_bytes);

  std::span<const std::uint8_t> descriptor_;
  std::size_t at_ = 0;
};

// "report descriptor, byte 12: <reason>", with the cause invalid_argument.
tl::unexpected<Error> FailAt(std::size_t offset_bytes, std::string_view reason);

}  // namespace kaori::decode
