// Everything is linked statically: the marks mean nothing.
#pragma once

#define RCPPUTILS_EXPORT
#define RCPPUTILS_IMPORT
#define RCPPUTILS_PUBLIC
#define RCPPUTILS_PUBLIC_TYPE
#define RCPPUTILS_LOCAL
