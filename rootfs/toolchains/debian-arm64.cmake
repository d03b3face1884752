# Builds the box for 64-bit ARM with Debian's cross compiler (g++-aarch64-linux-gnu) and a sysroot: the build packages of
# arm64, unpacked into a folder. `./box cross arm64` makes that folder and uses this file:
#
#   cmake --toolchain rootfs/toolchains/debian-arm64.cmake -D KAORI_SYSROOT=out/cross/arm64/sysroot ...
#
# The packages are not installed on this machine as foreign ones: some of them exclude those of its own architecture.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)

# The projects by which CMake tries the compiler read this file too, and are given the folder.
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES KAORI_SYSROOT)
set(KAORI_SYSROOT ${CMAKE_CURRENT_LIST_DIR}/../../out/cross/arm64/sysroot CACHE PATH "Debian's build packages of arm64, unpacked")
get_filename_component(sysroot ${KAORI_SYSROOT} REALPATH)
if(NOT EXISTS ${sysroot}/usr/lib/aarch64-linux-gnu/libc.so)
  message(FATAL_ERROR "There is no sysroot of arm64 in ${sysroot}. Say: ./box cross arm64 --sysroot")
endif()
set(CMAKE_SYSROOT ${sysroot})

set(CMAKE_FIND_ROOT_PATH ${sysroot})
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
# Programs that run during the build are this machine's.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)

# This machine's pkg-config, which shall see nothing of this machine.
set(ENV{PKG_CONFIG_PATH} "")
set(ENV{PKG_CONFIG_LIBDIR} ${sysroot}/usr/lib/aarch64-linux-gnu/pkgconfig:${sysroot}/usr/share/pkgconfig)
set(ENV{PKG_CONFIG_SYSROOT_DIR} ${sysroot})

# Tests run in user-mode emulation. Without a space of addresses of its own (-R), QEMU gives memory that a program asks for at an address
# that is taken anywhere in that of this machine: further away than code that llvmpipe makes can reach its own data.
find_program(KAORI_QEMU NAMES qemu-aarch64-static qemu-aarch64 DOC "Runs programs of arm64, for the tests")
if(KAORI_QEMU)
  set(CMAKE_CROSSCOMPILING_EMULATOR ${KAORI_QEMU} -R 0x1000000000 -L ${sysroot})
endif()
