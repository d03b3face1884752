# What has to hold wherever a Yocto SDK builds the box, with our toolchain file or with the SDK's own: its environment is
# there, at the first configuration and whenever CMake runs again. Included before project(), which tries the compiler.
#
# The SDK's own toolchain file reads the same variables, and where they are gone it goes on with empty ones: libraries of
# this machine would then be found for the target.

# The first configuration is inside the SDK; where it was is kept for the message of a later one outside.
if(DEFINED ENV{OECORE_TARGET_SYSROOT} AND NOT DEFINED CACHE{KAORI_SDK_SYSROOT})
  set(script "")
  get_filename_component(sysroot "$ENV{OECORE_TARGET_SYSROOT}" NAME)
  # An SDK with several sets of libraries has a script for each: the one that names this sysroot.
  file(GLOB candidates "$ENV{OECORE_NATIVE_SYSROOT}/../../environment-setup-*")
  foreach(candidate ${candidates})
    file(STRINGS ${candidate} lines REGEX "SDKTARGETSYSROOT=.*/${sysroot}\"?$")
    if(lines)
      get_filename_component(script ${candidate} REALPATH)
    endif()
  endforeach()
  set(KAORI_SDK_SCRIPT "${script}" CACHE INTERNAL "The script that sets the SDK's environment")
  set(KAORI_SDK_SYSROOT "$ENV{OECORE_TARGET_SYSROOT}" CACHE INTERNAL "The sysroot of the SDK")
endif()

if(CMAKE_TOOLCHAIN_FILE MATCHES "(oe-sdk|OEToolchainConfig)[.]cmake$")
  set(script "$CACHE{KAORI_SDK_SCRIPT}")
  if(NOT script)
    set(script "/opt/.../environment-setup-... (the script in the SDK's folder)")
  endif()
  foreach(name OECORE_TARGET_SYSROOT OECORE_NATIVE_SYSROOT CC CXX)
    if("$ENV{${name}}" STREQUAL "")
      message(FATAL_ERROR "The environment of the Yocto SDK is not there: ${name} is not set. In this shell say first:\n. ${script}")
    endif()
  endforeach()
  if(NOT "$ENV{OECORE_TARGET_SYSROOT}" STREQUAL "$CACHE{KAORI_SDK_SYSROOT}")
    message(FATAL_ERROR "This folder was configured with another sysroot, $CACHE{KAORI_SDK_SYSROOT}. Build in another folder, or say first:\n. ${script}")
  endif()
  # As the SDK's own script does: its programs load libraries of their own.
  if(NOT "$ENV{LD_LIBRARY_PATH}" STREQUAL "")
    message(FATAL_ERROR "LD_LIBRARY_PATH is set, and the SDK's programs would load wrong libraries. Say first:\nunset LD_LIBRARY_PATH")
  endif()
endif()
