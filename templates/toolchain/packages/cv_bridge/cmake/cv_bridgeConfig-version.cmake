# Any version that is asked for.
set(PACKAGE_VERSION 4.1.0)
set(PACKAGE_VERSION_COMPATIBLE TRUE)
