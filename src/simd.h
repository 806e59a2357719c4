/* Loops over many contacts that the compiler turns into vector code. The GNU C library has vector
 * versions of the functions declared here; declaring that is all it takes. A file that uses this is
 * compiled as src/CMakeLists.txt says for it. */
#ifndef ASP_SIMD_H
#define ASP_SIMD_H

#include "machine.h"

#include <math.h>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__GLIBC__)
#if __GLIBC_PREREQ(2, 35)
#define ASP_SIMD __attribute__((simd("notinbranch")))
ASP_SIMD double exp(double);
ASP_SIMD double log(double);
#endif
#endif

#endif
