// Macros that user code names. Everything is linked statically.
#pragma once

#define TF2_EIGEN_KDL_PUBLIC
#define TF2_EIGEN_KDL_LOCAL
#define TF2_EIGEN_KDL_PUBLIC_TYPE
