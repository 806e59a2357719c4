/* Many contacts at once: the straight code of a contact in vector loops over blocks. Whatever is
 * not straight (a second draw, a normal impact, a threshold) is left to asp_wall_impact, which
 * begins that contact anew. */
#include "impact/frame.h"
#include "impact/stream.h"
#include "impact/wall.h"
#include "simd.h"
#include "spread/models.h"

/* A rebound whose slope is below this is for asp_wall_impact to judge. */
#define NEARLY_ALONG 1e-10

typedef double row[ASP_BATCH];

/* One block, by component. */
typedef struct block {
  row n[3], along[3], v_n, v_t, per_length; /* the frame */
  row d_p, density, modulus, yield_stress, surface_energy, friction;
  row slope, sigma, alpha1, u, delta, sine, cosine;
  row v_n1, v_t1, side, v_n2, v_t2, v[3]; /* the hit; side: the sign of the speed along the face */
  row near, again, stays; /* 1 or 0; near a threshold; for asp_wall_impact; a deposit */
  uint32_t seed[ASP_BATCH], fix[ASP_BATCH], low[ASP_BATCH], high[ASP_BATCH], number[ASP_BATCH];
  uint32_t word[2][ASP_BATCH];
} block;

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

static void load_keys(block *b, size_t count, const asp_key *key) {
  for (size_t i = 0; i < count; i++) {
    b->seed[i] = key[i].seed;
    b->fix[i] = key[i].fix;
    b->low[i] = (uint32_t)key[i].tag;
    b->high[i] = (uint32_t)(key[i].tag >> 32);
    b->number[i] = key[i].impact;
  }
}

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
}

ASP_EACH_MACHINE
static void find_frames(block *b, size_t count, const double (*v1)[3], const double (*n)[3]) {
#pragma omp simd
  for (size_t i = 0; i < count; i++) {
    bool plain;
    frame f =
        plain_frame((vec){v1[i][0], v1[i][1], v1[i][2]}, (vec){n[i][0], n[i][1], n[i][2]}, &plain);
    b->n[0][i] = f.n.x;
    b->n[1][i] = f.n.y;
    b->n[2][i] = f.n.z;
    b->along[0][i] = f.along.x;
    b->along[1][i] = f.along.y;
    b->along[2][i] = f.along.z;
    b->v_n[i] = f.v_n;
    b->v_t[i] = f.v_t;
    b->per_length[i] = f.per_length;
    b->again[i] = plain ? 0 : 1;
  }
}

ASP_EACH_MACHINE
static void find_angles(block *b, size_t count) {
#pragma omp simd
  for (size_t i = 0; i < count; i++)
    b->alpha1[i] = angle_of(b->v_n[i], b->v_t[i]);
}

/* The first uniform number of each contact. */
ASP_EACH_MACHINE
static void draw(block *b, size_t count) {
#pragma omp simd
  for (size_t i = 0; i < count; i++) {
    philox4x32_key_t key = {{b->seed[i], b->fix[i]}};
    philox4x32_ctr_t counter = {{b->low[i], b->high[i], b->number[i], 0}};
    philox4x32_ctr_t word = philox4x32(counter, key);
    b->word[0][i] = word.v[0];
    b->word[1][i] = word.v[1];
  }
#pragma omp simd
  for (size_t i = 0; i < count; i++)
    b->u[i] = asp_uniform_of(b->word[0][i], b->word[1][i]);
}

ASP_EACH_MACHINE
static void tilt(block *b, size_t count) {
#pragma omp simd
  for (size_t i = 0; i < count; i++) {
    asp_turn by = asp_turn_by(b->delta[i]);
    b->sine[i] = by.sine;
    b->cosine[i] = by.cosine;
  }
}

static void tilt_nothing(block *b, size_t count) {
  for (size_t i = 0; i < count; i++) {
    b->delta[i] = b->sine[i] = 0;
    b->cosine[i] = 1;
  }
}

/* The hit in the frame of its face, by the straight part of `rebound` in impact.c. A particle with
 * no direction of flight is left out where one has to be drawn. */
ASP_EACH_MACHINE
static void meet(block *b, size_t count) {
#pragma omp simd
  for (size_t i = 0; i < count; i++) {
    double s = b->sine[i], c = b->cosine[i], speed = b->v_t[i] * c - b->v_n[i] * s;
    b->v_n1[i] = b->v_n[i] * c + b->v_t[i] * s;
    b->v_t1[i] = fabs(speed);
    b->side[i] = speed < 0 ? -1 : 1;
    b->again[i] += b->v_n1[i] > 0 ? 0 : 1;
  }
}

/* The rebound, back in the lab frame, and whether it is clear how it ends. */
ASP_EACH_MACHINE
static void turn_back(block *b, size_t count, bool deposits) {
  double least = deposits ? 0 : -1;
#pragma omp simd
  for (size_t i = 0; i < count; i++) {
    double n2 = b->v_n2[i], t2 = b->side[i] * b->v_t2[i], s = b->sine[i], c = b->cosine[i];
    double x = t2 * c - n2 * s, z = n2 * c + t2 * s;
    vec n = {b->n[0][i], b->n[1][i], b->n[2][i]};
    vec along = {b->along[0][i], b->along[1][i], b->along[2][i]};
    vec v = plus(scaled(along, x * b->per_length[i]), z, n);
    double moves = n2 > least ? 1 : 0;
    bool clear = (z > NEARLY_ALONG * fabs(x)) & clearly_leaves(v, n);
    b->v[0][i] = v.x * moves;
    b->v[1][i] = v.y * moves;
    b->v[2][i] = v.z * moves;
    b->stays[i] = 1 - moves;
    b->again[i] += b->near[i] + (clear ? 0 : moves);
  }
}

static void store_impacts(const block *b, size_t count, asp_impact *impact) {
  for (size_t i = 0; i < count; i++)
    impact[i] = (asp_impact){.v2 = {b->v[0][i], b->v[1][i], b->v[2][i]},
                             .delta_alpha = b->delta[i],
                             .hits = 1,
                             .outcome = b->stays[i] > 0 ? ASP_DEPOSIT : ASP_REBOUND};
}

/* False where the law has no such call with these parameters. */
static bool run_block(block *b, const asp_wall *wall, size_t count, const asp_particle *particle,
                      const double (*v1)[3], const double (*n)[3], const asp_key *key,
                      asp_impact *impact) {
  load_particles(b, count, particle);
  find_frames(b, count, v1, n);
  if (wall->rough) {
    load_keys(b, count, key);
    load_slopes(b, count, wall);
    find_angles(b, count);
    draw(b, count);
    asp_views views = {b->slope, b->sigma, b->alpha1, b->d_p, wall->data};
    asp_views_quantile(wall->spread, &views, count, b->u, b->delta);
    tilt(b, count);
  } else
    tilt_nothing(b, count);
  meet(b, count);
  asp_hits hits = {b->v_n1,         b->v_t1,           b->d_p,      b->density,   b->modulus,
                   b->yield_stress, b->surface_energy, b->friction, wall->deposit};
  if (!wall->law->rebound_n(wall->parameters, &hits, count, b->v_n2, b->v_t2, b->near))
    return false;
  turn_back(b, count, wall->deposit);
  store_impacts(b, count, impact);
  for (size_t i = 0; i < count; i++)
    if (b->again[i] > 0)
      asp_wall_impact(wall, &particle[i], v1[i], n[i], key[i], &impact[i]);
  return true;
}

static bool is_straight(const asp_wall *wall) {
  bool tilts = !wall->rough || (wall->spread->quantile && !wall->multiple && !wall->isotropic);
  return tilts && wall->law->rebound_n;
}

void asp_wall_impact_n(const asp_wall *wall, size_t count, const asp_particle *particle,
                       const double (*v1)[3], const double (*n)[3], const asp_key *key,
                       asp_impact *impact) {
  block b;
  bool straight = is_straight(wall);
  for (size_t i = 0; i < count; i += ASP_BATCH) {
    size_t size = count - i < ASP_BATCH ? count - i : ASP_BATCH;
    straight =
        straight && run_block(&b, wall, size, particle + i, v1 + i, n + i, key + i, impact + i);
    for (size_t j = i; j < i + size && !straight; j++)
      asp_wall_impact(wall, &particle[j], v1[j], n[j], key[j], &impact[j]);
  }
}
