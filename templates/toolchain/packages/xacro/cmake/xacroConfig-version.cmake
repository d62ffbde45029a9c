# Any version that is asked for.
set(PACKAGE_VERSION 99.0.0)
set(PACKAGE_VERSION_COMPATIBLE TRUE)
