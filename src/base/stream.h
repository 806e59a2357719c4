/* The random numbers of one contact: Philox4x32-10 (Salmon et al. 2011) keyed by (seed, wall),
 * counted by (tag, impact, block of two draws). Lives on the stack.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity.h"

typedef struct aspi_stream {
  uint32_t key[2];
  uint32_t counter[4];
  double ready[2]; /* numbers that are drawn already, the last `left` of them */
  int left;
} aspi_stream;

/* The stream of a contact, at its beginning. */
aspi_stream aspi_stream_begin(const asp_key *key);

/* Properties of a grain that stay the same at all contacts, on all walls with one seed. */
typedef enum aspi_trait { ASPI_TRAIT_YIELD = 1, ASPI_TRAIT_ADHESION } aspi_trait;

/* A standard normal number of the seed and the tag of a key alone. */
double aspi_stream_trait(const asp_key *key, aspi_trait of);

/* The next uniform number of the stream, strictly between 0 and 1: in steps of 2^-53
 * below 0.5 and of 2^-52 above. */
double aspi_stream_uniform(aspi_stream *stream);

/* The next standard normal number of the stream (inverse transform, one uniform each). */
double aspi_stream_normal(aspi_stream *stream);
