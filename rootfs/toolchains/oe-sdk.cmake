# Builds the box inside any Yocto SDK, whatever its processor, flags and libraries are. In the shell that builds:
#
#   . /opt/poky/5.0/environment-setup-cortexa72-poky-linux
#   cmake --toolchain rootfs/toolchains/oe-sdk.cmake -G Ninja -B out/build/sdk && ninja -C out/build/sdk
#
# An SDK names a toolchain file of its own in CMAKE_TOOLCHAIN_FILE; with that one (cmake without --toolchain) the box builds
# too. This file includes it, and adds what older ones lack.
# Sources: openembedded-core, classes-recipe/toolchain-scripts.bbclass and recipes-devtools/cmake.

# The projects by which CMake tries the compiler read this file too; they have no cache of ours.
get_property(trying GLOBAL PROPERTY IN_TRY_COMPILE)
if(NOT trying)
  include(${CMAKE_CURRENT_LIST_DIR}/sdk_environment.cmake)
endif()

set(own $ENV{OECORE_NATIVE_SYSROOT}/usr/share/cmake/OEToolchainConfig.cmake)
if(EXISTS ${own})
  include(${own})
  # Layers add files to it. Older ones look for them beside CMAKE_TOOLCHAIN_FILE, which is this file.
  file(STRINGS ${own} beside_this REGEX "CMAKE_TOOLCHAIN_FILE}[.]d")
  if(beside_this)
    file(GLOB additions ${own}.d/*.cmake)
    foreach(addition ${additions})
      include(${addition})
    endforeach()
  endif()
else()
  # The compilers with their --sysroot and processor, and all flags, CMake itself takes from CC, CXX, CFLAGS, CXXFLAGS and
  # LDFLAGS.
  set(CMAKE_SYSTEM_NAME Linux)
  set(CMAKE_FIND_ROOT_PATH $ENV{OECORE_TARGET_SYSROOT} $ENV{OECORE_NATIVE_SYSROOT})
  set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
  set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
  set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
  set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
endif()

# As `uname -m` says it, without the version of an "armv7a". Older files take it from the sysroot's name, which may be
# "cortexa8t2hf-neon".
if(NOT "$ENV{OECORE_TARGET_ARCH}" STREQUAL "")
  set(CMAKE_SYSTEM_PROCESSOR $ENV{OECORE_TARGET_ARCH})
else()
  # Old SDKs say it only in the name of their compiler, "arm-poky-linux-gnueabi-gcc".
  string(REGEX MATCH "^[a-z0-9_]+" CMAKE_SYSTEM_PROCESSOR "$ENV{TARGET_PREFIX}")
endif()

# Where libraries lie: lib, lib64, lib32.
if(NOT "$ENV{OECORE_BASELIB}" STREQUAL "")
  string(REGEX REPLACE "^lib" "" suffix "$ENV{OECORE_BASELIB}")
  set(CMAKE_FIND_LIBRARY_CUSTOM_LIB_SUFFIX "${suffix}")
  set(CMAKE_INSTALL_LIBDIR $ENV{OECORE_BASELIB} CACHE PATH "Where libraries are installed, below the prefix")
endif()

# An SDK without a pkg-config of its own would be shown this machine's libraries by this machine's.
if(NOT DEFINED ENV{PKG_CONFIG_LIBDIR})
  set(ENV{PKG_CONFIG_LIBDIR} "$ENV{PKG_CONFIG_PATH}")
endif()
