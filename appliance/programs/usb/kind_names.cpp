#include "appliance/programs/usb/kind_names.h"

#include <algorithm>
#include <array>

namespace kaori::usb {
namespace {

using decode::OfferedInterface;
using decode::UsbClass;

struct Row {
  UsbClass kind;
  KindName name;
};

// By class alone; what is not here has the name kNameless.
constexpr std::array kTable{
    Row{UsbClass::kSound, {"a sound device", "音声機器"}},
    Row{UsbClass::kCommunication, {"a network adapter or modem", "通信機器"}},
    Row{UsbClass::kInput, {"an input device", "入力機器"}},
    Row{UsbClass::kStillImage, {"a telephone or photo camera", "電話機またはカメラ"}},
    Row{UsbClass::kPrinter, {"a printer", "プリンター"}},
    Row{UsbClass::kStorage, {"a storage device", "記憶装置"}},
    Row{UsbClass::kHub, {"a hub", "ハブ"}},
    Row{UsbClass::kData, {"a network adapter or modem", "通信機器"}},
    Row{UsbClass::kSmartCard, {"a smart card reader", "カードリーダー"}},
    Row{UsbClass::kCamera, {"a camera", "ビデオカメラ"}},
    Row{UsbClass::kWireless, {"a wireless adapter", "無線機器"}},
    Row{UsbClass::kApplication, {"a loader of firmware", "ファームウェア書き込み機器"}},
    Row{UsbClass::kVendor, {"a device of its maker's own kind", "メーカー独自の機器"}}};
constexpr KindName kKeyboard{"a keyboard", "キーボード"}, kMouse{"a mouse", "マウス"},
    kSerialAdapter{"a serial adapter", "シリアル変換器"},
    kNameless{"a device of an unknown kind", "種類の分からない機器"};

// Protocols of HID's boot interfaces (HID 1.11, 4.3).
constexpr std::uint8_t kKeyboardProtocol = 1, kMouseProtocol = 2;

}  // namespace

bool IsKeyboard(const OfferedInterface& one) {
  return one.kind == UsbClass::kInput && one.protocol == kKeyboardProtocol;
}

KindName NameOf(const OfferedInterface& one, bool of_serial_maker) {
  if (IsKeyboard(one)) return kKeyboard;
  if (one.kind == UsbClass::kInput && one.protocol == kMouseProtocol) return kMouse;
  if (one.kind == UsbClass::kVendor && of_serial_maker) return kSerialAdapter;
  const auto* const row = std::ranges::find(kTable, one.kind, &Row::kind);
  return row == kTable.end() ? kNameless : row->name;
}

}  // namespace kaori::usb
