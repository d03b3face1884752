// A camera plug-in of a version that no program knows.
#include "drivers/camera/camera_plugin.h"

extern "C" {
extern const kaori::camera::CameraPlugin kaori_camera_plugin;
const kaori::camera::CameraPlugin kaori_camera_plugin{.version = 99, .start = nullptr};
}
