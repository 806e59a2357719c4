/* Functions that are compiled for several kinds of machine, one of which is chosen when a program
 * starts: on x86-64, with the wide vectors and the fused multiplications and additions that the
 * processor has. */
#ifndef ASP_MACHINE_H
#define ASP_MACHINE_H

#include <math.h> /* any header of the C library says whether it is GNU's */

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__GLIBC__)
#if __GNUC__ >= 12
#define ASP_EACH_MACHINE                                                                           \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define ASP_EACH_MACHINE __attribute__((target_clones("avx512f", "arch=haswell", "default")))
#endif
#else
#define ASP_EACH_MACHINE
#endif

#endif
