#include "appliance/programs/boot/report.h"

#include <fcntl.h>
#include <unistd.h>

#include "drivers/base/unique_fd.h"

namespace kaori::boot {
namespace {

// In the order of Trouble.
constexpr std::array<std::string_view, kTroubles> kJapanese{
    "",
    "設定 (box.toml) に間違いがあります。間違いのない前の設定で動きます。直して入れ直してください",
    "このPCは時刻を忘れていました。ファームウェアの設定で時計をUTCに合わせてください",
    "グラフィックカードをこの箱では使えないか、メーカーのファイルが足りません。担当者に知らせてください",
    "データの領域に問題があります。設定や記録が残らないことがあります。担当者に知らせてください",
    "ネットワークにつながりません。ケーブルとカードを確かめてください",
    "バックアップを復元しました。前の内容は残っています",
    "復元できませんでした。もう一度バックアップを入れてください",
};

// There is one thread, and one start.
std::string g_reported;

}  // namespace

std::string_view InJapanese(Trouble trouble) {
  return kJapanese[static_cast<std::size_t>(trouble)];
}

// "<4>" is the severity of a warning.
std::string RecordOf(const Fault& fault) {
  const std::string_view japanese = InJapanese(fault.trouble);
  return "<4>kaori-boot: " + fault.line + (japanese.empty() ? "" : " / ") + std::string(japanese) + "\n";
}

// One write is one record of /dev/kmsg. Two faults of one trouble have the same Japanese words, which are kept once.
void Report(const std::string& line, Trouble trouble) {
  g_reported += line + "\n";
  const std::string below = std::string(InJapanese(trouble)) + "\n";
  if (below.size() > 1 && g_reported.find("\n" + below) == std::string::npos) g_reported += below;
  const std::string record = RecordOf({line, trouble});
  const UniqueFd log(::open("/dev/kmsg", O_WRONLY | O_CLOEXEC));
  [[maybe_unused]] const auto written = ::write(log.get(), record.data(), record.size());
}

const std::string& Reported() {
  return g_reported;
}

}  // namespace kaori::boot
