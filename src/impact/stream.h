/* The random numbers of one contact: Philox4x32-10 of Random123 (Salmon, Moraes, Dror & Shaw 2011),
 * a pure function of key and counter. One block of four 32-bit words is two uniform numbers; the
 * counter is (tag low, tag high, impact, block). Inline, so that the first draw of a contact stays
 * in registers. */
#ifndef ASP_IMPACT_STREAM_H
#define ASP_IMPACT_STREAM_H

#include "asperity.h"

#include <Random123/philox.h>

#define ASP_UNIFORM_STEP 1.1102230246251565e-16 /* 2^-53 */

/* From 53 bits, and half a step, so that 0 and 1 cannot come out. */
static inline double asp_uniform_at(double bits) {
  double u = (bits + 0.5) * ASP_UNIFORM_STEP;
  return u < 1 ? u : 1 - ASP_UNIFORM_STEP;
}

/* From two words of 32 bits. */
static inline double asp_uniform_of(uint32_t high, uint32_t low) {
  return asp_uniform_at((double)(int64_t)(((uint64_t)high << 32 | low) >> 11));
}

/* The same by signed 32-bit numbers, which every vector unit can turn into doubles. */
static inline double asp_uniform_of_halves(uint32_t high, uint32_t low) {
  double top = (double)(int32_t)(high ^ 0x80000000u) + 2147483648.0;
  return asp_uniform_at(top * 2097152 + (int32_t)(low >> 11));
}

static inline void asp_stream_fill(asp_stream *stream) {
  philox4x32_key_t key = {{stream->key[0], stream->key[1]}};
  philox4x32_ctr_t counter = {
      {stream->counter[0], stream->counter[1], stream->counter[2], stream->counter[3]++}};
  philox4x32_ctr_t word = philox4x32(counter, key);
  stream->ready[0] = asp_uniform_of(word.v[0], word.v[1]);
  stream->ready[1] = asp_uniform_of(word.v[2], word.v[3]);
  stream->left = 2;
}

static inline asp_stream asp_stream_begin(const asp_key *key) {
  asp_stream stream = {{key->seed, key->fix},
                       {(uint32_t)key->tag, (uint32_t)(key->tag >> 32), key->impact, 0},
                       {0},
                       0};
  return stream;
}

/* Out of line: most contacts need no more than the first numbers. */
void asp_stream_refill(asp_stream *stream);

static inline double asp_stream_next(asp_stream *stream) {
  if (stream->left == 0)
    asp_stream_refill(stream);
  return stream->ready[2 - stream->left--];
}

#endif
