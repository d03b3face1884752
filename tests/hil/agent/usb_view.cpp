#include "tests/hil/agent/usb_view.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

namespace kaori::agent {
namespace {

std::string WordIn(const std::filesystem::path& file) {
  std::string word;
  std::ifstream(file) >> word;
  return word;
}

// "1-8", "1-8.2"; not "usb1", and not "1-8:1.0", which is an interface.
bool IsPort(const std::string& name) {
  return name.find('-') != std::string::npos && name.find(':') == std::string::npos;
}

}  // namespace

std::string UsbDevices(const std::string& folder) {
  std::vector<std::string> lines;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string port = entry.path().filename();
    if (!IsPort(port)) continue;
    lines.push_back(port + " " + WordIn(entry.path() / "idVendor") + ":" +
                    WordIn(entry.path() / "idProduct") + " " + WordIn(entry.path() / "authorized") + "\n");
  }
  std::ranges::sort(lines);
  std::string all;
  for (const std::string& line : lines) all += line;
  return all;
}

}  // namespace kaori::agent
