// Marks for clang's thread safety analysis.
#pragma once

#include <mutex>

#if defined(__clang__) && defined(_LIBCPP_HAS_THREAD_SAFETY_ANNOTATIONS)
#define RCPPUTILS_THREAD_ANNOTATION_ATTRIBUTE_(x) __attribute__((x))
#else
#define RCPPUTILS_THREAD_ANNOTATION_ATTRIBUTE_(x)
#endif

#define RCPPUTILS_TSA_GUARDED_BY(x) RCPPUTILS_THREAD_ANNOTATION_ATTRIBUTE_(guarded_by(x))
#define RCPPUTILS_TSA_PT_GUARDED_BY(x) RCPPUTILS_THREAD_ANNOTATION_ATTRIBUTE_(pt_guarded_by(x))
#define RCPPUTILS_TSA_REQUIRES(...) \
  RCPPUTILS_THREAD_ANNOTATION_ATTRIBUTE_(requires_capability(__VA_ARGS__))
#define RCPPUTILS_TSA_ACQUIRE(...) \
  RCPPUTILS_THREAD_ANNOTATION_ATTRIBUTE_(acquire_capability(__VA_ARGS__))
#define RCPPUTILS_TSA_RELEASE(...) \
  RCPPUTILS_THREAD_ANNOTATION_ATTRIBUTE_(release_capability(__VA_ARGS__))
#define RCPPUTILS_TSA_EXCLUDES(...) \
  RCPPUTILS_THREAD_ANNOTATION_ATTRIBUTE_(locks_excluded(__VA_ARGS__))
#define RCPPUTILS_TSA_NO_ANALYSIS \
  RCPPUTILS_THREAD_ANNOTATION_ATTRIBUTE_(no_thread_safety_analysis)
