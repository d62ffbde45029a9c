// Marks of exported names, for code that still has them. A site links statically.
#pragma once

#define CONTROLLER_INTERFACE_EXPORT
#define CONTROLLER_INTERFACE_IMPORT
#define CONTROLLER_INTERFACE_PUBLIC
#define CONTROLLER_INTERFACE_PUBLIC_TYPE
#define CONTROLLER_INTERFACE_LOCAL
