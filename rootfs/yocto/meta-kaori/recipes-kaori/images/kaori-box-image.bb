SUMMARY = "A system that is a Kaori box and nothing else"
DESCRIPTION = "Starts kaori-boot, which becomes systemd, and shows the face. Nobody logs in; nothing listens on a network."
LICENSE = "Apache-2.0"

inherit core-image features_check

# kaori-boot looks for systemd in /usr/lib.
REQUIRED_DISTRO_FEATURES = "systemd usrmerge opengl"

IMAGE_FEATURES = "read-only-rootfs"
# Kernels of a BSP have USB cameras, HID devices, serial adapters and sound cards as modules.
IMAGE_INSTALL = "packagegroup-core-boot kernel-modules kaori-box kaori-box-boot mesa-megadriver ${CORE_IMAGE_EXTRA_INSTALL}"
IMAGE_LINGUAS = ""

# What a box starts; multi-user.target, which it would be else, wants a getty on each console.
SYSTEMD_DEFAULT_TARGET = "kaori.target"

IMAGE_FSTYPES = "wic wic.bmap"
WKS_FILE = "kaori-box.wks"
WKS_FILE:rpi = "kaori-box-raspberrypi.wks"
WKS_FILE_DEPENDS:append = " e2fsprogs-native"

# Where var-lib-kaori.mount and the rest of what writes find a folder.
create_mount_points() {
    install -d ${IMAGE_ROOTFS}/var/lib/kaori
}
ROOTFS_POSTPROCESS_COMMAND += "create_mount_points;"
