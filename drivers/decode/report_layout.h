// The layout of a HID device's reports, read from its report descriptor with every size bounded.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "drivers/base/result.h"

namespace kaori::decode {

// The bounds of Linux's parser (include/linux/hid.h): what Linux accepts is
// accepted here too. The descriptor comes from a device, which may claim anything:
// without bounds four bytes could ask for 4 GiB of fields.
inline constexpr std::size_t kMaxDescriptorBytes = 4096;
inline constexpr std::size_t kMaxUsages = 12288;  // For one main item.
// Fields with values; padding does not count.
inline constexpr std::size_t kMaxFieldsPerReport = 256;
// Globals that Push can save at a time.
inline constexpr std::size_t kMaxGlobalStack = 4;
inline constexpr std::size_t kMaxReportBytes = 16384;  // Report id included.
// Of one element; values of up to kMaxValueBits are read. Wider elements are for vendors' data.
inline constexpr std::uint32_t kMaxFieldBits = 256;
// A value of so many bits and any logical range fits into 64 bits with its sign.
inline constexpr std::uint32_t kMaxValueBits = 32;
// Our own bound: Linux is limited by its memory alone.
inline constexpr std::size_t kMaxCollectionDepth = 64;

// The three directions of HID: from the device, to it, and both ways on request. Each has ids of its own.
enum class ReportKind : std::uint8_t { kInput, kOutput, kFeature };

// A usage is its page in the high 16 bits and its id in the low ones: 0x00010030 is Generic Desktop X.
using Usage = std::uint32_t;

// The usages first..last, for the elements (or array values) from `start` on. One range stands for
// any number of elements, so that "every key" costs one entry.
struct UsageRange {
  // Both are included.
  Usage first = 0;
  Usage last = 0;
  // The number of the first element that they are for.
  std::uint32_t start = 0;
};

// One main item with data: `count` elements of `bits` bits each. Padding and elements of more than
// kMaxValueBits bits occupy bits of the report, but have no field.
struct ReportField {
  // The direction of its report.
  ReportKind kind = ReportKind::kInput;
  std::uint8_t report_id = 0;     // 0 where reports have no ids.
  bool is_array = false;          // An element names a usage; else every element has its own usage.
  bool is_relative = false;       // Change since the last report.
  bool wraps = false;             // Beyond the maximum comes the minimum.
  bool has_null = false;          // A value outside the logical range says "no value".
  std::uint32_t offset_bits = 0;  // From the first byte after the report id.
  std::uint32_t bits = 0;         // 1..32.
  // How many elements, or places of an array.
  std::uint32_t count = 0;
  std::int64_t logical_min = 0;  // Negative: elements are signed.
  std::int64_t logical_max = 0;
  Usage application = 0;  // The application collection around it; 0 without one.
  // The field's ranges are those of ReportLayout::usages from here up
  // to, but without, usages_end: at least one.
  std::uint32_t usages_begin = 0;
  // The index behind the last of its ranges.
  std::uint32_t usages_end = 0;
};

// One report: its id and its length, which an input report must have exactly.
struct ReportShape {
  // With the id it names the report.
  ReportKind kind = ReportKind::kInput;
  std::uint8_t id = 0;
  std::uint32_t bits = 0;  // Without the report id.
  // How many of ReportLayout::fields it has; padding has none.
  std::uint32_t fields = 0;

  // Rounded up: a report is sent in whole bytes.
  std::size_t bytes() const { return (bits + 7u) / 8u; }
};

// All reports of a device, as its decoder needs them. Made once when a device is opened; reading by it
// allocates nothing. Collections are flattened: of the tree only the application is kept.
struct ReportLayout {
  // In the order in which the descriptor speaks of them first.
  std::vector<ReportShape> reports;
  std::vector<ReportField> fields;  // In the order of the descriptor.
  // Of all fields, one behind the other.
  std::vector<UsageRange> usages;

  // The usage ranges of `field`, which must be one of `fields`.
  std::span<const UsageRange> usages_of(const ReportField& field) const;
  // The usage of element `index`; in an array, of the value logical_min + index. Elements beyond the last
  // usage have that last one (HID 1.11, section 6.2.2.8); values beyond an array's last usage have none: 0.
  Usage usage(const ReportField& field, std::uint32_t index) const;
  // Null where the device has no such report. Valid until the layout changes.
  const ReportShape* Find(ReportKind kind, std::uint8_t id) const;
  // True when reports of `kind` begin with their id (HID 1.11, section 5.6: all of a kind do, or none).
  bool numbered(ReportKind kind) const;
};

// Parses a report descriptor. Pure; time and memory are bounded by the limits above. What has no meaning
// for our decoders (physical ranges, units, designators, strings) is passed over. Errors:
//   invalid_argument  the attempt says what is wrong, and at which byte
Result<ReportLayout> ReadReportLayout(std::span<const std::uint8_t> descriptor);

}  // namespace kaori::decode
