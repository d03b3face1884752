# What a box has besides its programs: the show, systemd's units, udev's rules. For systems that rootfs/image does not build,
# such as Yocto's: `DESTDIR=FOLDER cmake --install out/build/release` lays everything down below FOLDER.
#
# Users and groups are the system's to make: kaori-stage, kaori-input, kaori-lips, kaori-fdkeeper, kaori-surface, kaori-desk and kaori-trial,
# and the group kaori.
option(KAORI_BOX_SYSTEM "The system is a box and nothing else: its show is what systemd starts, its data have a partition" OFF)
set(KAORI_UNIT_DIR lib/systemd/system CACHE PATH "Where systemd's units are installed")
set(KAORI_UDEV_DIR lib/udev CACHE PATH "Where the folder of udev's rules is installed")
set(KAORI_TMPFILES_DIR lib/tmpfiles.d CACHE PATH "Where systemd's list of folders to make is installed")

# Units and kaori-boot name programs and show by their path.
if(CMAKE_INSTALL_PREFIX_INITIALIZED_TO_DEFAULT)
  set_property(CACHE CMAKE_INSTALL_PREFIX PROPERTY VALUE /usr)
elseif(NOT CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  message(STATUS "The units start /usr/bin/kaori-stage and others; what is installed below ${CMAKE_INSTALL_PREFIX} they do not find")
endif()

set(overlay ${PROJECT_SOURCE_DIR}/rootfs/overlay/usr/lib)
install(FILES ${PROJECT_BINARY_DIR}/shows/kaori.kaori DESTINATION ${CMAKE_INSTALL_DATADIR}/kaori)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/appliance/shows/kaori/surfaces DESTINATION ${CMAKE_INSTALL_DATADIR}/kaori)
install(DIRECTORY ${overlay}/udev/rules.d DESTINATION ${KAORI_UDEV_DIR})
file(GLOB units CONFIGURE_DEPENDS ${overlay}/systemd/system/kaori*.service ${overlay}/systemd/system/kaori*.socket
     ${overlay}/systemd/system/kaori*.path
     ${overlay}/systemd/system/kaori.target)
list(FILTER units EXCLUDE REGEX "kaori-(update|confirm|other|trial|reset)\\.")  # They want the slots of rootfs/image's disk.
list(FILTER units EXCLUDE REGEX "kaori-desk\\.")  # It waits for the address that kaori-boot gives a box.
install(FILES ${units} DESTINATION ${KAORI_UNIT_DIR})
install(DIRECTORY ${overlay}/systemd/system/kaori-.service.d ${overlay}/systemd/system/kaori-shows.service.d ${overlay}/systemd/system/kaori.target.wants DESTINATION ${KAORI_UNIT_DIR}
        PATTERN mend-data.service EXCLUDE PATTERN kaori-desk.path EXCLUDE PATTERN kaori-update.socket EXCLUDE PATTERN kaori-confirm.service EXCLUDE PATTERN kaori-other.path EXCLUDE PATTERN kaori-other.timer EXCLUDE PATTERN kaori-trial.timer EXCLUDE PATTERN kaori-reset.service EXCLUDE)

# Which target starts is for the system to say (systemctl set-default kaori.target): its default.target is the file of systemd's package.
if(KAORI_BOX_SYSTEM)
  install(FILES ${overlay}/systemd/system/var-lib-kaori.mount ${overlay}/systemd/system/mend-data.service DESTINATION ${KAORI_UNIT_DIR})
  install(FILES ${overlay}/systemd/system/kaori.target.wants/mend-data.service DESTINATION ${KAORI_UNIT_DIR}/kaori.target.wants)
else()
  # Beside whatever else the system does: `systemctl enable kaori.target` starts the show with it, and its data have a folder.
  install(FILES ${PROJECT_SOURCE_DIR}/rootfs/tmpfiles.conf DESTINATION ${KAORI_TMPFILES_DIR} RENAME kaori.conf)
endif()
