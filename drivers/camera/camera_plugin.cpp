#include "drivers/camera/camera_plugin.h"

#include <dlfcn.h>

#include <filesystem>

#include "drivers/base/folder.h"

namespace kaori::camera {
namespace {

// One line for whatever is wrong with a file.
tl::unexpected<Error> Unusable(const std::string& file, const std::string& why) {
  return Fail(std::errc::not_supported, "load the camera plug-in " + file + " (" + why + ")");
}

// dlerror gives its text once. It names the library that is missing, which tells people what to install.
std::string LastError() {
  const char* text = ::dlerror();
  return text != nullptr ? text : "no reason given";
}

}  // namespace

Result<std::unique_ptr<CameraLibrary>> LoadCameraPlugin(const std::string& file) {
  if (!IsThere(file)) return Unusable(file, "it is not there");
  // RTLD_NOW: a symbol that is missing is found here, and not in the middle of a show.
  void* loaded = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);  // Never closed: the cameras' code is in it.
  if (loaded == nullptr) return Unusable(file, LastError());
  const auto* plugin = static_cast<const CameraPlugin*>(::dlsym(loaded, CameraPlugin::kSymbol));
  if (plugin == nullptr) return Unusable(file, "it is no camera plug-in");
  if (plugin->version != CameraPlugin::kVersion || plugin->start == nullptr)
    return Unusable(file, "it is of version " + std::to_string(plugin->version));
  std::unique_ptr<CameraLibrary> library(plugin->start());
  if (!library) return Fail(std::errc::io_error, "start the library of " + file);
  return library;
}

std::string PluginFile(const std::string& name) {
  std::error_code error;
  // Not from the environment: a plug-in is code of this program.
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  return (program.parent_path() / (name + ".so")).string();
}

}  // namespace kaori::camera
