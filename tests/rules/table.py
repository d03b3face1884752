"""The direction, as data: who may include whom, and who may touch which library."""

SOURCE_ROOMS = ("firmware", "drivers", "render", "appliance", "hw-sim", "tests")
SOURCE_SUFFIXES = (".h", ".hpp", ".c", ".cc", ".cpp")

_BASE = ("firmware/wire/", "drivers/base/")
_PORTS = _BASE + ("drivers/ports/",)
_DECODE = _PORTS + ("drivers/decode/",)
_DRAWING = ("drivers/base/", "render/face/", "render/scene/")
_CORE = tuple(f"appliance/core/{room}/" for room in ("board", "last_face", "toml", "store", "show", "roles", "performance", "linecheck", "showlog", "report", "backup", "restore", "update"))
_PROGRAM = _DECODE + ("render/",) + _CORE
_SIMULATOR = _PORTS + ("hw-sim/devices/", "hw-sim/chip/", "hw-sim/links/", "hw-sim/scenario/", "hw-sim/console/", "drivers/web/")
EVERYTHING = tuple(room + "/" for room in SOURCE_ROOMS)
CONCRETE_DRIVERS = tuple(f"drivers/{kind}/" for kind in ("hid", "serial", "midi", "gpio", "camera", "audio", "scanout", "loader"))

# (room, what it may include besides itself). The first row whose room begins the path counts. Every room exists.
MAY_INCLUDE = (
    ("firmware/wire/", ()),
    ("firmware/surface/", ("firmware/wire/",)),
    ("firmware/board/", ("firmware/wire/", "firmware/surface/")),
    ("firmware/first/", ("firmware/surface/", "firmware/board/rp2040/")),
    ("drivers/base/", ()),
    ("drivers/ports/", _BASE),
    ("drivers/decode/", _PORTS),
    *((driver, _DECODE) for driver in CONCRETE_DRIVERS),
    ("drivers/web/", ("drivers/base/",)),  # No device: what pages need, of the product and of the simulator.
    ("render/face/", ("drivers/base/",)),
    ("render/scene/", ("drivers/base/", "render/face/")),
    ("render/image/", ("drivers/base/",)),
    ("render/gl/", _DRAWING),
    ("render/passes/", _DRAWING + ("render/gl/", "render/image/", "render/shaders/")),
    ("appliance/core/board/", _PORTS),
    ("appliance/core/last_face/", _BASE),
    ("appliance/core/toml/", ("drivers/base/",)),
    ("appliance/core/show/", _DRAWING),
    ("appliance/core/store/", ("drivers/base/",)),
    ("appliance/core/restore/", ("drivers/base/", "appliance/core/store/")),
    ("appliance/core/backup/", ("drivers/base/", "appliance/core/restore/", "appliance/core/show/", "appliance/core/store/")),
    ("appliance/core/update/", _PORTS + ("appliance/core/show/",)),
    ("appliance/core/roles/", ("drivers/base/", "appliance/core/toml/", "appliance/core/show/", "render/face/", "render/scene/")),
    ("appliance/core/performance/", _DRAWING + ("appliance/core/board/", "appliance/core/show/")),
    ("appliance/core/linecheck/", _DRAWING + ("appliance/core/board/", "appliance/core/show/", "appliance/core/performance/")),
    ("appliance/core/showlog/", _BASE + _DRAWING + ("appliance/core/board/", "appliance/core/show/", "appliance/core/performance/")),
    ("appliance/core/report/", _BASE + _DRAWING + ("appliance/core/board/", "appliance/core/show/", "appliance/core/performance/", "appliance/core/showlog/")),
    ("appliance/programs/boot/", _PORTS + ("appliance/core/last_face/", "appliance/core/restore/", "appliance/core/store/", "appliance/core/update/")),
    ("appliance/programs/data/", _BASE + ("appliance/core/board/",)),
    ("appliance/programs/fdkeeper/", ("drivers/base/",)),
    ("appliance/programs/power/", _BASE + ("appliance/core/board/",)),
    ("appliance/programs/usb/", _DECODE + ("appliance/core/store/",)),
    ("appliance/programs/input/", _DECODE + ("appliance/core/board/", "appliance/core/toml/")),
    ("appliance/programs/surface/", _DECODE + ("appliance/core/board/",)),
    ("appliance/programs/editor/", _PROGRAM),
    ("appliance/programs/status/", _PROGRAM),
    ("appliance/programs/monitor/", _PROGRAM + ("appliance/programs/status/",)),
    ("appliance/programs/shows/protocol/", _BASE),
    ("appliance/programs/shows/", _PORTS + ("appliance/core/backup/", "appliance/core/board/", "appliance/core/restore/", "appliance/core/store/", "appliance/core/show/", "appliance/core/toml/",
                                            "appliance/core/update/", "appliance/programs/status/",
                                            # A settings file is judged by the programs that will read it.
                                            "appliance/programs/boot/", "appliance/programs/input/")),
    ("appliance/programs/update/", _PORTS + ("appliance/core/board/", "appliance/core/show/", "appliance/core/update/")),
    ("appliance/programs/lips/protocol/", _BASE),
    ("appliance/programs/lips/", _PROGRAM),
    ("appliance/programs/report/", _PROGRAM + ("appliance/programs/editor/",)),  # Expressions that were made on the box.
    ("appliance/programs/stage/", _PROGRAM + ("appliance/programs/editor/", "appliance/programs/monitor/", "appliance/programs/status/")),
    ("appliance/programs/desk/", _BASE + ("render/image/", "appliance/core/board/", "appliance/programs/lips/protocol/",
                                          "appliance/programs/shows/protocol/", "appliance/programs/status/", "drivers/web/")),
    ("appliance/authoring/keys/", _PROGRAM + ("appliance/programs/stage/", "appliance/authoring/script/", "drivers/web/")),  # JPEG for keys with screens.
    ("appliance/authoring/", _PROGRAM + ("appliance/programs/report/", "appliance/programs/stage/")),  # Its contact sheets are drawn by the stage's studio.
    ("hw-sim/rehearsal/", EVERYTHING),
    ("hw-sim/evening/", EVERYTHING),
    ("hw-sim/devices/", _PORTS + ("firmware/surface/",)),
    ("hw-sim/chip/", _PORTS + ("hw-sim/devices/",)),
    ("hw-sim/links/", _PORTS + ("hw-sim/devices/",)),
    ("hw-sim/scenario/", _PORTS + ("hw-sim/devices/", "hw-sim/links/")),
    ("hw-sim/console/", _PORTS + ("drivers/web/", "hw-sim/devices/", "hw-sim/links/", "hw-sim/scenario/")),
    ("hw-sim/hil/", _SIMULATOR),
    ("hw-sim/monitor/", _BASE + ("appliance/core/board/",)),  # What the page for people says of the stage.
    ("hw-sim/main.cpp", _SIMULATOR + ("hw-sim/monitor/",)),
    ("tests/", EVERYTHING),
)

# The one file of each program that may name concrete drivers.
MAIN_FILE = "main.cpp"

# The pure middle of the drivers, bytes to values, calls no system.
PURE_ROOMS = ("drivers/decode/",)
SYSTEM_HEADERS = ("unistd.h", "fcntl.h", "sys/", "linux/", "libusb", "libudev.h", "poll.h")
# It links libraries of the project alone, but for these: a library and what it may link of the system.
PURE_ROOMS_LINK = {"drivers_decode_planes": ("PkgConfig::TURBOJPEG",)}  # JPEG of cameras; kaori-input does without.

# (what the <header> begins with, the rooms that may include it). Tests may include any.
LIBRARIES = (
    (("EGL/", "GLES", "GL/"), ("render/gl/",)),
    (("gbm.h", "xf86drm", "drm/", "libdrm/"), ("drivers/scanout/", "render/gl/", "appliance/programs/boot/")),
    (("gpiod", "linux/gpio.h"), ("drivers/gpio/",)),
    (("libusb", "libudev.h", "linux/hidraw.h", "hidapi"), ("drivers/hid/",)),
    (("linux/videodev2.h",), ("drivers/camera/",)),
    (("termios.h", "linux/serial.h"), ("drivers/serial/", "hw-sim/links/serial/")),
    (("alsa/",), ("drivers/audio/", "appliance/programs/desk/")),
    (("toml++/",), ("appliance/core/toml/value.cpp",)),  # Seconds to compile: everybody else reads its values.
    (("libqhull", "meshoptimizer.h", "tiny_gltf.h", "tiny_obj_loader.h"),
     ("appliance/authoring/",)),
    (("microhttpd.h",), ("drivers/web/",)),
    (("gnutls/",), ("appliance/programs/desk/",)),
    (("nlohmann/",), ("hw-sim/",)),
    (("usbredir",), ("hw-sim/links/",)),
    (("turbojpeg.h",), ("drivers/decode/planes.cpp", "drivers/web/", "appliance/authoring/import/", "hw-sim/devices/")),
    (("zstd.h",), ("appliance/core/update/",)),
)

# Firmware knows no operating system: only these of the standard library.
FREESTANDING_ROOMS = ("firmware/",)
FREESTANDING = ("algorithm", "array", "atomic", "bit", "concepts", "cstddef", "cstdint", "initializer_list", "iterator", "limits", "numeric",
                "optional", "span", "string_view", "tuple", "type_traits", "utility")

LINES_WANTED = 300
# Longer files, each with its reason.
LONG_FILES = {}

# The test's side of simulated devices, and the wire format, of which the box decodes with its general reader of reports.
FOR_TESTS_TOO = ("hw-sim/devices/", "hw-sim/chip/", "hw-sim/links/", "hw-sim/scenario/", "firmware/wire/")

# Declared in the product's headers and used by no code of the product, each with its reason (tests/rules/unused.py).
USED_FROM_OUTSIDE = {
    "EncodePack": "a pack as bytes, which tests and fuzzers damage; SavePack writes the same to a file",
    "pairing": "a test of the desk reads the code from it, as a visitor does from the screen",
    "saving": "a test of the desk waits until the settings are written",
}
