/* What the files of this room share about profiles. */
#ifndef ASP_SURFACE_PROFILE_H
#define ASP_SURFACE_PROFILE_H

#include "asperity.h"

enum { ASP_POINTS_LEAST = 3 };

/* Whether it repeats, or goes on beyond its ends as its mirror image. */
bool aspi_profile_periodic(const asp_profile *profile);

/* The most numbers that GSL's FFT by powers of two takes: it shifts an int. */
#define ASP_FFT_MOST ((size_t)1 << 30)

/* A profile that takes over `heights` (from malloc; NULL counts as out of memory), and frees them
 * when it fails. */
asp_profile *aspi_profile_adopt(double *heights, size_t points, double spacing, bool periodic,
                                asp_error *error);

/* The least power of two that is at least that. */
size_t aspi_power_of_two(size_t least);

/* Uninitialised room for numbers, or NULL. */
double *aspi_allocate(size_t count);

#endif
