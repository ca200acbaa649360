// SPDX-License-Identifier: BSD-3-Clause
/* Preloaded: the mathematical functions of the C library, with another last bit in a third of their
   results, chosen by the arguments. Zeros, infinities, NaN and results of few digits (sin(0),
   pow(2, 3)) stay: every library has these. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

enum { kOneIn = 3 };

static uint64_t mixed(uint64_t bits) {
  bits = (bits ^ (bits >> 33)) * 0xff51afd7ed558ccdU;
  return bits ^ (bits >> 33);
}

static double changed(double x, double y, double result) {
  uint64_t bits, x_bits, y_bits;
  memcpy(&bits, &result, sizeof bits);
  memcpy(&x_bits, &x, sizeof x_bits);
  memcpy(&y_bits, &y, sizeof y_bits);
  if (!isnormal(result) || (bits & 0x3ffffff) == 0) return result;
  const uint64_t hash = mixed(x_bits ^ mixed(y_bits + 77));
  if (hash % kOneIn != 0) return result;
  bits = (hash >> 40) & 1 ? bits + 1 : bits - 1;
  memcpy(&result, &bits, sizeof bits);
  return result;
}

static float changed_float(float x, float y, float result) {
  uint32_t bits;
  memcpy(&bits, &result, sizeof bits);
  if (!isnormal(result) || (bits & 0xfff) == 0) return result;
  const double other = changed(x, y, M_PI);
  if (other != M_PI) bits = other > M_PI ? bits + 1 : bits - 1;
  memcpy(&result, &bits, sizeof bits);
  return result;
}

/* The function of the C library. ISO C converts no pointers to data into pointers to functions. */
static void find(const char* name, void* function) {
  void* const address = dlsym(RTLD_NEXT, name);
  memcpy(function, &address, sizeof address);
}

#define OF_ONE(type, name, change)    \
  type name(type x) {                 \
    type (*original)(type);           \
    find(#name, &original);           \
    return change(x, 0, original(x)); \
  }
#define OF_TWO(type, name, change)       \
  type name(type x, type y) {            \
    type (*original)(type, type);        \
    find(#name, &original);              \
    return change(x, y, original(x, y)); \
  }
#define SINE_AND_COSINE(type, name, change) \
  void name(type x, type* s, type* c) {     \
    void (*original)(type, type*, type*);   \
    find(#name, &original);                 \
    original(x, s, c);                      \
    *s = change(x, 0, *s);                  \
    *c = change(x, 1, *c);                  \
  }
#define BOTH(macro, name) macro(double, name, changed) macro(float, name##f, changed_float)

BOTH(OF_ONE, sin)
BOTH(OF_ONE, cos)
BOTH(SINE_AND_COSINE, sincos)
BOTH(OF_ONE, tan)
BOTH(OF_ONE, asin)
BOTH(OF_ONE, acos)
BOTH(OF_ONE, atan)
BOTH(OF_TWO, atan2)
BOTH(OF_ONE, sinh)
BOTH(OF_ONE, cosh)
BOTH(OF_ONE, tanh)
BOTH(OF_ONE, exp)
BOTH(OF_ONE, exp2)
BOTH(OF_ONE, expm1)
BOTH(OF_ONE, log)
BOTH(OF_ONE, log2)
BOTH(OF_ONE, log10)
BOTH(OF_ONE, log1p)
BOTH(OF_TWO, pow)
BOTH(OF_ONE, cbrt)
BOTH(OF_TWO, hypot)
BOTH(OF_ONE, erf)
BOTH(OF_ONE, erfc)
BOTH(OF_ONE, tgamma)
BOTH(OF_ONE, lgamma)
