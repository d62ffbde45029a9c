// Upstream's macro for exported symbols. Here everything is linked statically.
#pragma once

#define TF2_EXPORT
#define TF2_IMPORT
#define TF2_PUBLIC
#define TF2_LOCAL
#define TF2_PUBLIC_TYPE
