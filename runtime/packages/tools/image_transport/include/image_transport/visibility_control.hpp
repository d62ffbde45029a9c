// Macros that user code names. Everything is linked statically.
#pragma once

#define IMAGE_TRANSPORT_EXPORT
#define IMAGE_TRANSPORT_IMPORT
#define IMAGE_TRANSPORT_PUBLIC
#define IMAGE_TRANSPORT_LOCAL
