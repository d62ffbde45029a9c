// Macros that user code names. Everything is linked statically.
#pragma once

#define KDL_PARSER_EXPORT
#define KDL_PARSER_IMPORT
#define KDL_PARSER_PUBLIC
#define KDL_PARSER_LOCAL
