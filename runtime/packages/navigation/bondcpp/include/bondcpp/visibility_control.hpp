// Every symbol of a static library is visible.
#pragma once

#define BONDCPP_EXPORT
#define BONDCPP_IMPORT
#define BONDCPP_PUBLIC
#define BONDCPP_LOCAL
