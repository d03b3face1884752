#include "drivers/decode/recognise.h"

#include <algorithm>

#include <fmt/format.h>

#include "drivers/decode/known_descriptors.h"
#include "drivers/decode/report_values.h"
#include "drivers/decode/usages.h"

namespace kaori::decode {
namespace {

// Turns without end: it tells changes, or positions that wrap.
bool HasEndlessDial(const ReportLayout& layout) {
  return std::ranges::any_of(FindInputs(layout, kUsageDial, kMaxFieldsPerReport), [&](ElementRef ref) {
    return layout.fields[ref.field].is_relative || layout.fields[ref.field].wraps;
  });
}

// Only within a joystick's collection: mice have X and Y too, and so have tablets.
bool HasAxis(const ReportLayout& layout, Usage usage) {
  return std::ranges::any_of(FindInputs(layout, usage, kMaxFieldsPerReport), [&](ElementRef ref) {
    const ReportField& field = layout.fields[ref.field];
    const Usage a = field.application;
    return !field.is_relative && (a == kUsageJoystick || a == kUsageGamePad || a == kUsageMultiAxis);
  });
}

// Relative or absolute.
bool Points(const ReportLayout& layout, Usage usage) {
  return std::ranges::any_of(FindInputs(layout, usage, kMaxFieldsPerReport), [&](ElementRef ref) {
    const Usage a = layout.fields[ref.field].application;
    return a == kUsageMouse || a == kUsagePointer;
  });
}

// A mouse with a keyboard collection for its extra buttons has no keys, so usages are asked too.
bool HasKeys(const ReportLayout& layout) {
  return std::ranges::any_of(layout.fields, [&](const ReportField& field) {
    const bool is_keyboard = field.application == kUsageKeyboard || field.application == kUsageKeypad;
    return field.kind == ReportKind::kInput && is_keyboard && HoldsPage(layout, field, kKeyboardPage);
  });
}

}  // namespace

DeviceKind Recognise(const ReportLayout& layout) {
  // The order decides for devices that are several of these: a dial box may have a stick.
  if (HasEndlessDial(layout)) return DeviceKind::kDialBox;
  if (HasAxis(layout, kUsageX) && HasAxis(layout, kUsageY)) return DeviceKind::kJoystick;
  if (HasKeys(layout)) return DeviceKind::kKeyboard;
  if (Points(layout, kUsageX) && Points(layout, kUsageY)) return DeviceKind::kPointer;
  return DeviceKind::kOther;
}

Result<ReportLayout> LayoutOf(const ports::HidIdentity& identity) {
  const auto known = KnownDescriptor(identity.vendor, identity.product);
  auto layout = ReadReportLayout(known.empty() ? std::span(identity.descriptor) : known);
  if (layout) return layout;
  // Several devices may be plugged in: the port tells which one is meant.
  return FailAs(layout.error(), fmt::format("{}: {}", identity.port, layout.error().attempt));
}

}  // namespace kaori::decode
