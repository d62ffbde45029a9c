// Marks of exported names, for code that still has them. A site links statically.
#pragma once

#define HARDWARE_INTERFACE_EXPORT
#define HARDWARE_INTERFACE_IMPORT
#define HARDWARE_INTERFACE_PUBLIC
#define HARDWARE_INTERFACE_PUBLIC_TYPE
#define HARDWARE_INTERFACE_LOCAL
