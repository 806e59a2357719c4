/* The path of a particle's centre over a profile, face by face: what `traced` draws from, and what
 * the tables of `profile` are made of. The public part is in asperity.h. */
#ifndef ASP_SPREAD_TRACE_H
#define ASP_SPREAD_TRACE_H

#include "asperity.h"

enum { ASP_BINS_MAX = 256 };

/* The track that belongs to a diameter, of `bins` at equal ratios: the nearest. */
int asp_sizes_nearest(const asp_sizes *sizes, double d_p);

/* The diameter of a bin. */
double asp_sizes_at(const asp_sizes *sizes, int bin);

/* ASP_OK, or ASP_EARG and a message. */
asp_code asp_sizes_check(const asp_sizes *sizes, asp_error *error);

#endif
