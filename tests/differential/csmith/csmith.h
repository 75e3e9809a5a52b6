// What programs of csmith include, for gcc and for oncard. Arithmetic wraps; a divisor of zero, a
// quotient that is too large and a shift by too much give the left operand. The checksum has no
// text: the card has no strings.
#pragma once

#include <limits.h>
#include <stdint.h>

// The result of the program.
static uint32_t checksum = 1;

#define platform_main_begin() (checksum = 1)
#define crc32_gentab() ((void)0)
#define crc32_context 0
#define transparent_crc(value, name, flag) (checksum = checksum * 31 + (uint32_t)(value))
#define printf(...) ((void)0)
#define platform_main_end(crc, flag) ((void)0)

#define SIGNED_ARITHMETIC(T, MIN)                                                                \
  static T safe_unary_minus_func_##T##_s(T a) { return -a; }                                     \
  static T safe_add_func_##T##_s_s(T a, T b) { return a + b; }                                   \
  static T safe_sub_func_##T##_s_s(T a, T b) { return a - b; }                                   \
  static T safe_mul_func_##T##_s_s(T a, T b) { return a * b; }                                   \
  static T safe_div_func_##T##_s_s(T a, T b) {                                                   \
    return b == 0 || (a == (MIN) && b == -1) ? a : a / b;                                        \
  }                                                                                              \
  static T safe_mod_func_##T##_s_s(T a, T b) {                                                   \
    return b == 0 || (a == (MIN) && b == -1) ? a : a % b;                                        \
  }                                                                                              \
  static T safe_lshift_func_##T##_s_s(T a, int b) {                                              \
    return a < 0 || b < 0 || b >= 32 ? a : a << b;                                               \
  }                                                                                              \
  static T safe_lshift_func_##T##_s_u(T a, uint32_t b) { return a < 0 || b >= 32 ? a : a << b; } \
  static T safe_rshift_func_##T##_s_s(T a, int b) {                                              \
    return a < 0 || b < 0 || b >= 32 ? a : a >> b;                                               \
  }                                                                                              \
  static T safe_rshift_func_##T##_s_u(T a, uint32_t b) { return a < 0 || b >= 32 ? a : a >> b; }

#define UNSIGNED_ARITHMETIC(T)                                                              \
  static T safe_unary_minus_func_##T##_u(T a) { return -a; }                                \
  static T safe_add_func_##T##_u_u(T a, T b) { return a + b; }                              \
  static T safe_sub_func_##T##_u_u(T a, T b) { return a - b; }                              \
  static T safe_mul_func_##T##_u_u(T a, T b) { return a * b; }                              \
  static T safe_div_func_##T##_u_u(T a, T b) { return b == 0 ? a : a / b; }                 \
  static T safe_mod_func_##T##_u_u(T a, T b) { return b == 0 ? a : a % b; }                 \
  static T safe_lshift_func_##T##_u_s(T a, int b) { return b < 0 || b >= 32 ? a : a << b; } \
  static T safe_lshift_func_##T##_u_u(T a, uint32_t b) { return b >= 32 ? a : a << b; }     \
  static T safe_rshift_func_##T##_u_s(T a, int b) { return b < 0 || b >= 32 ? a : a >> b; } \
  static T safe_rshift_func_##T##_u_u(T a, uint32_t b) { return b >= 32 ? a : a >> b; }

SIGNED_ARITHMETIC(int8_t, -128)
SIGNED_ARITHMETIC(int16_t, -32768)
SIGNED_ARITHMETIC(int32_t, INT_MIN)
UNSIGNED_ARITHMETIC(uint8_t)
UNSIGNED_ARITHMETIC(uint16_t)
UNSIGNED_ARITHMETIC(uint32_t)
