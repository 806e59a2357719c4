/* Many contacts at once: the straight code of a contact in vector loops over blocks. Contacts whose
 * face sends the particle into the wall, or cannot be hit, wait until they fill a block of their
 * own, and are drawn again there. Whatever is not straight (a normal impact, a threshold) is left
 * to asp_wall_impact, which begins that contact anew. */
#include "impact/frame.h"
#include "impact/stream.h"
#include "impact/wall.h"
#include "simd.h"
#include "spread/models.h"

#include <string.h>

/* A rebound, or an approach to a face, whose slope is below this is for asp_wall_impact to judge.
 */
#define NEARLY_ALONG 1e-10

/* Contacts as asp_wall_impact_n is given them: all, or those of a block. */
typedef struct contacts {
  const asp_particle *particle;
  const double (*v1)[3], (*n)[3];
  const asp_key *key;
  asp_impact *impact;
} contacts;

typedef double row[ASP_BATCH];

/* What becomes of a contact: done, another draw, or all of it by asp_wall_impact. */
enum { DONE, REDRAW, ANEW };

/* One block, by component; rows at the beginning of a cache line, so that no vector is across two.
 */
typedef struct block {
  _Alignas(64) uint16_t drawn[ASP_BATCH];   /* draws so far */
  row n[3], along[3], v_n, v_t, per_length; /* the frame */
  row d_p, density, modulus, yield_stress, surface_energy, friction;
  row slope, sigma, alpha1, u, delta, sine, cosine;
  row v_n1, v_t1, side, v_n2, v_t2, v[3]; /* the hit; side: the sign of the speed along the face */
  row known, near;                        /* 1 or 0; the frame; near a threshold */
  size_t outcome[ASP_BATCH], fate[ASP_BATCH];
  uint64_t tag[ASP_BATCH];
  uint32_t seed[ASP_BATCH], fix[ASP_BATCH], number[ASP_BATCH];
  uint32_t word[2][ASP_BATCH];
  double of_one; /* the rows d_p, slope and sigma hold this size in all places; or 0 */
} block;

/* A batch under way. Contacts that wait are to be drawn again, and have been drawn so often. */
typedef struct batch {
  const asp_wall *wall;
  contacts all;
  block b;
  size_t at[ASP_BATCH]; /* the places of a block's contacts that are drawn again */
  size_t n_waiting, waiting[2 * ASP_BATCH];
  uint16_t drawn[2 * ASP_BATCH];
} batch;

/* Whether all are of the first one's size, density and pair: a record without gaps. */
static bool are_alike(size_t count, const asp_particle *particle) {
  return memcmp(particle, particle + 1, (count - 1) * sizeof *particle) == 0;
}

/* Of particles that are alike, the first. */
static void load_particles(block *b, size_t count, const asp_particle *particle) {
  for (size_t i = 0; i < count; i++) {
    b->d_p[i] = particle[i].d_p;
    b->density[i] = particle[i].density;
    b->modulus[i] = particle[i].pair->modulus;
    b->yield_stress[i] = particle[i].pair->yield_stress;
    b->surface_energy[i] = particle[i].pair->surface_energy;
    b->friction[i] = particle[i].pair->friction;
  }
}

/* Copied and taken apart in vector code where a key is three words of 64 bits, low halves first. */
#ifdef __x86_64__
_Static_assert(sizeof(asp_key) == 24 && offsetof(asp_key, tag) == 8, "load_keys");

ASP_EACH_MACHINE
static void load_keys(block *b, size_t count, const asp_key *key) {
  uint64_t word[3 * ASP_BATCH];
  memcpy(word, key, count * sizeof *key);
#pragma omp simd
  for (size_t i = 0; i < count; i++) {
    b->seed[i] = (uint32_t)word[3 * i];
    b->fix[i] = (uint32_t)(word[3 * i] >> 32);
    b->tag[i] = word[3 * i + 1];
    b->number[i] = (uint32_t)word[3 * i + 2];
  }
}
#else
static void load_keys(block *b, size_t count, const asp_key *key) {
  for (size_t i = 0; i < count; i++) {
    b->seed[i] = key[i].seed;
    b->fix[i] = key[i].fix;
    b->tag[i] = key[i].tag;
    b->number[i] = key[i].impact;
  }
}
#endif

/* The wall as each particle meets it; the same again for neighbours of one size. */
static void load_slopes(block *b, size_t count, const asp_wall *wall) {
  double d_p = -1, slope = 0, sigma = 0;
  for (size_t i = 0; i < count; i++) {
    if (b->d_p[i] < d_p || b->d_p[i] > d_p) {
      d_p = b->d_p[i];
      slope = asp_surface_slope(wall->surface, d_p);
      sigma = asp_wall_sigma(wall, slope);
    }
    b->slope[i] = slope;
    b->sigma[i] = sigma;
  }
  b->of_one = 0;
}

/* The same for particles of one size, which the block before may have had. */
ASP_EACH_MACHINE
static void load_slope(block *b, const asp_wall *wall) {
  double d_p = b->d_p[0], slope, sigma;
  if (!(d_p < b->of_one) && !(d_p > b->of_one))
    return;
  slope = asp_surface_slope(wall->surface, d_p);
  sigma = asp_wall_sigma(wall, slope);
  for (size_t i = 0; i < ASP_BATCH; i++) {
    b->d_p[i] = d_p;
    b->slope[i] = slope;
    b->sigma[i] = sigma;
  }
  b->of_one = d_p;
}

static inline void store_frame(block *b, size_t i, frame f, bool known) {
  b->n[0][i] = f.n.x;
  b->n[1][i] = f.n.y;
  b->n[2][i] = f.n.z;
  b->along[0][i] = f.along.x;
  b->along[1][i] = f.along.y;
  b->along[2][i] = f.along.z;
  b->v_n[i] = f.v_n;
  b->v_t[i] = f.v_t;
  b->per_length[i] = f.per_length;
  b->known[i] = known ? 1 : 0;
}

/* Returns how many of them are not known yet. */
ASP_EACH_MACHINE
static size_t find_frames(block *b, size_t count, const double (*v1)[3], const double (*n)[3]) {
  size_t unknown = 0;
#pragma omp simd reduction(+ : unknown)
  for (size_t i = 0; i < count; i++) {
    bool plain;
    frame f =
        plain_frame((vec){v1[i][0], v1[i][1], v1[i][2]}, (vec){n[i][0], n[i][1], n[i][2]}, &plain);
    store_frame(b, i, f, plain);
    unknown += plain ? 0 : 1;
  }
  return unknown;
}

/* Those that need care, as in asp_wall_impact; a velocity without a direction is left to it. */
static void find_careful_frames(block *b, size_t count, const double (*v1)[3],
                                const double (*n)[3]) {
  for (size_t i = 0; i < count; i++)
    if (b->known[i] < 1) {
      frame f = careful_frame(load(v1[i]), unit(load(n[i])));
      store_frame(b, i, f, has_direction(&f));
    }
}

/* The next uniform number of each contact. Every round of Philox waits for the one before; as
 * `drawn` is of 16 bits, the compiler takes so many contacts at once that the waiting does not
 * show. */
ASP_EACH_MACHINE
static void draw(block *b, size_t count) {
#pragma omp simd
  for (size_t i = 0; i < count; i++) {
    philox4x32_key_t key = {{b->seed[i], b->fix[i]}};
    philox4x32_ctr_t counter = {
        {(uint32_t)b->tag[i], (uint32_t)(b->tag[i] >> 32), b->number[i], b->drawn[i] / 2u}};
    philox4x32_ctr_t word = philox4x32(counter, key);
    bool second = b->drawn[i] % 2 > 0;
    b->word[0][i] = second ? word.v[2] : word.v[0];
    b->word[1][i] = second ? word.v[3] : word.v[1];
  }
#pragma omp simd
  for (size_t i = 0; i < count; i++)
    b->u[i] = asp_uniform_of_halves(b->word[0][i], b->word[1][i]);
}

/* The hit in the frame of its face, by the straight part of `rebound` in impact.c. */
ASP_EACH_MACHINE
static void meet(block *b, size_t count) {
#pragma omp simd
  for (size_t i = 0; i < count; i++) {
    double sine = b->sine[i], cosine = b->cosine[i];
    double speed = b->v_t[i] * cosine - b->v_n[i] * sine;
    b->v_n1[i] = b->v_n[i] * cosine + b->v_t[i] * sine;
    b->v_t1[i] = fabs(speed);
    b->side[i] = speed < 0 ? -1 : 1;
  }
}

/* The same on a smooth wall. */
ASP_EACH_MACHINE
static void meet_mean_wall(block *b, size_t count) {
  for (size_t i = 0; i < count; i++) {
    b->delta[i] = b->sine[i] = 0;
    b->cosine[i] = b->side[i] = 1;
    b->v_n1[i] = b->v_n[i];
    b->v_t1[i] = b->v_t[i];
  }
}

/* The rebound, back in the lab frame, and whether it is clear how it ends, which the last bits of v
 * cannot change. A face that the particle misses by far, or that sends it far into the wall, is one
 * to draw again. Returns how many are not done. */
ASP_EACH_MACHINE
static size_t turn_back(block *b, size_t count, bool deposits) {
  double least = deposits ? 0 : -1;
  size_t left = 0;
#pragma omp simd reduction(+ : left)
  for (size_t i = 0; i < count; i++) {
    double n2 = b->v_n2[i], t2 = b->side[i] * b->v_t2[i], s = b->sine[i], c = b->cosine[i];
    double x = t2 * c - n2 * s, z = n2 * c + t2 * s, doubt = NEARLY_ALONG * fabs(x);
    vec n = {b->n[0][i], b->n[1][i], b->n[2][i]};
    vec along = {b->along[0][i], b->along[1][i], b->along[2][i]};
    vec v = plus(scaled(along, x * b->per_length[i]), z, n);
    bool moves = n2 > least, misses = b->v_n1[i] < -NEARLY_ALONG * b->v_t1[i];
    bool hits = (b->v_n1[i] > NEARLY_ALONG * b->v_t1[i]) & (b->near[i] < 0.5);
    bool ends = hits & ((n2 <= least) | (z > doubt));
    bool redraw = misses | (hits & moves & (z < -doubt));
    b->v[0][i] = moves ? v.x : 0;
    b->v[1][i] = moves ? v.y : 0;
    b->v[2][i] = moves ? v.z : 0;
    b->outcome[i] = moves ? ASP_REBOUND : ASP_DEPOSIT;
    b->fate[i] = b->known[i] > 0 ? ends ? DONE : redraw ? REDRAW : ANEW : ANEW;
    left += b->fate[i] != DONE;
  }
  return left;
}

static void store_impacts(const block *b, size_t count, asp_impact *impact) {
  for (size_t i = 0; i < count; i++)
    impact[i] = (asp_impact){.v2 = {b->v[0][i], b->v[1][i], b->v[2][i]},
                             .delta_alpha = b->delta[i],
                             .hits = 1,
                             .outcome = (asp_outcome)b->outcome[i]};
}

/* Contact i of the block is left to asp_wall_impact, or waits: it is at `at` in the batch. */
static void leave(batch *k, const contacts *c, size_t i, size_t at) {
  if (k->b.fate[i] == REDRAW && k->wall->rough && k->b.drawn[i] + 1 < ASP_HITS_MAX) {
    k->waiting[k->n_waiting] = at;
    k->drawn[k->n_waiting++] = (uint16_t)(k->b.drawn[i] + 1);
  } else
    asp_wall_impact(k->wall, &c->particle[i], c->v1[i], c->n[i], &c->key[i], &c->impact[i]);
}

/* The block's contacts are at `at` in the batch, or if that is NULL, from `from` on. */
static void finish(batch *k, const contacts *c, size_t count, size_t from, const size_t *at) {
  size_t left[ASP_BATCH], n_left = 0;
  for (size_t i = 0; i < count; i++) {
    left[n_left] = i;
    n_left += k->b.fate[i] != DONE;
  }
  for (size_t j = 0; j < n_left; j++)
    leave(k, c, left[j], at ? at[left[j]] : from + left[j]);
}

/* Returns how many contacts are not done. */
static size_t run_block(const asp_wall *wall, block *b, const contacts *c, size_t count) {
  bool alike = are_alike(count, c->particle);
  load_particles(b, alike ? 1 : count, c->particle);
  if (find_frames(b, count, c->v1, c->n) > 0)
    find_careful_frames(b, count, c->v1, c->n);
  if (wall->rough) {
    load_keys(b, count, c->key);
    if (alike)
      load_slope(b, wall);
    else
      load_slopes(b, count, wall);
    asp_angle_n(count, b->v_n, b->v_t, b->alpha1);
    draw(b, count);
    asp_views views = {b->slope, b->sigma, b->alpha1, b->d_p, wall->data};
    asp_views_quantile(wall->spread, &views, count, b->u, b->delta);
    asp_turn_n(count, b->delta, b->sine, b->cosine);
    meet(b, count);
  } else
    meet_mean_wall(b, count);
  asp_hits hits = {b->v_n1,         b->v_t1,           b->d_p,      b->density, b->modulus,
                   b->yield_stress, b->surface_energy, b->friction, alike,      wall->deposit};
  wall->law->rebound_n(wall->parameters, &hits, count, b->v_n2, b->v_t2, b->near);
  size_t left = turn_back(b, count, wall->deposit);
  store_impacts(b, count, c->impact);
  return left;
}

/* The contacts from `from` on, by their first draw. */
static void run_first(batch *k, size_t from, size_t count) {
  contacts c = {k->all.particle + from, k->all.v1 + from, k->all.n + from, k->all.key + from,
                k->all.impact + from};
  memset(k->b.drawn, 0, sizeof k->b.drawn);
  if (run_block(k->wall, &k->b, &c, count) > 0)
    finish(k, &c, count, from, NULL);
}

/* The last of those that wait, by their next draw. */
static void run_again(batch *k) {
  asp_particle particle[ASP_BATCH];
  double v1[ASP_BATCH][3], n[ASP_BATCH][3];
  asp_key key[ASP_BATCH];
  asp_impact impact[ASP_BATCH];
  size_t count = k->n_waiting < ASP_BATCH ? k->n_waiting : ASP_BATCH;
  k->n_waiting -= count;
  for (size_t i = 0; i < count; i++) {
    size_t at = k->at[i] = k->waiting[k->n_waiting + i];
    k->b.drawn[i] = k->drawn[k->n_waiting + i];
    particle[i] = k->all.particle[at];
    store(load(k->all.v1[at]), v1[i]);
    store(load(k->all.n[at]), n[i]);
    key[i] = k->all.key[at];
  }
  contacts c = {particle, (const double(*)[3])v1, (const double(*)[3])n, key, impact};
  if (run_block(k->wall, &k->b, &c, count) > 0)
    finish(k, &c, count, 0, k->at);
  for (size_t i = 0; i < count; i++)
    k->all.impact[k->at[i]] = impact[i];
}

/* Whether the wall's law and model have calls for many contacts. */
static bool is_straight(const asp_wall *wall) {
  bool tilts = !wall->rough || (wall->spread->quantile && !wall->multiple && !wall->isotropic);
  asp_hits none = {0};
  return tilts && wall->law->rebound_n &&
         wall->law->rebound_n(wall->parameters, &none, 0, NULL, NULL, NULL);
}

static void one_by_one(const asp_wall *wall, size_t count, const contacts *c) {
  for (size_t i = 0; i < count; i++)
    asp_wall_impact(wall, &c->particle[i], c->v1[i], c->n[i], &c->key[i], &c->impact[i]);
}

void asp_wall_impact_n(const asp_wall *wall, size_t count, const asp_particle *particle,
                       const double (*v1)[3], const double (*n)[3], const asp_key *key,
                       asp_impact *impact) {
  batch k;
  k.wall = wall;
  k.all = (contacts){particle, v1, n, key, impact};
  k.n_waiting = 0;
  k.b.of_one = 0;
  if (!is_straight(wall)) {
    one_by_one(wall, count, &k.all);
    return;
  }
  for (size_t i = 0; i < count; i += ASP_BATCH) {
    run_first(&k, i, count - i < ASP_BATCH ? count - i : ASP_BATCH);
    while (k.n_waiting >= ASP_BATCH)
      run_again(&k);
  }
  while (k.n_waiting > 0)
    run_again(&k);
}
