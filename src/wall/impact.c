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
#include "wall/hit.h"
#include "wall/impact.h"
#include "wall/roughness.h"

#include <math.h>
#include <string.h>

/* Smith's Lambda is under 1e-13 for nu above NU_FREE, and overflows for nu below NU_LEAST. */
#define NU_FREE 5.2
#define NU_LEAST 1e-150

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

/* Local roughness at this incidence: the input of the spread models, and the slopes. */
typedef struct incidence {
  aspi_spread_input input;
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
  out.input = (aspi_spread_input){.slope = slope,
                                  .sigma = atan(slope),
                                  .alpha1 = alpha1,
                                  .d_p = rough->particle->d_p,
                                  .data = wall->data,
                                  .kappa = out.slopes.kappa,
                                  .phi_r = out.slopes.phi_r,
                                  .has_azimuth = aspi_roughness_has_lay(rough)};
  if (out.input.has_azimuth)
    out.input.azimuth = -atan2(heading.sine, heading.cosine);
  return out;
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
  impact->eroded = aspi_hit_eroded(wall, particle, f, (vec){0, 0, 1});
  if (!hit) { /* it does not approach the face and keeps its velocity */
    deposit = false;
    local = (vec){f->v_t, 0, fmax(-f->v_n, 0)};
  }
  vec v2 = to_lab(f, local);
  impact->outcome = deposit ? ASP_DEPOSIT : ASP_REBOUND;
  store(!hit || local.z > 0 ? aspi_hit_leaving(f, v2) : v2, impact->v2);
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
    fly->depth /= 1 + smith(tan(fly->now.input.alpha1) / (sqrt(2) * fly->now.slopes.slope));
  fly->begun = true;
  fly->before = fly->depth;
  fly->step = rise > 0 ? step / lambda : step / (1 + lambda);
  fly->depth += rise > 0 ? -fly->step : fly->step;
  return fly->depth < 0;
}

/* Log density of a face that is hit. A face that turns away from the particle is drawn again, so
 * the density is divided by the share of the others; most models have none of these. */
static double log_face(const asp_wall *wall, const incidence *at, const aspi_tilt *on) {
  const asp_spread_model *model =
      at->input.alpha1 < 0 && !wall->spread->covers_rising ? wall->rising : wall->spread;
  double tilt = log(model->density(&at->input, on->delta)) -
                log1p(-model->distribution(&at->input, -at->input.alpha1));
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
  double fall = first ? 1 + smith(tan(at->input.alpha1) / (sqrt(2) * at->slopes.slope)) : 0;
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
static void add_ratios(const asp_wall *wall, const passage *fly, const frame *now,
                       const aspi_tilt *on, bool first, const vec *out, bool escaped) {
  const aspi_ratios *ratios = fly->ratios;
  for (size_t k = 0; ratios && k < ratios->n; k++) {
    aspi_roughness rough = aspi_roughness_of(ratios->walls[k], fly->rough->particle, now->n);
    incidence at = incidence_at(&rough, fly->heading, fly->now.input.alpha1, first);
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
    bool drawn = wall->follow(&fly->now.input, fly->stream, path, delta);
    *gone = !drawn;
    return drawn;
  }
  bool borrows = fly->now.input.alpha1 < 0 && !model->covers_rising;
  return aspi_spread_draw(borrows ? wall->rising : model, &fly->now.input, fly->stream, delta);
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
                     const aspi_tilt *on, aspi_stream *stream, vec *spin, vec *local,
                     asp_impact *impact) {
  vec turned = *spin;
  bool deposit;
  if (!aspi_hit_rebound(wall, particle, now, on->m, !wall->isotropic, stream, &turned, local,
                        &deposit) ||
      !(wall->multiple || deposit || local->z > 0))
    return false;
  *spin = turned;
  impact->eroded += aspi_hit_eroded(wall, particle, now, on->m);
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
    aspi_tilt on = aspi_tilt_at(wall, &fly.now.slopes, delta, &path, stream);
    if (!hit_face(wall, particle, now, &on, stream, &spin, &local, impact))
      continue;
    impact->hits++;
    if (first) {
      impact->delta_alpha = delta;
      impact->tilt_out = atan(on.q);
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
    store(stuck ? v2 : aspi_hit_leaving(now, v2), impact->v2);
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

void aspi_impact_at(const asp_wall *wall, bool rough, const asp_particle *particle, vec v, vec n,
                    aspi_stream *stream, const aspi_ratios *ratios, asp_impact *impact) {
  vec u = aspi_touching(particle, v);
  frame f = frame_of(u, n);
  impact->capped = false;
  impact->eroded = 0;
  double on_mean = wall->erosion.law && !wall->erosion.tilted
                       ? aspi_hit_erosion(wall, particle, &f, (vec){0, 0, 1})
                       : 0;
  bounce(wall, rough, particle, u, &f, stream, ratios, impact);
  impact->eroded += on_mean;
  aspi_to_center(particle, impact);
}
