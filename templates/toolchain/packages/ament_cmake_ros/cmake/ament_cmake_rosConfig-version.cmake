# Any version that is asked for.
set(PACKAGE_VERSION 0.12.0)
set(PACKAGE_VERSION_COMPATIBLE TRUE)
