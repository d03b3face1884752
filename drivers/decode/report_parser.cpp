// ReadReportLayout: the state that a descriptor's items build up, and what a main item makes of it.
#include <algorithm>

#include "drivers/decode/report_items.h"
#include "drivers/decode/report_layout.h"
#include "drivers/decode/usage_list.h"

namespace kaori::decode {
namespace {

// Tags of items: HID 1.11, sections 6.2.2.4 and 6.2.2.7.
enum class MainTag : std::uint8_t {
  kInput = 8,
  kOutput = 9,
  kCollection = 10,
  kFeature = 11,
  kEndCollection = 12
};
enum class GlobalTag : std::uint8_t {
  kUsagePage = 0,
  kLogicalMin = 1,
  kLogicalMax = 2,
  kReportSize = 7,
  kReportId = 8,
  kReportCount = 9,
  kPush = 10,
  kPop = 11
};

// Bits of an input, output or feature item: HID 1.11, section 6.2.2.5.
constexpr std::uint32_t kConstant = 1u << 0, kVariable = 1u << 1, kRelative = 1u << 2, kWrap = 1u << 3,
                        kNullState = 1u << 6;
constexpr std::uint32_t kApplication = 1;  // Kind of collection.

// The global items, which count until they are changed. Push and pop save and restore all of them. The
// physical range and the units are not among them: decoders scale by the logical range alone.
struct Globals {
  std::uint32_t page = 0;
  std::int64_t logical_min = 0;
  std::int64_t logical_max = 0;
  std::uint32_t size_bits = 0;
  std::uint32_t count = 0;
  std::uint8_t report_id = 0;
};

// A collection that is open, by its kind and its usage.
struct Collection {
  std::uint32_t kind = 0;
  Usage usage = 0;
};

// The state that items build up. Used once for one descriptor. A failed item leaves the
// parser half applied, so it is not used any further.
class Parser {
 public:
  Result<ReportLayout> Run(std::span<const std::uint8_t> descriptor);

 private:
  // Each applies one item. Their errors are invalid_argument with the item's byte.
  Result<void> Apply(const Item& item);
  Result<void> ApplyMain(const Item& item);
  Result<void> ApplyGlobal(const Item& item);
  Result<void> Begin(const Item& item);
  Result<void> End(const Item& item);
  Result<void> AddField(const Item& item, ReportKind kind);
  Result<void> SetReportId(const Item& item);
  Result<void> Push(const Item& item);
  Result<void> Pop(const Item& item);
  // The report of the present id, made where it is new.
  ReportShape& ShapeOf(ReportKind kind);
  // The usage of the innermost application collection that is open; 0: none.
  Usage Application() const;

  ReportLayout layout_;
  Globals globals_;
  UsageList usages_;
  std::vector<Globals> stack_;
  std::vector<Collection> collections_;
};

Result<ReportLayout> Parser::Run(std::span<const std::uint8_t> descriptor) {
  if (descriptor.empty()) return FailAt(0, "the descriptor is empty");
  if (descriptor.size() > kMaxDescriptorBytes)
    return FailAt(kMaxDescriptorBytes, "the descriptor is too long");
  ItemReader items(descriptor);
  while (true) {
    const auto item = items.Next();
    if (!item) return tl::unexpected(item.error());
    if (!*item) break;
    if (auto ok = Apply(**item); !ok) return tl::unexpected(ok.error());
  }
  // Linux refuses these too: the device means something else than it says.
  if (!collections_.empty()) return FailAt(descriptor.size(), "a collection is not ended");
  if (usages_.delimiter_open()) return FailAt(descriptor.size(), "a delimiter is not closed");
  return std::move(layout_);
}

// Items of the reserved type are passed over, as Linux does.
Result<void> Parser::Apply(const Item& item) {
  switch (item.type) {
    case ItemType::kMain:
      return ApplyMain(item);
    case ItemType::kGlobal:
      return ApplyGlobal(item);
    case ItemType::kLocal:
      return usages_.Apply(item);
    case ItemType::kReserved:
      return {};
  }
  return {};
}

Result<void> Parser::ApplyMain(const Item& item) {
  Result<void> done;
  switch (static_cast<MainTag>(item.tag)) {
    case MainTag::kInput:
      done = AddField(item, ReportKind::kInput);
      break;
    case MainTag::kOutput:
      done = AddField(item, ReportKind::kOutput);
      break;
    case MainTag::kFeature:
      done = AddField(item, ReportKind::kFeature);
      break;
    case MainTag::kCollection:
      done = Begin(item);
      break;
    case MainTag::kEndCollection:
      done = End(item);
      break;
    default:
      break;  // Reserved: no meaning yet.
  }
  // Local items count for one main item only.
  usages_ = {};
  return done;
}

Result<void> Parser::ApplyGlobal(const Item& item) {
  switch (static_cast<GlobalTag>(item.tag)) {
    case GlobalTag::kUsagePage:
      globals_.page = item.unsigned_value & 0xFFFFu;
      return {};
    case GlobalTag::kLogicalMin:
      globals_.logical_min = item.signed_value;
      return {};
    case GlobalTag::kLogicalMax:
      // Devices that mean 255 write FF: signed only beside a negative minimum, as Linux has it.
      globals_.logical_max = globals_.logical_min < 0 ? std::int64_t{item.signed_value} : item.unsigned_value;
      return {};
    case GlobalTag::kReportSize:
      if (item.unsigned_value > kMaxFieldBits) return FailAt(item.offset_bytes, "an element is too wide");
      globals_.size_bits = item.unsigned_value;
      return {};
    case GlobalTag::kReportCount:
      if (item.unsigned_value > kMaxUsages) return FailAt(item.offset_bytes, "too many elements");
      globals_.count = item.unsigned_value;
      return {};
    case GlobalTag::kReportId:
      return SetReportId(item);
    case GlobalTag::kPush:
      return Push(item);
    case GlobalTag::kPop:
      return Pop(item);
    default:
      return {};  // Physical range, units: no decoder of ours asks.
  }
}

// 0 is reserved: HID 1.11, section 6.2.2.7.
Result<void> Parser::SetReportId(const Item& item) {
  if (item.unsigned_value == 0 || item.unsigned_value > 255)
    return FailAt(item.offset_bytes, "a report id must be 1 to 255");
  globals_.report_id = static_cast<std::uint8_t>(item.unsigned_value);
  return {};
}

// The stack is bounded, since the descriptor comes from a device.
Result<void> Parser::Push(const Item& item) {
  if (stack_.size() >= kMaxGlobalStack) return FailAt(item.offset_bytes, "more than 4 pushes");
  stack_.push_back(globals_);
  return {};
}

Result<void> Parser::Pop(const Item& item) {
  if (stack_.empty()) return FailAt(item.offset_bytes, "a pop without a push");
  globals_ = stack_.back();
  stack_.pop_back();
  return {};
}

// The kind is the lowest byte; the higher ones are reserved.
Result<void> Parser::Begin(const Item& item) {
  if (collections_.size() >= kMaxCollectionDepth)
    return FailAt(item.offset_bytes, "collections nest too deep");
  collections_.push_back({item.unsigned_value & 0xFFu, usages_.first(globals_.page)});
  return {};
}

Result<void> Parser::End(const Item& item) {
  if (collections_.empty()) return FailAt(item.offset_bytes, "an end without a collection");
  collections_.pop_back();
  return {};
}

Usage Parser::Application() const {
  const auto it = std::find_if(collections_.rbegin(), collections_.rend(),
                               [](const auto& c) { return c.kind == kApplication; });
  return it == collections_.rend() ? 0 : it->usage;
}

// The report of the current id and this kind; made with its first field. Fields of one report may be spread
// over the descriptor, and follow each other in the report all the same.
ReportShape& Parser::ShapeOf(ReportKind kind) {
  const std::uint8_t id = globals_.report_id;
  const auto it =
      std::ranges::find_if(layout_.reports, [&](const auto& r) { return r.kind == kind && r.id == id; });
  if (it != layout_.reports.end()) return *it;
  return layout_.reports.emplace_back(ReportShape{.kind = kind, .id = id});
}

Result<void> Parser::AddField(const Item& item, ReportKind kind) {
  // No value would be in range: decoders divide by the range.
  if (globals_.logical_max < globals_.logical_min)
    return FailAt(item.offset_bytes, "the logical range is empty");
  ReportShape& shape = ShapeOf(kind);
  const std::uint32_t offset_bits = shape.bits;
  // At most 256 bits times 12288 elements: the sum of 32 bits cannot overflow before it is compared.
  shape.bits += globals_.size_bits * globals_.count;
  if (shape.bits > (kMaxReportBytes - 1) * 8) return FailAt(item.offset_bytes, "a report is too long");
  // Padding, and fields without a usage, occupy bits and have no values.
  const bool holds_nothing = (item.unsigned_value & kConstant) != 0 || usages_.empty() ||
                             globals_.count == 0 || globals_.size_bits == 0;
  if (holds_nothing || globals_.size_bits > kMaxValueBits) return {};
  // The bound counts fields with values alone: padding between single bits must not use it up.
  if (++shape.fields > kMaxFieldsPerReport) return FailAt(item.offset_bytes, "too many fields in a report");
  ReportField field{.kind = kind,
                    .report_id = globals_.report_id,
                    .is_array = (item.unsigned_value & kVariable) == 0,
                    .is_relative = (item.unsigned_value & kRelative) != 0,
                    .wraps = (item.unsigned_value & kWrap) != 0,
                    .has_null = (item.unsigned_value & kNullState) != 0,
                    .offset_bits = offset_bits,
                    .bits = globals_.size_bits,
                    .count = globals_.count,
                    .logical_min = globals_.logical_min,
                    .logical_max = globals_.logical_max,
                    .application = Application()};
  // Ranges of all fields are in one vector: a field has its first index and its end.
  field.usages_begin = static_cast<std::uint32_t>(layout_.usages.size());
  usages_.AppendTo(layout_.usages, globals_.page);
  field.usages_end = static_cast<std::uint32_t>(layout_.usages.size());
  layout_.fields.push_back(field);
  return {};
}

}  // namespace

Result<ReportLayout> ReadReportLayout(std::span<const std::uint8_t> descriptor) {
  return Parser{}.Run(descriptor);
}

}  // namespace kaori::decode
