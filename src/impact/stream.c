/* The public face of the random numbers of one contact; see stream.h. */
#include "impact/stream.h"

#include <gsl/gsl_cdf.h>

uint32_t asp_key_fix(const char *name) {
  uint32_t hash = 2166136261u; /* FNV-1a offset basis and prime */
  for (const unsigned char *c = (const unsigned char *)name; *c; c++)
    hash = (hash ^ *c) * 16777619u;
  return hash;
}

asp_stream asp_stream_create(const asp_key *key) {
  return asp_stream_begin(key);
}

void asp_stream_refill(asp_stream *stream) {
  asp_stream_fill(stream);
}

double asp_stream_uniform(asp_stream *stream) {
  return asp_stream_next(stream);
}

double asp_stream_normal(asp_stream *stream) {
  return gsl_cdf_ugaussian_Pinv(asp_stream_uniform(stream));
}
