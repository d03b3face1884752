"""The direction of the house, as data: who may include whom, and who may touch which library."""

SOURCE_ROOMS = ("firmware", "drivers", "render", "appliance", "hw-sim", "tests")
SOURCE_SUFFIXES = (".h", ".hpp", ".c", ".cc", ".cpp")

_BASE = ("firmware/wire/", "drivers/base/")
_DRIVER = _BASE + ("drivers/ports/",)
_DRAWING = ("drivers/base/", "render/face/", "render/scene/")
_PLAY = _DRIVER + ("render/", "appliance/board/", "appliance/show/", "appliance/performance/")
_SIMULATOR = _DRIVER + ("firmware/surface/", "hw-sim/devices/", "hw-sim/links/", "hw-sim/scenario/",
                        "hw-sim/console/", "drivers/web/")
EVERYTHING = tuple(room + "/" for room in SOURCE_ROOMS)
CONCRETE_DRIVERS = tuple(f"drivers/{kind}/" for kind in ("hid", "gpio", "camera", "audio", "scanout"))

# (room, what it may include besides itself). The first row whose room begins the path counts.
MAY_INCLUDE = (
    ("firmware/wire/", ()),
    ("firmware/surface/", ("firmware/wire/",)),
    ("firmware/", ("firmware/",)),
    ("drivers/base/", ()),
    ("drivers/ports/", _BASE),
    *((driver, _DRIVER) for driver in CONCRETE_DRIVERS),
    ("drivers/web/", ("drivers/base/",)),  # No device: what pages need, of the product and of the simulator.
    ("render/face/", ("drivers/base/",)),
    ("render/scene/", ("drivers/base/", "render/face/")),
    ("render/image/", ("drivers/base/",)),
    ("render/gl/", _DRAWING),
    ("render/passes/", _DRAWING + ("render/gl/", "render/image/", "render/shaders/")),
    ("render/wall/", _DRAWING + ("render/gl/", "render/shaders/")),
    ("appliance/board/", _DRIVER),
    ("appliance/show/", _DRAWING),
    ("appliance/performance/", _DRAWING + ("appliance/board/", "appliance/show/")),
    ("appliance/stage/", _PLAY + ("appliance/needles/", "appliance/status/")),
    ("appliance/atelier/", _PLAY + ("appliance/stage/",)),  # Its contact sheets are drawn by the stage's studio.
    ("appliance/desk/", _PLAY + ("appliance/lips/service/", "appliance/status/", "drivers/web/")),
    ("appliance/", _PLAY),
    ("hw-sim/rehearsal/", EVERYTHING),
    ("hw-sim/", _SIMULATOR),
    ("tests/", EVERYTHING),
)

# The one file of each program that may name concrete drivers.
MAIN_FILE = "main.cpp"

# The pure middle of a driver, bytes to values: a program may use it anywhere, since no device hangs on it.
# The rules test looks into their sources for system calls.
PURE_DECODERS = tuple(f"drivers/hid/{name}.h" for name in (
    "dial_box", "joystick", "keyboard", "pointer", "recognise", "report_layout", "report_values", "switches", "usages",
)) + ("drivers/camera/planes.h",)
SYSTEM_HEADERS = ("unistd.h", "fcntl.h", "sys/", "linux/", "libusb", "libudev.h", "poll.h")

# (what the <header> begins with, the rooms that may include it). Tests may include any.
LIBRARIES = (
    (("EGL/", "GLES", "GL/"), ("render/gl/",)),
    (("gbm.h", "xf86drm", "drm/", "libdrm/"), ("drivers/scanout/", "render/gl/", "firmware/boot/")),
    (("gpiod", "linux/gpio.h"), ("drivers/gpio/",)),
    (("libusb", "libudev.h", "linux/hidraw.h", "hidapi"), ("drivers/hid/",)),
    (("linux/videodev2.h",), ("drivers/camera/",)),
    (("alsa/",), ("drivers/audio/", "appliance/desk/")),
    # Settings and the box's own expressions are TOML for people; shows are read by the atelier only.
    (("toml++/",), ("appliance/atelier/", "tools/", "appliance/input/settings.cpp",
                   "appliance/needles/own_reader.cpp")),
    (("libqhull", "meshoptimizer.h", "tiny_gltf.h", "tiny_obj_loader.h"),
     ("appliance/atelier/", "tools/")),
    (("microhttpd.h",), ("drivers/web/",)),
    (("gnutls/",), ("appliance/desk/",)),
    (("nlohmann/",), ("appliance/atelier/", "appliance/desk/", "hw-sim/", "tools/")),
    (("usbredir",), ("hw-sim/links/",)),
    (("pico/", "hardware/", "tusb.h"), ("firmware/rp2040/",)),
)

# Firmware outside rp2040 knows no operating system: only these of the standard library.
FREESTANDING_ROOMS = ("firmware/wire/", "firmware/surface/")
FREESTANDING = ("algorithm", "array", "bit", "concepts", "cstddef", "cstdint", "iterator", "limits", "numeric",
                "optional", "span", "string_view", "tuple", "type_traits", "utility")

LINES_WANTED = 300
# Longer files, each with its reason.
LONG_FILES = {}
