# Any version that is asked for.
set(PACKAGE_VERSION 2.5.4)
set(PACKAGE_VERSION_COMPATIBLE TRUE)
