/* One contact: draw the face, turn the velocity into its frame, let the rebound law act, turn back,
 * and make sure that the particle leaves the wall or stays on it.
 *
 * Everything happens in the frame (t, b, n) of the mean wall: n its normal, t the direction of
 * flight along it, b = n x t. The particle comes with (v_t, 0, -v_n); a face with slopes p =
 * tan(delta_alpha) along t and q along b has the normal (-p, -q, 1)/sqrt(1 + p^2 + q^2), written
 * with the sine and cosine of delta_alpha so that a face of 90 degrees is no special case. Vectors,
 * not angles, so that it stays right beyond a local impact angle of 90 degrees, where the
 * tangential CoR turns negative.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/size_law.h"
#include "wall/hit.h"
#include "wall/impact.h"
#include "wall/roughness.h"

#include <math.h>
#include <string.h>

/* Smith's Lambda is under 1e-13 for nu above NU_FREE, and overflows for nu below NU_LEAST. */
#define NU_FREE 5.2
#define NU_LEAST 1e-150

typedef struct face {
  vec m; /* its normal in (t, b, n) */
  double delta, q;
} face;

static double impact_angle(const frame *f) {
  return atan2(f->v_n, f->v_t);
}

/* A direction along the wall for a velocity that has none. */
static void set_direction(frame *f, double angle) {
  double x = fabs(f->n.x), y = fabs(f->n.y), z = fabs(f->n.z);
  vec least = z < fmin(x, y) ? (vec){0, 0, 1} : x <= y ? (vec){1, 0, 0} : (vec){0, 1, 0};
  vec first = cross(f->n, least);
  first = scaled(first, 1 / sqrt(dot(first, first)));
  f->along = plus(scaled(first, cos(angle)), sin(angle), cross(f->n, first));
  f->per_length = 1;
  f->v_t = 0;
}

/* At normal impact the direction of flight is drawn uniformly around n, or is across the lay. */
static void choose_direction(const aspi_roughness *rough, frame *f, aspi_stream *stream) {
  set_direction(f, aspi_roughness_has_lay(rough) ? 0 : 2 * ASP_PI * aspi_stream_uniform(stream));
  if (aspi_roughness_has_lay(rough))
    f->along = rough->across;
}

/* Local roughness at this incidence: the view of the spread models, and the slopes. */
typedef struct incidence {
  aspi_spread_input view;
  aspi_slopes_along slopes;
} incidence;

/* The first hits of a sphere at grazing incidence have smaller slopes (aspi_grazing); models
 * without geometry get them reduced. */
static incidence incidence_at(const aspi_roughness *rough, aspi_heading heading, double alpha1,
                              bool first) {
  const asp_wall *wall = rough->wall;
  incidence out = {.slopes = aspi_roughness_along(rough, heading)};
  double slope = out.slopes.slope;
  if (first && wall->isotropic) {
    double a = tan(alpha1) / slope, across = aspi_grazing(a, out.slopes.kappa_across);
    out.slopes.sd *= across;
    if (!wall->spread->geometry)
      slope *= fabs(rough->shrink - 1) > 0 ? aspi_grazing(a, out.slopes.kappa) : across;
  }
  out.view = (aspi_spread_input){.slope = slope,
                                 .sigma = atan(slope),
                                 .alpha1 = alpha1,
                                 .d_p = rough->particle->d_p,
                                 .data = wall->data,
                                 .kappa = out.slopes.kappa,
                                 .phi_r = out.slopes.phi_r,
                                 .has_azimuth = aspi_roughness_has_lay(rough)};
  if (out.view.has_azimuth)
    out.view.azimuth = -atan2(heading.sine, heading.cosine);
  return out;
}

/* The face of slope angle `delta` along the flight. On isotropic walls its slope across the flight
 * is drawn, unless the model has done so (`path`, else NULL). */
static face face_at(const asp_wall *wall, const aspi_slopes_along *slopes, double delta,
                    const aspi_path *path, aspi_stream *stream) {
  double sine = sin(delta), cosine = cos(delta);
  if (!wall->isotropic)
    return (face){{-sine, 0, cosine}, delta, 0};
  double q = wall->has_cross_slope && path
                 ? path->q
                 : slopes->beta * (sine / cosine) + slopes->sd * aspi_stream_normal(stream),
         side = q * cosine;
  return (face){scaled((vec){-sine, -side, cosine}, 1 / sqrt(1 + side * side)), delta, q};
}

static double tilt_out(const asp_wall *wall, const face *on) {
  return wall->isotropic ? atan(on->q) : 0;
}

/* Turns v off the wall by some last bits, taken from the speed along the wall, so that the kinetic
 * energy does not grow. */
static vec turned_off(const frame *f, vec v) {
  for (int i = 0; i < 8 && !clearly_leaves(v, f->n); i++) {
    double speed = sqrt(dot(v, v)), step = 4 * (double)(1 << i) * DBL_EPSILON;
    v = plus(scaled(v, 1 - step), step * speed, f->n);
  }
  return v;
}

/* Makes sure that v leaves the wall in the lab frame, too: a grazing one may point into it by its
 * last bits. */
static vec leaving(const frame *f, vec v) {
  return clearly_leaves(v, f->n) ? v : turned_off(f, v);
}

/* Eroded mass of a hit, if faces count. */
static double eroded_there(const asp_wall *wall, const asp_particle *particle, const frame *f,
                           vec m) {
  return wall->erosion.tilted ? aspi_hit_erosion(wall, particle, f, m) : 0;
}

static void bounce_off_mean_wall(const asp_wall *wall, const asp_particle *particle,
                                 const frame *in, aspi_stream *stream, asp_impact *impact) {
  frame turned = *in, *f = &turned;
  if ((wall->spins || particle->body) && !has_direction(f))
    set_direction(f, 0);
  vec local, spin = load(particle->omega);
  bool deposit, hit = aspi_hit_rebound(wall, particle, f, (vec){0, 0, 1}, true, stream, &spin,
                                       &local, &deposit);
  store(spin, impact->omega);
  impact->delta_alpha = impact->tilt_out = 0;
  impact->hits = 1;
  impact->eroded = eroded_there(wall, particle, f, (vec){0, 0, 1});
  if (!hit) { /* it does not approach the face and keeps its velocity */
    deposit = false;
    local = (vec){f->v_t, 0, fmax(-f->v_n, 0)};
  }
  vec v2 = to_lab(f, local);
  impact->outcome = deposit ? ASP_DEPOSIT : ASP_REBOUND;
  store(!hit || local.z > 0 ? leaving(f, v2) : v2, impact->v2);
}

/* A particle on its way over a rough wall, from its first hit to its last. */
typedef struct passage {
  const aspi_roughness *rough;
  aspi_heading heading;
  incidence now;
  aspi_stream *stream;
  bool begun;          /* the depth is known */
  double depth;        /* of the particle, see walk_escapes */
  double before, step; /* the depth before the last step, and how far that went */
  const aspi_ratios *ratios;
} passage;

/* Smith's Lambda of a Gaussian wall for a flight at slope nu sqrt(2) s_eff over the mean wall. */
static double smith(double nu) {
  if (nu > NU_FREE)
    return 0;
  nu = fmax(nu, NU_LEAST);
  return 0.5 * (exp(-nu * nu) / (nu * sqrt(ASP_PI)) - erfc(nu));
}

/* The slope of a flight over the mean wall, in (t, b, n). */
static double rise_of(vec out) {
  double along = hypot(out.x, out.y);
  return along <= ASPI_ROUNDING_DOUBLE * fabs(out.z) ? copysign(INFINITY, out.z) : out.z / along;
}

static double exponential(aspi_stream *stream) {
  return -log(aspi_stream_uniform(stream));
}

/* Random walk in height (Heitz, Hanika, d'Eon & Dachsbacher 2016, eq. 17 to 21), in the depth -ln
 * of the share of the wall that is lower than the particle. A flight down adds an exponential
 * number over 1 + Lambda to the depth, a flight up subtracts one over Lambda; the particle escapes
 * when nothing is left. `rise` is the slope of its flight, `slope` the rms slope of the wall along
 * it. */
static bool walk_escapes(passage *fly, double rise, double slope) {
  double lambda = smith(fabs(rise) / (sqrt(2) * slope));
  fly->before = fly->depth;
  if (rise > 0 && !(lambda > 0))
    return true;
  bool first = !fly->begun;
  if (first)
    fly->depth = exponential(fly->stream);
  double step = exponential(fly->stream);
  if (rise > 0 && step / lambda > fly->depth)
    return true;
  if (first)
    fly->depth /= 1 + smith(tan(fly->now.view.alpha1) / (sqrt(2) * fly->now.slopes.slope));
  fly->begun = true;
  fly->before = fly->depth;
  fly->step = rise > 0 ? step / lambda : step / (1 + lambda);
  fly->depth += rise > 0 ? -fly->step : fly->step;
  return fly->depth < 0;
}

/* Log density of a face that is hit. A face that turns away from the particle is drawn again, so
 * the density is divided by the share of the others; most models have none of these. */
static double log_face(const asp_wall *wall, const incidence *at, const face *on) {
  const asp_spread_model *model =
      at->view.alpha1 < 0 && !wall->spread->covers_rising ? wall->rising : wall->spread;
  double tilt = log(model->density(&at->view, on->delta)) -
                log1p(-model->distribution(&at->view, -at->view.alpha1));
  if (!wall->isotropic)
    return tilt;
  double aside = (on->q - at->slopes.beta * tan(on->delta)) / at->slopes.sd;
  return tilt - log(at->slopes.sd) - 0.5 * aside * aside;
}

/* Log density of the last draws of walk_escapes; for an escape after the first hit the probability
 * of escape, integrated over the depth. */
static double log_walk(const passage *fly, const incidence *at, double rise, double slope,
                       bool first, bool escaped) {
  double lambda = smith(fabs(rise) / (sqrt(2) * slope)), sum = 0;
  double fall = first ? 1 + smith(tan(at->view.alpha1) / (sqrt(2) * at->slopes.slope)) : 0;
  if (first && escaped)
    return log(fall / (fall + lambda));
  if (first)
    sum = log(fall) - fall * fly->before;
  if (escaped)
    return sum - lambda * fly->before;
  double rate = rise > 0 ? lambda : 1 + lambda;
  return sum + log(rate) - rate * fly->step;
}

/* Adds the ratios of a hit: of its face, and of the flight that follows with the velocity `out`, in
 * (t, b, n); NULL for a deposit. */
static void add_ratios(const asp_wall *wall, const passage *fly, const frame *now, const face *on,
                       bool first, const vec *out, bool escaped) {
  const aspi_ratios *ratios = fly->ratios;
  for (size_t k = 0; ratios && k < ratios->n; k++) {
    aspi_roughness rough = aspi_roughness_of(ratios->walls[k], fly->rough->particle, now->n);
    incidence at = incidence_at(&rough, fly->heading, fly->now.view.alpha1, first);
    ratios->log[k] += log_face(ratios->walls[k], &at, on) - log_face(wall, &fly->now, on);
    if (!out)
      continue;
    aspi_heading heading = aspi_heading_turned(fly->heading, out->x, out->y);
    double rise = rise_of(*out);
    ratios->log[k] +=
        log_walk(fly, &at, rise, aspi_roughness_along(&rough, heading).slope, first, escaped) -
        log_walk(fly, &fly->now, rise, aspi_roughness_along(fly->rough, heading).slope, first,
                 escaped);
  }
}

/* True if the particle escapes with the velocity `out` that a face has given it, in (t, b, n). */
static bool escapes(const asp_wall *wall, passage *fly, vec out) {
  if (wall->follow)
    return false;
  double slope = fly->now.slopes.slope;
  if (aspi_roughness_has_lay(fly->rough))
    slope = aspi_roughness_along(fly->rough, aspi_heading_turned(fly->heading, out.x, out.y)).slope;
  return walk_escapes(fly, rise_of(out), slope);
}

/* The tilt of the next face; *gone when the model follows the particle over a profile, and it has
 * left. */
static bool next_tilt(const asp_wall *wall, const passage *fly, aspi_path *path, double *delta,
                      bool *gone) {
  const asp_spread_model *model = wall->spread;
  *gone = false;
  if (wall->follow) {
    bool drawn = wall->follow(&fly->now.view, fly->stream, path, delta);
    *gone = !drawn;
    return drawn;
  }
  bool borrows = fly->now.view.alpha1 < 0 && !model->covers_rising;
  return aspi_spread_draw(borrows ? wall->rising : model, &fly->now.view, fly->stream, delta);
}

/* Turns the flight to the next face, after a hit that gave the velocity v2: `local` in (t, b, n).
 */
static void turn_flight(const aspi_roughness *rough, vec v2, vec local, frame *now, passage *fly,
                        aspi_path *path) {
  frame next = frame_of(v2, now->n);
  if (has_direction(&next) && dot(next.along, now->along) < 0)
    path->back = !path->back;
  path->turn = atan2(local.y, local.x);
  *now = next;
  if (!has_direction(now))
    choose_direction(rough, now, fly->stream);
  fly->heading = aspi_heading_of(rough, now);
  fly->now = incidence_at(rough, fly->heading, impact_angle(now), false);
}

/* A hit on a face; false: the particle cannot hit it, or a single hit would send it into the wall.
 */
static bool hit_face(const asp_wall *wall, const asp_particle *particle, const frame *now,
                     const face *on, aspi_stream *stream, vec *spin, vec *local,
                     asp_impact *impact) {
  vec turned = *spin;
  bool deposit;
  if (!aspi_hit_rebound(wall, particle, now, on->m, !wall->isotropic, stream, &turned, local,
                        &deposit) ||
      !(wall->multiple || deposit || local->z > 0))
    return false;
  *spin = turned;
  impact->eroded += eroded_there(wall, particle, now, on->m);
  impact->outcome = deposit ? ASP_DEPOSIT : ASP_REBOUND;
  return true;
}

/* Hit after hit until the particle leaves. `now` is the frame of v1 at first. */
static void bounce_on(const aspi_roughness *rough, vec v1, frame *now, aspi_stream *stream,
                      const aspi_ratios *ratios, asp_impact *impact) {
  const asp_wall *wall = rough->wall;
  const asp_particle *particle = rough->particle;
  passage fly = {
      .rough = rough, .heading = aspi_heading_of(rough, now), .stream = stream, .ratios = ratios};
  fly.now = incidence_at(rough, fly.heading, impact_angle(now), true);
  aspi_path path = {0};
  vec v2 = {0, 0, 0}, spin = load(particle->omega), local;
  bool ends = false, gone = false, stuck = false;
  impact->hits = 0;
  for (int i = 0; i < ASP_HITS_MAX && !ends; i++) {
    double delta;
    bool drawn = next_tilt(wall, &fly, &path, &delta, &gone), first = impact->hits == 0;
    ends = gone;
    if (!drawn)
      continue;
    face on = face_at(wall, &fly.now.slopes, delta, &path, stream);
    if (!hit_face(wall, particle, now, &on, stream, &spin, &local, impact))
      continue;
    impact->hits++;
    if (first) {
      impact->delta_alpha = delta;
      impact->tilt_out = tilt_out(wall, &on);
    }
    v2 = to_lab(now, local);
    stuck = impact->outcome == ASP_DEPOSIT;
    ends = stuck || !wall->multiple || escapes(wall, &fly, local);
    add_ratios(wall, &fly, now, &on, first, stuck ? NULL : &local, ends);
    path.q = on.q;
    if (!ends)
      turn_flight(rough, v2, local, now, &fly, &path);
  }
  if (ends && impact->hits > 0) {
    store(stuck ? v2 : leaving(now, v2), impact->v2);
    store(spin, impact->omega);
    return;
  }
  frame in = gone ? *now : frame_of(v1, now->n); /* gone: it does not even approach */
  impact->capped = !gone;
  bounce_off_mean_wall(wall, particle, &in, stream, impact);
}

static void bounce(const asp_wall *wall, bool on_faces, const asp_particle *particle, vec v,
                   frame *f, aspi_stream *stream, const aspi_ratios *ratios, asp_impact *impact) {
  if (!on_faces) {
    bounce_off_mean_wall(wall, particle, f, stream, impact);
    return;
  }
  aspi_roughness rough = aspi_roughness_of(wall, particle, f->n);
  if (!has_direction(f))
    choose_direction(&rough, f, stream);
  bounce_on(&rough, v, f, stream, ratios, impact);
}

/* The velocity of the touching sphere. */
static vec touching(const asp_particle *particle, vec v) {
  return particle->body ? plus(v, 1, cross(load(particle->omega), load(particle->body->lever))) : v;
}

/* Turns the velocity of the touching sphere into that of the center of mass. */
static void to_center(const asp_particle *particle, asp_impact *impact) {
  if (particle->body)
    store(plus(load(impact->v2), -1, cross(load(impact->omega), load(particle->body->lever))),
          impact->v2);
}

void aspi_impact_at(const asp_wall *wall, bool rough, const asp_particle *particle, vec v, vec n,
                    aspi_stream *stream, const aspi_ratios *ratios, asp_impact *impact) {
  vec u = touching(particle, v);
  frame f = frame_of(u, n);
  impact->capped = false;
  impact->eroded = 0;
  double on_mean = wall->erosion.law && !wall->erosion.tilted
                       ? aspi_hit_erosion(wall, particle, &f, (vec){0, 0, 1})
                       : 0;
  bounce(wall, rough, particle, u, &f, stream, ratios, impact);
  impact->eroded += on_mean;
  to_center(particle, impact);
}

/* A slope s_eff x with the density x exp(-x^2/2), the law of faces met along the wall. */
static double rayleigh(const aspi_slopes_along *slopes, aspi_stream *stream) {
  return slopes->slope * sqrt(-2 * log(aspi_stream_uniform(stream)));
}

/* The frame of a particle whose center of mass, with the velocity v along the wall, has turned down
 * a slope p at the same speed. */
static frame turned_down(const asp_particle *particle, const frame *f, vec v, double p) {
  vec t = scaled(f->along, f->per_length);
  double along = dot(v, t), up = dot(v, f->n), cosine = 1 / sqrt(1 + p * p), sine = p * cosine;
  v = plus(v, along * (cosine - 1) + up * sine, t);
  v = plus(v, up * (cosine - 1) - along * sine, f->n);
  return frame_of(touching(particle, v), f->n);
}

/* True if the trough between two faces is sharper than the sphere: then the path of its center has
 * a kink there. Curvatures in troughs have the density x exp(-x^2/2) over their rms value c, kappa
 * = c d_p/2. On a surface the one across is a third of that on the average, with the variance (8/9)
 * c^2, and the mixed one has c^2/3: moments of Gaussian heights whose autocovariance depends on the
 * distance alone. */
static bool has_kink(const asp_wall *wall, const aspi_slopes_along *slopes, aspi_stream *stream) {
  double along = slopes->kappa * sqrt(-2 * log(aspi_stream_uniform(stream)));
  if (along > 1 || !wall->isotropic)
    return along > 1;
  double across = along / 3 + slopes->kappa_across * sqrt(8) / 3 * aspi_stream_normal(stream);
  double mixed2 = slopes->kappa * slopes->kappa_across / 3, draw = aspi_stream_normal(stream);
  return (1 - along) * (1 - across) < mixed2 * draw * draw;
}

/* The next face of a particle that stays at the wall. */
typedef struct next_face {
  bool kink;       /* the particle comes down to it with the slope `down` */
  double down, up; /* else from a crest of the curvature up bend/length */
  double bend, length;
} next_face;

static next_face gaussian_face(const aspi_roughness *rough, aspi_heading heading, double length,
                               aspi_stream *stream) {
  aspi_slopes_along slopes = aspi_roughness_along(rough, heading);
  next_face next = {
      .up = rayleigh(&slopes, stream), .bend = sqrt(6), .length = length / ASPI_FACE_LENGTH};
  next.kink = has_kink(rough->wall, &slopes, stream);
  if (next.kink)
    next.down = rayleigh(&slopes, stream);
  return next;
}

/* A face of the wall's table; *path: its slope across the way. */
static next_face face_of(const aspi_valley_table *table, aspi_stream *stream, aspi_path *path) {
  const aspi_face *at = &table->face[(size_t)((double)table->faces * aspi_stream_uniform(stream))];
  path->q = at->side;
  return (next_face){!(at->length > 0), -at->down, at->up, ASP_PI, at->length};
}

/* The first-hit law at grazing incidence has smaller slopes than these (aspi_grazing), because
 * those particles come from afar, over the highest summits.
 *
 * In a kink the particle comes to the face down that behind it, and hits it with the sum of both
 * slopes. Otherwise it hits a face only if it has left the wall on the crest before, a sine of
 * steepest slope p and curvature p sqrt(6)/lambda_c (Rice's ratio of both rms values for Gaussian
 * heights): if the press is a share b < 1 of what holds it there. It comes down on the parabola
 * with p sqrt(12) (1 - b)^(3/2) against the wall, to the first order of 1 - b, which is p at b =
 * 0.56; faster ones meet p. */
asp_code asp_wall_impact_grazing(const asp_wall *wall, const asp_particle *particle,
                                 const double v1[3], const double n[3], double press,
                                 const asp_key *key, asp_impact *impact) {
  asp_pair pair;
  asp_wall held;
  *impact = (asp_impact){.hits = 0};
  store(load(v1), impact->v2);
  store(load(particle->omega), impact->omega);
  wall = aspi_wall_met(wall, particle, key, &held);
  if (!wall)
    return ASP_ERANGE;
  asp_particle own = aspi_as_grain(wall, particle, key, &pair);
  particle = &own;
  if (!particle->pair && wall->law->needs_pair)
    return ASP_EARG;
  frame f = frame_of(touching(particle, load(v1)), load(n));
  if (!wall->rough || !has_direction(&f))
    return ASP_OK;
  vec along = plus(load(v1), f.v_n, f.n);
  aspi_stream stream = aspi_stream_begin(key);
  aspi_roughness rough = aspi_roughness_of(wall, particle, f.n);
  aspi_heading heading = aspi_heading_of(&rough, &f);
  aspi_valley_table table = aspi_roughness_valleys(&rough, heading);
  aspi_path path = {0};
  next_face next =
      table.faces
          ? face_of(&table, &stream, &path)
          : gaussian_face(&rough, heading, asp_wall_face_length(wall, particle, v1, n), &stream);
  double p = next.up;
  f.v_n = 0;
  if (next.kink)
    f = turned_down(particle, &f, along, next.down);
  else {
    double loose = 1 - press * next.length / (f.v_t * f.v_t * p * next.bend);
    if (!(loose > 0))
      return ASP_OK;
    p *= fmin(1, sqrt(12) * pow(loose, 1.5));
  }
  aspi_slopes_along slopes = aspi_roughness_along(&rough, heading);
  face on = face_at(wall, &slopes, atan(p), table.faces ? &path : NULL, &stream);
  vec local, spin = load(particle->omega);
  bool deposit;
  if (!aspi_hit_rebound(wall, particle, &f, on.m, !wall->isotropic, &stream, &spin, &local,
                        &deposit) ||
      !(deposit || local.z > 0))
    return ASP_OK;
  *impact = (asp_impact){.delta_alpha = on.delta,
                         .tilt_out = tilt_out(wall, &on),
                         .hits = 1,
                         .outcome = deposit ? ASP_DEPOSIT : ASP_REBOUND,
                         .eroded = eroded_there(wall, particle, &f, on.m)};
  store(deposit ? local : leaving(&f, to_lab(&f, local)), impact->v2);
  store(spin, impact->omega);
  to_center(particle, impact);
  return ASP_OK;
}
