# Programs that the build itself runs: kaori-atelier, which models and packs the show and writes its labels, and flatc, which
# writes the reader of packs. Where the box is built for another machine they are this machine's:
#
#   - those in the folder KAORI_HOST_TOOLS, or in the PATH (of Yocto's native sysroot), where they are there;
#   - else kaori-atelier is built first, of these sources, with this machine's compiler and libraries.
#
# A build for this machine itself runs kaori-packer, which is sooner built.
#
# Sets KAORI_ATELIER, what custom commands run, and KAORI_ATELIER_NEEDS, what they depend on.
set(KAORI_HOST_TOOLS "" CACHE PATH "A folder with kaori-atelier (and flatc) of this machine, for builds for another one")

find_program(FLATC flatc HINTS ${KAORI_HOST_TOOLS} NO_CMAKE_FIND_ROOT_PATH REQUIRED)

# It runs here, and is not one for the target.
function(kaori_check_host_tool program)
  execute_process(COMMAND ${program} --help RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
  if(NOT failed EQUAL 0)
    message(FATAL_ERROR "${program} does not run on this machine (${failed}). Name another folder: -D KAORI_HOST_TOOLS=FOLDER")
  endif()
endfunction()

# A build of kaori-atelier alone, in an environment without a trace of the cross compiler.
function(kaori_build_host_atelier folder)
  set(gone CC CXX CPP CFLAGS CXXFLAGS CPPFLAGS LDFLAGS CMAKE_TOOLCHAIN_FILE CONFIG_SITE PKG_CONFIG_PATH PKG_CONFIG_LIBDIR
           PKG_CONFIG_SYSROOT_DIR SDKTARGETSYSROOT OECORE_TARGET_SYSROOT OECORE_NATIVE_SYSROOT)
  list(TRANSFORM gone PREPEND --unset=)
  # An SDK puts its own pkg-config and CMake first, which know its libraries alone.
  string(REPLACE ":" ";" path "$ENV{PATH}")
  if(DEFINED ENV{OECORE_NATIVE_SYSROOT})
    list(FILTER path EXCLUDE REGEX "^$ENV{OECORE_NATIVE_SYSROOT}")
  endif()
  find_program(own_cmake cmake PATHS ${path} NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH NO_CACHE REQUIRED)
  find_program(own_ninja ninja PATHS ${path} NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH NO_CACHE REQUIRED)
  string(REPLACE ";" ":" path "${path}")
  set(clean ${CMAKE_COMMAND} -E env ${gone} PATH=${path})

  include(ExternalProject)
  ExternalProject_Add(kaori-host-tools
    SOURCE_DIR ${PROJECT_SOURCE_DIR} BINARY_DIR ${folder} PREFIX ${folder}/stamps
    CONFIGURE_COMMAND ${clean} ${own_cmake} -S ${PROJECT_SOURCE_DIR} -B ${folder} -G Ninja -D CMAKE_MAKE_PROGRAM=${own_ninja}
                      -D CMAKE_BUILD_TYPE=Release -D KAORI_PROGRAMS=OFF
    BUILD_COMMAND ${clean} ${own_ninja} -C ${folder} kaori-atelier
    INSTALL_COMMAND "" EXCLUDE_FROM_ALL ON BUILD_ALWAYS ON USES_TERMINAL_BUILD ON BUILD_BYPRODUCTS ${folder}/bin/kaori-atelier)
endfunction()

if(NOT KAORI_PROGRAMS)
  return()  # No show is packed.
endif()
if(KAORI_AUTHORING AND NOT CMAKE_CROSSCOMPILING)
  set(KAORI_ATELIER kaori-packer)
  set(KAORI_ATELIER_NEEDS kaori-packer)
  return()
endif()
if(KAORI_HOST_TOOLS)
  find_program(KAORI_HOST_ATELIER kaori-atelier PATHS ${KAORI_HOST_TOOLS} NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH)
  if(NOT KAORI_HOST_ATELIER)
    message(FATAL_ERROR "There is no kaori-atelier in ${KAORI_HOST_TOOLS}, which KAORI_HOST_TOOLS names")
  endif()
else()
  find_program(KAORI_HOST_ATELIER kaori-atelier NO_CMAKE_FIND_ROOT_PATH)
endif()
if(KAORI_HOST_ATELIER)
  kaori_check_host_tool(${KAORI_HOST_ATELIER})
  set(KAORI_ATELIER ${KAORI_HOST_ATELIER})
  set(KAORI_ATELIER_NEEDS ${KAORI_HOST_ATELIER})
else()
  message(STATUS "kaori-atelier of this machine is built first; KAORI_HOST_TOOLS may name a folder that has it")
  set(KAORI_ATELIER ${PROJECT_BINARY_DIR}/host-tools/bin/kaori-atelier)
  set(KAORI_ATELIER_NEEDS kaori-host-tools ${KAORI_ATELIER})
  kaori_build_host_atelier(${PROJECT_BINARY_DIR}/host-tools)
endif()
