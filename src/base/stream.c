/* The random numbers of one contact: Philox4x32-10 of Random123 (Salmon, Moraes, Dror & Shaw 2011),
 * a pure function of key and counter. One block of four 32-bit words is two uniform numbers; the
 * counter is (tag low, tag high, impact, block).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/stream.h"

#include <Random123/philox.h>
#include <gsl/gsl_cdf.h>

#define UNIFORM_STEP 1.1102230246251565e-16 /* 2^-53 */

uint32_t asp_key_wall(const char *name) {
  uint32_t hash = 2166136261u; /* FNV-1a offset basis and prime */
  for (const unsigned char *c = (const unsigned char *)name; c && *c; c++)
    hash = (hash ^ *c) * 16777619u;
  return hash;
}

aspi_stream aspi_stream_begin(const asp_key *key) {
  aspi_stream stream = {{key->seed, key->wall},
                        {(uint32_t)key->tag, (uint32_t)(key->tag >> 32), key->impact, 0},
                        {0},
                        0};
  return stream;
}

double aspi_stream_trait(const asp_key *key, aspi_trait of) {
  aspi_stream stream =
      aspi_stream_begin(&(asp_key){key->seed, asp_key_wall("grain"), key->tag, (uint32_t)of, 0});
  return aspi_stream_normal(&stream);
}

/* From the upper 53 bits of two words, and half a step, so that 0 and 1 cannot come out. Above 0.5
 * the half is rounded to an even number of steps, and the steps are twice as wide. */
static double uniform_of(uint32_t high, uint32_t low) {
  double u = ((double)(((uint64_t)high << 32 | low) >> 11) + 0.5) * UNIFORM_STEP;
  return u < 1 ? u : 1 - UNIFORM_STEP;
}

double aspi_stream_uniform(aspi_stream *stream) {
  if (stream->left == 0) {
    philox4x32_key_t key = {{stream->key[0], stream->key[1]}};
    philox4x32_ctr_t counter = {
        {stream->counter[0], stream->counter[1], stream->counter[2], stream->counter[3]++}};
    philox4x32_ctr_t word = philox4x32(counter, key);
    stream->ready[0] = uniform_of(word.v[0], word.v[1]);
    stream->ready[1] = uniform_of(word.v[2], word.v[3]);
    stream->left = 2;
  }
  return stream->ready[2 - stream->left--];
}

double aspi_stream_normal(aspi_stream *stream) {
  return gsl_cdf_ugaussian_Pinv(aspi_stream_uniform(stream));
}
