// Macros that user code names. Everything is linked statically.
#pragma once

#define URDF_EXPORT
#define URDF_IMPORT
