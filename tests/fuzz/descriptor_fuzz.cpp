// Any bytes as a report descriptor: the layout stays within its bounds, or a reason is given.
#include <cstdint>
#include <span>

#include "drivers/decode/recognise.h"
#include "drivers/decode/report_layout.h"
#include "tests/fuzz/check.h"

namespace kaori::fuzz {
namespace {

void CheckField(const decode::ReportLayout& layout, const decode::ReportField& field) {
  const decode::ReportShape* shape = layout.Find(field.kind, field.report_id);
  Promise(shape != nullptr, "a field belongs to a report");
  Promise(shape->bytes() < decode::kMaxReportBytes, "a report has a bounded length");
  Promise(field.bits >= 1 && field.bits <= decode::kMaxValueBits, "an element fits a value");
  Promise(field.count >= 1 && field.count <= decode::kMaxUsages, "elements are bounded");
  Promise(field.offset_bits + field.count * field.bits <= shape->bits, "a field lies in its report");
  Promise(field.logical_min <= field.logical_max, "a logical range is not empty");
  Promise(!layout.usages_of(field).empty(), "a field has a usage");
  for (const std::uint32_t n : {0u, field.count / 2, field.count - 1, 0xFFFFFFFFu}) layout.usage(field, n);
}

}  // namespace
}  // namespace kaori::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kaori;
  const auto layout = decode::ReadReportLayout({data, size});
  if (!layout) {
    fuzz::Promise(layout.error().attempt.starts_with("report descriptor, byte "), "a refusal names its byte");
    return 0;
  }
  for (const decode::ReportField& field : layout->fields) fuzz::CheckField(*layout, field);
  decode::Recognise(*layout);
  return 0;
}
