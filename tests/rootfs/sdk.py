"""A look-alike of a Yocto SDK, for tests: its folders, its script and the names of its variables, around a compiler that is
there already. Where the names come from: openembedded-core, classes-recipe/toolchain-scripts.bbclass."""

import os
import stat
import subprocess
from pathlib import Path

# As the SDKs since 2022 have it: processor by its name, additions beside itself.
OWN_FILE = """
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR $ENV{OECORE_TARGET_ARCH})
set(CMAKE_FIND_ROOT_PATH $ENV{OECORE_TARGET_SYSROOT} $ENV{OECORE_NATIVE_SYSROOT})
foreach(kind LIBRARY INCLUDE PACKAGE)
  set(CMAKE_FIND_ROOT_PATH_MODE_${kind} ONLY)
endforeach()
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_LIBRARY_CUSTOM_LIB_SUFFIX "$ENV{OE_CMAKE_FIND_LIBRARY_CUSTOM_LIB_SUFFIX}")
file(GLOB additions ${CMAKE_CURRENT_LIST_FILE}.d/*.cmake)
foreach(addition ${additions})
  include(${addition})
endforeach()
"""
# As older ones have it: the processor is the beginning of the sysroot's name, and additions lie beside what the caller named.
OLD_FILE = OWN_FILE.replace("set(CMAKE_SYSTEM_PROCESSOR $ENV{OECORE_TARGET_ARCH})", """
if("$ENV{SDKTARGETSYSROOT}" MATCHES "/sysroots/([a-zA-Z0-9_-]+)-.+-.+")
  set(CMAKE_SYSTEM_PROCESSOR ${CMAKE_MATCH_1})
endif()""").replace("${CMAKE_CURRENT_LIST_FILE}.d", "${CMAKE_TOOLCHAIN_FILE}.d")


class Sdk:
    """An SDK in `folder`. `tune` begins its sysroot's name, `arch` is its processor, `own_file` the text of its toolchain
    file (None: it has none), `compiler` the prefix of the compiler that does the work ("" is this machine's own)."""

    def __init__(self, folder, tune="cortexa72", arch="aarch64", baselib="lib", own_file=OWN_FILE, compiler="",
                 libraries=None, static=True, pkg_config=True):
        self.folder = Path(folder)
        self.arch, self.prefix = arch, f"{arch}-poky-linux-"
        self.native = self.folder / "sysroots/x86_64-pokysdk-linux"
        self.sysroot = self.folder / f"sysroots/{tune}-poky-linux"
        self.script = self.folder / f"environment-setup-{tune}-poky-linux"
        self._make_compilers(compiler, static)
        self._make_sysroot(libraries, baselib)
        if own_file is not None:
            share = self.native / "usr/share/cmake/OEToolchainConfig.cmake.d"
            share.mkdir(parents=True)
            share.with_suffix("").write_text(own_file)
            (share / "layer.cmake").write_text("set(KAORI_ADDED yes)\n")
        self._write_script(baselib, own_file is not None, pkg_config)

    def _make_compilers(self, compiler, static):
        bin_folder = self.native / "usr/bin"
        bin_folder.mkdir(parents=True)
        for tool in ("gcc", "g++", "ar", "ranlib", "strip"):
            wrapper = bin_folder / (self.prefix + tool)
            no_static = "" if static else 'case " $* " in *" -static "*) echo "cannot find -lc" >&2; exit 1;; esac\n'
            wrapper.write_text(f'#!/bin/sh\n{no_static}exec {compiler}{tool} "$@"\n')
            wrapper.chmod(wrapper.stat().st_mode | stat.S_IXUSR)

    def _make_sysroot(self, libraries, baselib):
        """Of what is there: this machine's own libraries by links, or those of another sysroot by second names, since the
        linker resolves links before it asks whether a file is the sysroot's."""
        source = Path(libraries or "/")
        usr = self.sysroot / "usr"
        usr.mkdir(parents=True)
        for name in ("usr/include", "usr/share"):
            (self.sysroot / name).symlink_to(source / name)
        for name in ("lib", "lib64", "usr/lib"):
            if libraries and (source / name).exists():
                subprocess.run(["cp", "-al", source / name, self.sysroot / name], check=True)
            elif name == "usr/lib":
                (usr / "lib").mkdir()
                for path in (source / name).iterdir():
                    (usr / "lib" / path.name).symlink_to(path)
            elif (source / name).exists():
                (self.sysroot / name).symlink_to(source / name)
        (usr / baselib).mkdir(exist_ok=True)
        (usr / baselib / "libkaori_probe.so").touch()

    def _write_script(self, baselib, has_file, pkg_config):
        packages = [path for path in sorted((self.sysroot / "usr/lib").glob("*-linux-gnu*/pkgconfig"))] if pkg_config else []
        search = ":".join(map(str, [*packages, self.sysroot / "usr/share/pkgconfig"] if pkg_config else [self.sysroot / "none"]))
        lines = ['if [ ! -z "${LD_LIBRARY_PATH:-}" ]; then echo "unset LD_LIBRARY_PATH"; return 1; fi',
                 f"export SDKTARGETSYSROOT={self.sysroot}",
                 f'export PATH={self.native}/usr/bin:"$PATH"',
                 "export PKG_CONFIG_SYSROOT_DIR=$SDKTARGETSYSROOT",
                 f"export PKG_CONFIG_PATH={search}",
                 f'export OECORE_NATIVE_SYSROOT="{self.native}"',
                 'export OECORE_TARGET_SYSROOT="$SDKTARGETSYSROOT"',
                 f'export OECORE_BASELIB="{baselib}"',
                 f'export OECORE_TARGET_ARCH="{self.arch}"',
                 f"export TARGET_PREFIX={self.prefix}",
                 f'export CC="{self.prefix}gcc -DKAORI_FLAG_OF_THE_COMPILER=8 --sysroot=$SDKTARGETSYSROOT"',
                 f'export CXX="{self.prefix}g++ -DKAORI_FLAG_OF_THE_COMPILER=8 --sysroot=$SDKTARGETSYSROOT"',
                 'export CFLAGS="-O0 -DKAORI_FLAG_OF_THE_SDK=7"', 'export CXXFLAGS="$CFLAGS"', 'export LDFLAGS="-Wl,-O1"']
        if has_file:
            file = "$OECORE_NATIVE_SYSROOT/usr/share/cmake/OEToolchainConfig.cmake"
            lines += [f'export CMAKE_TOOLCHAIN_FILE="{file}"', f'export OE_CMAKE_TOOLCHAIN_FILE="{file}"',
                      'export OE_CMAKE_FIND_LIBRARY_CUSTOM_LIB_SUFFIX="`echo $OECORE_BASELIB | sed -e s/lib//`"']
        self.script.write_text("\n".join(lines) + "\n")

    def run(self, *command, **more):
        """Runs a command in a shell that has read the SDK's script; `more` are variables set besides."""
        return run("/bin/sh", "-c", f'. {self.script} && exec "$@"', "sh", *command, **more)


def run(*command, **more):
    """Runs a command as it stands in a plain shell."""
    clean = {name: value for name, value in os.environ.items()
             if not name.startswith(("OECORE", "CMAKE", "PKG_CONFIG", "LD_LIBRARY", "CC", "CXX", "CFLAGS"))}
    return subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False,
                          env={**clean, "CCACHE_SLOPPINESS": "time_macros", **more})
