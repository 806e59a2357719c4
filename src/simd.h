/* Loops over many contacts that the compiler turns into vector code, for the vector units that it
 * finds at run time. The GNU C library has vector versions of the functions declared here;
 * declaring that is all it takes. A file that uses this is compiled as src/CMakeLists.txt says for
 * it. */
#ifndef ASP_SIMD_H
#define ASP_SIMD_H

#include <math.h>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__GLIBC__)
#if __GLIBC_PREREQ(2, 35)
#define ASP_SIMD __attribute__((simd("notinbranch")))
ASP_SIMD double exp(double);
ASP_SIMD double log(double);
#if __GNUC__ >= 12
#define ASP_AVX512 "arch=x86-64-v4"
#else
#define ASP_AVX512 "avx512f"
#endif
#define ASP_EACH_MACHINE __attribute__((target_clones(ASP_AVX512, "avx2", "default")))
#endif
#endif
#ifndef ASP_EACH_MACHINE
#define ASP_EACH_MACHINE
#endif

#endif
