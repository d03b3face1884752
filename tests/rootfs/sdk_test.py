#!/usr/bin/env python3
"""Whether the box is built inside any Yocto SDK: sdk_test.py REPOSITORY BIN [--cross SYSROOT]

BIN holds kaori-atelier of this machine. The SDK is a look-alike (sdk.py) around this machine's own compiler, and one program is
built in it; or with --cross around Debian's for arm64 and its sysroot, and all programs of the box are, which takes minutes."""

import re
import sys
import tempfile
import unittest
from pathlib import Path

REPOSITORY, BIN = (Path(word).resolve() for word in sys.argv[1:3])
CROSS = Path(sys.argv[4]).resolve() if sys.argv[3:4] == ["--cross"] else None
sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).parent))
from sdk import OLD_FILE, OWN_FILE, Sdk, run  # noqa: E402

TOOLCHAIN = REPOSITORY / "rootfs/toolchains/oe-sdk.cmake"
PROBE = Path(__file__).parent / "probe"
COMPILER = {"compiler": "aarch64-linux-gnu-", "libraries": CROSS} if CROSS else {}
# A processor that this machine's compiler serves, too.
USUAL = {**COMPILER, "arch": "aarch64", "tune": "cortexa72"}
AARCH64, X86_64 = 183, 62  # e_machine of an ELF file.


def programs_of_the_box():
    """Every program below appliance/programs, by its CMakeLists.txt: without authoring no other one is built."""
    texts = [path.read_text() for path in (REPOSITORY / "appliance/programs").rglob("CMakeLists.txt")]
    return {name for text in texts for name in re.findall(r"(?m)^ *kaori_(?:installed_)?program\((kaori-[\w-]+)", text)}


def machine_of(program):
    """e_machine of an ELF file; None where there is no such file."""
    return int.from_bytes(program.read_bytes()[18:20], "little") if program.is_file() else None


def assert_refused(test, done, *words):
    """It ended with a fault, and said these words, however its lines are broken."""
    test.assertNotEqual(done.returncode, 0, done.stdout)
    for word in words:
        test.assertIn(word, " ".join(done.stderr.split()))


class InAFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(dir=CROSS.parent if CROSS else None)
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def probe(self, sdk, *options, toolchain=("--toolchain", TOOLCHAIN)):
        """Configures and compiles the probe; what it tells."""
        build = sdk.folder / "build"
        done = sdk.run("cmake", *toolchain, "-G", "Ninja", "-S", PROBE, "-B", build, *options)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        done = run("ninja", "-C", build)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return dict(line.split("=", 1) for line in (build / "told.txt").read_text().splitlines())


class AnySdk(InAFolder):
    def test_flags_libraries_and_processor_are_the_sdks(self):
        for number, own_file in enumerate((OWN_FILE, OLD_FILE, None)):
            with self.subTest(own_file=number):
                sdk = Sdk(self.folder / f"sdk{number}", own_file=own_file, **USUAL)
                told = self.probe(sdk)
                self.assertEqual(told["processor"], "aarch64")
                self.assertEqual(told["cross"], "TRUE")
                self.assertEqual(told["library"], str(sdk.sysroot / "usr/lib/libkaori_probe.so"))
                self.assertEqual(told["alsa"], "1")
                self.assertTrue(told["alsa_from"].startswith(str(sdk.sysroot)), told)
                self.assertEqual(told["added"], "" if own_file is None else "yes")

    def test_libraries_may_lie_in_lib64(self):
        for number, own_file in enumerate((OWN_FILE, None)):
            with self.subTest(own_file=number):
                # A folder that CMake would not look into by itself.
                sdk = Sdk(self.folder / f"sdk{number}", baselib="lib64x", own_file=own_file, **USUAL)
                told = self.probe(sdk)
                self.assertEqual(told["library"], str(sdk.sysroot / "usr/lib64x/libkaori_probe.so"))
                self.assertEqual(told["libdir"], "lib64x")

    def test_an_armv7_is_called_arm(self):
        for number, own_file in enumerate((OWN_FILE, OLD_FILE, None)):
            with self.subTest(own_file=number):
                sdk = Sdk(self.folder / f"sdk{number}", own_file=own_file, **{**USUAL, "arch": "arm", "tune": "cortexa8t2hf-neon"})
                self.assertEqual(self.probe(sdk)["processor"], "arm")

    def test_without_a_pkg_config_of_its_own_no_library_of_this_machine_is_found(self):
        told = self.probe(Sdk(self.folder / "sdk", pkg_config=False, **USUAL))
        self.assertNotEqual(told["alsa"], "1")


class Refused(InAFolder):
    def setUp(self):
        super().setUp()
        self.sdk = Sdk(self.folder / "sdk", **USUAL)
        self.options = ("-G", "Ninja", "-S", PROBE, "-B", self.folder / "build")

    def test_no_environment(self):
        assert_refused(self, run("cmake", "--toolchain", TOOLCHAIN, *self.options), "OECORE_TARGET_SYSROOT is not set", "environment-setup-")

    def test_cmake_again_outside_the_environment_names_its_script(self):
        self.assertEqual(self.sdk.run("cmake", "--toolchain", TOOLCHAIN, *self.options).returncode, 0)
        assert_refused(self, run("cmake", self.folder / "build"), "OECORE_TARGET_SYSROOT is not set", f". {self.sdk.script.resolve()}")

    def test_cmake_again_in_another_sdk(self):
        self.assertEqual(self.sdk.run("cmake", "--toolchain", TOOLCHAIN, *self.options).returncode, 0)
        other = Sdk(self.folder / "other", **{**USUAL, "tune": "cortexa53"})
        assert_refused(self, other.run("cmake", self.folder / "build"), "another sysroot", str(self.sdk.sysroot))

    def test_ld_library_path(self):
        done = self.sdk.run("env", "LD_LIBRARY_PATH=/usr/lib", "cmake", "--toolchain", TOOLCHAIN, *self.options)
        assert_refused(self, done, "unset LD_LIBRARY_PATH")
        assert_refused(self, self.sdk.run("true", LD_LIBRARY_PATH="/usr/lib"))


class TheBox(InAFolder):
    """The whole project. Each configuration costs seconds."""

    OPTIONS = ("-G", "Ninja", "-S", REPOSITORY, "-D", "KAORI_AUTHORING=OFF")

    def test_is_configured_and_programs_are_built(self):
        sdk = Sdk(self.folder / "sdk", static=False, **USUAL)
        build = self.folder / "build"
        done = sdk.run("cmake", "--toolchain", TOOLCHAIN, *self.OPTIONS, "-B", build, "-D", f"KAORI_HOST_TOOLS={BIN}")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("kaori-boot is linked dynamically", done.stdout)
        wanted = programs_of_the_box() if CROSS else {"kaori-fdkeeper"}
        done = sdk.run("ninja", "-C", build, *([] if CROSS else sorted(wanted)))
        self.assertEqual(done.returncode, 0, done.stdout)
        machines = {name: machine_of(build / "bin" / name) for name in wanted}
        self.assertEqual(machines, dict.fromkeys(wanted, AARCH64 if CROSS else X86_64))

    def test_plain_cmake_in_the_sdk_does_too_and_tools_of_this_machine_are_built_first(self):
        sdk = Sdk(self.folder / "sdk", **USUAL)
        build = self.folder / "build"
        done = sdk.run("cmake", *self.OPTIONS, "-B", build)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("kaori-atelier of this machine is built first", done.stdout)
        commands = run("ninja", "-C", build, "-t", "commands", "kaori-show").stdout.splitlines()
        pack = next(number for number, line in enumerate(commands) if " pack " in line)
        built = next(number for number, line in enumerate(commands) if re.search("ninja -C .* kaori-atelier( |$)", line))
        self.assertLess(built, pack)
        for word in ("--unset=CXX", "--unset=PKG_CONFIG_SYSROOT_DIR", "--unset=CMAKE_TOOLCHAIN_FILE"):
            self.assertIn(word, commands[built])
        self.assertNotIn(str(sdk.native), commands[built])
        tools = build / "host-tools"
        done = sdk.run("ninja", "-C", build, "host-tools/stamps/src/kaori-host-tools-stamp/kaori-host-tools-configure")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertNotIn(str(sdk.folder), (tools / "CMakeCache.txt").read_text().replace(str(tools), "").replace(str(build), ""))
        self.assertEqual(run("ninja", "-C", tools, "-n", "kaori-atelier").returncode, 0)
        assert_refused(self, run("cmake", build), f". {sdk.script.resolve()}")

    def test_a_folder_without_tools_that_run_here_is_named(self):
        sdk = Sdk(self.folder / "sdk", **USUAL)
        tools = self.folder / "tools"
        tools.mkdir()
        build = ("cmake", "--toolchain", TOOLCHAIN, *self.OPTIONS, "-B", self.folder / "build", "-D", f"KAORI_HOST_TOOLS={tools}")
        assert_refused(self, sdk.run(*build), f"There is no kaori-atelier in {tools}")
        (tools / "kaori-atelier").write_bytes(b"\x7fELF of another machine")
        (tools / "kaori-atelier").chmod(0o755)
        assert_refused(self, sdk.run(*build), "does not run on this machine")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
