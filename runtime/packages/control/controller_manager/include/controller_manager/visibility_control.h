// Marks of exported names, for code that still has them. A site links statically.
#pragma once

#define CONTROLLER_MANAGER_EXPORT
#define CONTROLLER_MANAGER_IMPORT
#define CONTROLLER_MANAGER_PUBLIC
#define CONTROLLER_MANAGER_PUBLIC_TYPE
#define CONTROLLER_MANAGER_LOCAL
