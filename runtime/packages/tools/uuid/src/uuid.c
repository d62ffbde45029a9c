/* See uuid.h. */
#include "uuid/uuid.h"

#include <stdint.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

/* Steps of 100 ns from 1582-10-15, where these clocks begin, to 1970. */
static const uint64_t kStepsToEpoch = 0x01B21DD213814000ULL;
static const uint64_t kStepsPerSecond = 10000000;

/* Texts have 8, 4, 4, 4 and 12 digits. */
static int is_hyphen(int at) {
  return at == 8 || at == 13 || at == 18 || at == 23;
}

void uuid_clear(uuid_t uu) {
  memset(uu, 0, sizeof(uuid_t));
}
int uuid_compare(const uuid_t uu1, const uuid_t uu2) {
  return memcmp(uu1, uu2, sizeof(uuid_t));
}
void uuid_copy(uuid_t dst, const uuid_t src) {
  memcpy(dst, src, sizeof(uuid_t));
}
int uuid_type(const uuid_t uu) {
  return uu[6] >> 4;
}

int uuid_is_null(const uuid_t uu) {
  static const uuid_t kNull = {0};
  return uuid_compare(uu, kNull) == 0;
}

static void mark(uuid_t uu, int type) {
  uu[6] = (unsigned char)((uu[6] & 0x0F) | type << 4);
  uu[8] = (unsigned char)((uu[8] & 0x3F) | 0x80);
}

void uuid_generate_random(uuid_t out) {
  getentropy(out, sizeof(uuid_t));
  mark(out, UUID_TYPE_DCE_RANDOM);
}

void uuid_generate(uuid_t out) {
  uuid_generate_random(out);
}

/* Low, middle and high bits of the time are at 0, 4 and 6, each with its highest byte first. */
void uuid_generate_time(uuid_t out) {
  struct timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  const uint64_t time =
      (uint64_t)now.tv_sec * kStepsPerSecond + (uint64_t)now.tv_nsec / 100 + kStepsToEpoch;
  getentropy(out, sizeof(uuid_t));
  for (int i = 0; i < 4; ++i) out[i] = (unsigned char)(time >> (24 - 8 * i));
  for (int i = 0; i < 2; ++i) out[4 + i] = (unsigned char)(time >> (40 - 8 * i));
  for (int i = 0; i < 2; ++i) out[6 + i] = (unsigned char)(time >> (56 - 8 * i));
  out[10] |= 0x01; /* not the address of a network card */
  mark(out, UUID_TYPE_DCE_TIME);
}

int uuid_generate_time_safe(uuid_t out) {
  uuid_generate_time(out);
  return 0;
}

time_t uuid_time(const uuid_t uu, struct timeval* ret_tv) {
  uint64_t time = uu[6] & 0x0F;
  time = time << 8 | uu[7];
  for (int i = 4; i < 6; ++i) time = time << 8 | uu[i];
  for (int i = 0; i < 4; ++i) time = time << 8 | uu[i];
  time -= kStepsToEpoch;
  if (ret_tv != NULL) {
    ret_tv->tv_sec = (time_t)(time / kStepsPerSecond);
    ret_tv->tv_usec = (suseconds_t)(time % kStepsPerSecond / 10);
  }
  return (time_t)(time / kStepsPerSecond);
}

int uuid_variant(const uuid_t uu) {
  if ((uu[8] & 0x80) == 0) return UUID_VARIANT_NCS;
  if ((uu[8] & 0x40) == 0) return UUID_VARIANT_DCE;
  return (uu[8] & 0x20) == 0 ? UUID_VARIANT_MICROSOFT : UUID_VARIANT_OTHER;
}

static int value_of(char digit) {
  if (digit >= '0' && digit <= '9') return digit - '0';
  if (digit >= 'a' && digit <= 'f') return digit - 'a' + 10;
  if (digit >= 'A' && digit <= 'F') return digit - 'A' + 10;
  return -1;
}

int uuid_parse(const char* in, uuid_t uu) {
  uuid_t parsed = {0};
  if (strlen(in) != UUID_STR_LEN - 1) return -1;
  for (int at = 0, digit = 0; at < UUID_STR_LEN - 1; ++at) {
    if (is_hyphen(at)) {
      if (in[at] != '-') return -1;
      continue;
    }
    const int value = value_of(in[at]);
    if (value < 0) return -1;
    parsed[digit / 2] = (unsigned char)(parsed[digit / 2] << 4 | value);
    ++digit;
  }
  uuid_copy(uu, parsed);
  return 0;
}

static void unparse(const uuid_t uu, char* out, const char* digits) {
  for (int at = 0, digit = 0; at < UUID_STR_LEN - 1; ++at) {
    if (is_hyphen(at)) {
      out[at] = '-';
      continue;
    }
    const int shift = digit % 2 == 0 ? 4 : 0;
    out[at] = digits[uu[digit / 2] >> shift & 0x0F];
    ++digit;
  }
  out[UUID_STR_LEN - 1] = '\0';
}

void uuid_unparse(const uuid_t uu, char* out) {
  uuid_unparse_lower(uu, out);
}
void uuid_unparse_lower(const uuid_t uu, char* out) {
  unparse(uu, out, "0123456789abcdef");
}
void uuid_unparse_upper(const uuid_t uu, char* out) {
  unparse(uu, out, "0123456789ABCDEF");
}
