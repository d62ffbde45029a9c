/* Identifiers of 128 bits, as libuuid of util-linux has them, without those made of names. */
#pragma once

#include <sys/time.h>
#include <sys/types.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef unsigned char uuid_t[16];

#define UUID_STR_LEN 37

#define UUID_VARIANT_NCS 0
#define UUID_VARIANT_DCE 1
#define UUID_VARIANT_MICROSOFT 2
#define UUID_VARIANT_OTHER 3

#define UUID_TYPE_DCE_NIL 0
#define UUID_TYPE_DCE_TIME 1
#define UUID_TYPE_DCE_RANDOM 4

void uuid_clear(uuid_t uu);
int uuid_compare(const uuid_t uu1, const uuid_t uu2);
void uuid_copy(uuid_t dst, const uuid_t src);
int uuid_is_null(const uuid_t uu);

/* A random one. */
void uuid_generate(uuid_t out);
void uuid_generate_random(uuid_t out);
/* By time, with a random node. */
void uuid_generate_time(uuid_t out);
/* As uuid_generate_time(); 0, since no other process has the same node. */
int uuid_generate_time_safe(uuid_t out);

/* 0, or -1 when `in` is not 36 characters in the form of an identifier. */
int uuid_parse(const char* in, uuid_t uu);
/* `out` takes UUID_STR_LEN bytes. */
void uuid_unparse(const uuid_t uu, char* out);
void uuid_unparse_lower(const uuid_t uu, char* out);
void uuid_unparse_upper(const uuid_t uu, char* out);

int uuid_type(const uuid_t uu);
int uuid_variant(const uuid_t uu);
/* When an identifier by time was made. */
time_t uuid_time(const uuid_t uu, struct timeval* ret_tv);

#ifdef __cplusplus
}
#endif
