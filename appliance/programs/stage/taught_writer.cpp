#include "appliance/programs/stage/taught_writer.h"

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "appliance/core/roles/roles_file.h"
#include "drivers/base/folder.h"
#include "drivers/base/log.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::stage {

TaughtWriter::TaughtWriter(const OwnRoles& own)
    : own_(own), writer_(std::chrono::milliseconds(0), [this] {
        const auto written = WriteOut();
        if (!written) LogWarning("what was taught is not kept: {}", written.error().message());
        failed_.store(!written, std::memory_order_release);
        return true;  // What was refused is asked for again by a person, or not at all.
      }) {}

void TaughtWriter::Write(const Lesson& lesson) {
  lesson_ = lesson;
  writer_.Ask(/*at_once=*/true);
}

// The file is read each time: a person may have changed it meanwhile. The copy is written before the file, so
// that there is none without the other.
Result<void> TaughtWriter::WriteOut() {
  const std::string name = own_.file.string();
  std::string before;
  if (IsThere(own_.file)) {
    auto text = ReadFile(own_.file);
    if (!text) return tl::unexpected(text.error());
    before = std::move(*text);
  }
  const auto teach = [&](const auto& taught) {
    return roles::Teach(before, name, own_.items, own_.below, taught);
  };
  const auto text = std::visit(teach, lesson_);
  if (!text) return tl::unexpected(text.error());
  std::error_code error;
  std::filesystem::create_directories(own_.file.parent_path(), error);
  if (error)
    return Fail(static_cast<std::errc>(error.value()), "make the folder " + own_.file.parent_path().string());
  if (!before.empty())
    if (auto kept = WriteWholeFile(name + ".before", {AsBytes(before)}); !kept) return kept;
  if (auto written = WriteWholeFile(own_.file, {AsBytes(*text)}); !written) return written;
  laid_ = own_.below;
  roles::Besides besides;
  const auto faults = roles::LayOverText(*text, name, own_.items, laid_, besides);
  return faults.empty() ? Result<void>{} : FailInput(fmt::format("{}", fmt::join(faults, "; ")));
}

}  // namespace kaori::stage
