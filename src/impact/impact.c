/* One contact: draw the face, turn the velocity into its frame, let the rebound law act, turn back,
 * and see to it that the particle leaves the wall or stays on it.
 *
 * Everything happens in the frame (t, b, n) of the mean wall: n its normal, t the direction of
 * flight along it, b = n x t. The particle comes with (v_t, 0, -v_n); a face with slopes p =
 * tan(delta_alpha) along t and q along b has the normal (-p, -q, 1)/sqrt(1 + p^2 + q^2), written
 * with the sine and cosine of delta_alpha so that a face of 90 degrees is no special case. Vectors,
 * not angles, so that it stays right beyond a local impact angle of 90 degrees, where the
 * tangential CoR turns negative. */
#include "impact/wall.h"

#include <float.h>
#include <math.h>

/* Below this share of the speed the tangential velocity has no direction. */
#define NO_DIRECTION 1e-12

/* Smith's Lambda is below 1e-13 from here on, and beyond all numbers before. */
#define NU_FREE 5.2
#define NU_LEAST 1e-150

/* Below this share of the energy along the wall, its direction is worked out with care. */
#define NEARLY_NORMAL 1e-4

typedef struct frame {
  double n[3], t[3];
  double v_n, v_t; /* approach and tangential speed, >= 0 */
  bool has_direction;
} frame;

typedef struct face {
  double m[3]; /* its normal in (t, b, n) */
  double delta, q;
} face;

static double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double c[3]) {
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}

/* 1/|n|; a normal that is nearly of unit length needs one step of Newton's method only. */
static double inverse_length(const double n[3]) {
  double square = dot(n, n);
  return fabs(square - 1) < 1e-8 ? 1.5 - 0.5 * square : 1 / sqrt(square);
}

static frame frame_of(const double v[3], const double normal[3]) {
  frame f;
  double scale = inverse_length(normal), along[3], square;
  for (int i = 0; i < 3; i++)
    f.n[i] = normal[i] * scale;
  f.v_n = -dot(v, f.n);
  for (int i = 0; i < 3; i++)
    along[i] = v[i] + f.v_n * f.n[i];
  square = dot(along, along);
  if (square < NEARLY_NORMAL * f.v_n * f.v_n) { /* the rest of the difference is rounding: again */
    double rest = dot(along, f.n);
    for (int i = 0; i < 3; i++)
      along[i] -= rest * f.n[i];
    square = dot(along, along);
  }
  f.v_t = sqrt(square);
  f.has_direction = f.v_t >= NO_DIRECTION * fabs(f.v_n) && f.v_t > 0;
  for (int i = 0; i < 3; i++)
    f.t[i] = f.has_direction ? along[i] / f.v_t : 0;
  return f;
}

/* At normal impact the direction of flight is drawn uniformly around n. */
static void draw_direction(frame *f, asp_stream *stream) {
  double angle = 2 * ASP_PI * asp_stream_uniform(stream), e[3], first[3], second[3];
  int least = fabs(f->n[0]) <= fabs(f->n[1]) ? 0 : 1;
  if (fabs(f->n[2]) < fabs(f->n[least]))
    least = 2;
  for (int i = 0; i < 3; i++)
    e[i] = i == least;
  cross(f->n, e, first);
  double scale = 1 / sqrt(dot(first, first));
  for (int i = 0; i < 3; i++)
    first[i] *= scale;
  cross(f->n, first, second);
  for (int i = 0; i < 3; i++)
    f->t[i] = cos(angle) * first[i] + sin(angle) * second[i];
  f->v_t = 0;
}

/* A particle on its way over a rough wall, from its first hit to its last. */
typedef struct flight {
  frame now;
  asp_view view;
  asp_stream *stream;
  asp_path path;
  double depth;  /* of the particle, see walks_out */
  double lambda; /* of its first approach, < 0 while not known */
} flight;

/* The next face; *gone when the model follows the particle over a profile, and it has left. */
static bool draw_face(const asp_wall *wall, flight *fly, face *out, bool *gone) {
  const asp_spread_model *model = wall->spread;
  bool drawn;
  if (model->follow) {
    drawn = model->follow(&fly->view, fly->stream, &fly->path, &out->delta);
    *gone = !drawn;
  } else {
    if (fly->view.alpha1 < 0 && !model->upward)
      model = wall->upward;
    drawn = asp_spread_draw(model, &fly->view, fly->stream, &out->delta);
    *gone = false;
  }
  double c = cos(out->delta), s = sin(out->delta), side = 0, scale = 1;
  out->q = 0;
  if (wall->isotropic) {
    out->q = fly->view.slope * asp_stream_normal(fly->stream);
    side = out->q * c;
    scale = 1 / sqrt(1 + side * side);
  }
  out->m[0] = -s * scale;
  out->m[1] = -side * scale;
  out->m[2] = c * scale;
  return drawn;
}

static const face mean_face = {{0, 0, 1}, 0, 0};

/* The rebound from one face, in (t, b, n). False where the particle cannot hit it. */
static bool rebound(const asp_wall *wall, const asp_particle *particle, const frame *f,
                    const face *on, asp_stream *stream, double out[3], bool *deposit) {
  double approach = f->v_n * on->m[2] - f->v_t * on->m[0];
  if (!(approach > 0))
    return false;
  double along[3] = {f->v_t + approach * on->m[0], approach * on->m[1],
                     -f->v_n + approach * on->m[2]};
  double speed = sqrt(dot(along, along));
  asp_hit hit = {approach,       speed,         particle->d_p, particle->density,
                 particle->pair, wall->deposit, wall->table,   stream};
  asp_bounce bounce = wall->law->rebound(wall->parameters, &hit);
  *deposit = wall->deposit && !(bounce.v_n2 > 0);
  double kept = speed > 0 ? bounce.v_t2 / speed : 0;
  for (int i = 0; i < 3; i++)
    out[i] = *deposit ? 0 : bounce.v_n2 * on->m[i] + kept * along[i];
  return true;
}

static void to_lab(const frame *f, const double local[3], double v[3]) {
  double b[3];
  cross(f->n, f->t, b);
  for (int i = 0; i < 3; i++)
    v[i] = local[0] * f->t[i] + local[1] * b[i] + local[2] * f->n[i];
}

/* Whether v leaves the wall beyond doubt: whoever works out v.n, with a normal that is off by its
 * last bits, finds it positive. */
static bool clearly_leaves(const double v[3], const double n[3]) {
  double sum = fabs(v[0] * n[0]) + fabs(v[1] * n[1]) + fabs(v[2] * n[2]);
  return dot(v, n) > 4 * DBL_EPSILON * sum;
}

/* A velocity that leaves the mean wall in (t, b, n) may, at the last bits of a grazing one, point
 * into it in the lab frame. Take those bits from the speed along the wall, so that no energy is
 * made. */
static void leave(const frame *f, double v[3]) {
  for (int i = 0; i < 8 && !clearly_leaves(v, f->n); i++) {
    double speed = sqrt(dot(v, v)), step = 4 * (double)(1 << i) * DBL_EPSILON;
    for (int j = 0; j < 3; j++)
      v[j] = (1 - step) * v[j] + step * speed * f->n[j];
  }
}

static void bounce_off_mean_wall(const asp_wall *wall, const asp_particle *particle, const frame *f,
                                 asp_stream *stream, asp_impact *impact) {
  double local[3];
  bool deposit, hit = rebound(wall, particle, f, &mean_face, stream, local, &deposit);
  impact->delta_alpha = impact->tilt_out = 0;
  impact->hits = 1;
  if (!hit) { /* it does not approach, and goes on as it came */
    deposit = false;
    local[0] = f->v_t;
    local[1] = 0;
    local[2] = fmax(-f->v_n, 0);
  }
  to_lab(f, local, impact->v2);
  impact->outcome = deposit ? ASP_DEPOSIT : ASP_REBOUND;
  if (!hit || local[2] > 0)
    leave(f, impact->v2);
}

/* Smith's Lambda of a Gaussian wall for a flight at slope nu sqrt(2) s_eff over the mean wall. */
static double smith(double nu) {
  if (nu > NU_FREE)
    return 0;
  nu = fmax(nu, NU_LEAST);
  return 0.5 * (exp(-nu * nu) / (nu * sqrt(ASP_PI)) - erfc(nu));
}

static double exponential(asp_stream *stream) {
  return -log(asp_stream_uniform(stream));
}

/* Whether a particle that a face has just sent off at the slope `rise` > 0 leaves, or at rise <= 0
 * how deep it gets. Depth is -ln of the share of the wall that is lower than the particle: a flight
 * down adds an exponential number over 1 + Lambda to it, a flight up takes one over Lambda off, and
 * is out when nothing is left (Heitz, Hanika, d'Eon & Dachsbacher 2016, eq. 17 to 21 in this
 * variable). A wall that forgets draws the depth of the first hit again each time, which makes the
 * probability to leave Smith's, (1 + Lambda_1)/(1 + Lambda_1 + Lambda). */
static bool walks_out(const asp_wall *wall, flight *fly, double rise) {
  double scale = 1 / (sqrt(2) * fly->view.slope), lambda = smith(fabs(rise) * scale);
  if (rise > 0 && !(lambda > 0))
    return true;
  if (fly->lambda < 0 || wall->forgets) {
    if (fly->lambda < 0)
      fly->lambda = smith(tan(fly->view.alpha1) * scale);
    fly->depth = exponential(fly->stream) / (1 + fly->lambda);
  }
  double step = exponential(fly->stream);
  if (rise > 0)
    return (fly->depth -= step / lambda) < 0;
  fly->depth += step / (1 + lambda);
  return false;
}

/* Whether the particle leaves the wall with the velocity that a face has given it, in (t, b, n). */
static bool leaves(const asp_wall *wall, flight *fly, const double out[3]) {
  double along = hypot(out[0], out[1]);
  if (!wall->multiple)
    return out[2] > 0;
  if (wall->spread->follow)
    return false;
  if (wall->spread->escape)
    return out[2] > 0 &&
           asp_stream_uniform(fly->stream) < wall->spread->escape(&fly->view, atan2(out[2], along));
  bool steep = along <= NO_DIRECTION * fabs(out[2]);
  return walks_out(wall, fly, steep ? copysign(INFINITY, out[2]) : out[2] / along);
}

/* Takes the velocity in the lab frame as the particle's new flight. */
static void turn(flight *fly, const double v[3]) {
  frame next = frame_of(v, fly->now.n);
  if (next.has_direction && dot(next.t, fly->now.t) < 0)
    fly->path.back = !fly->path.back;
  fly->now = next;
}

static void bounce_off_rough_wall(const asp_wall *wall, const asp_particle *particle,
                                  const frame *first, asp_stream *stream, asp_impact *impact) {
  double slope = asp_surface_slope(wall->surface, particle->d_p);
  double sigma = slope < wall->slope ? atan(slope) : wall->sigma;
  flight fly = {.now = *first,
                .view = {slope, sigma, 0, particle->d_p, wall->data},
                .stream = stream,
                .lambda = -1};
  impact->hits = 0;
  for (int i = 0; i < ASP_HITS_MAX; i++) {
    if (!fly.now.has_direction)
      draw_direction(&fly.now, stream);
    fly.view.alpha1 = atan2(fly.now.v_n, fly.now.v_t);
    face on;
    double local[3];
    bool deposit, gone;
    if (!draw_face(wall, &fly, &on, &gone)) {
      if (!gone)
        continue;
      if (impact->hits == 0) /* it does not even approach */
        bounce_off_mean_wall(wall, particle, first, stream, impact);
      else
        leave(first, impact->v2);
      return;
    }
    if (!rebound(wall, particle, &fly.now, &on, stream, local, &deposit) ||
        !(deposit || local[2] > 0 || wall->multiple))
      continue;
    if (impact->hits++ == 0) {
      impact->delta_alpha = on.delta;
      impact->tilt_out = wall->isotropic ? atan(on.q) : 0;
    }
    to_lab(&fly.now, local, impact->v2);
    impact->outcome = deposit ? ASP_DEPOSIT : ASP_REBOUND;
    if (deposit)
      return;
    if (leaves(wall, &fly, local)) {
      leave(&fly.now, impact->v2);
      return;
    }
    turn(&fly, impact->v2);
  }
  impact->capped = true;
  bounce_off_mean_wall(wall, particle, first, stream, impact);
}

void asp_wall_impact(const asp_wall *wall, const asp_particle *particle, const double v1[3],
                     const double n[3], asp_key key, asp_impact *impact) {
  frame f = frame_of(v1, n);
  impact->capped = false;
  asp_stream stream = asp_stream_create(key);
  if (wall->rough)
    bounce_off_rough_wall(wall, particle, &f, &stream, impact);
  else
    bounce_off_mean_wall(wall, particle, &f, &stream, impact);
}

/* a/b, or the largest ratio that is told where b vanishes against a. */
static double ratio(double a, double b) {
  if (b > a / ASP_RATIO_MOST)
    return a / b;
  return a > 0 ? ASP_RATIO_MOST : 0;
}

asp_coefficients asp_impact_coefficients(const double v1[3], const double n[3],
                                         const asp_impact *impact) {
  frame f = frame_of(v1, n);
  const double *v2 = impact->v2;
  double n2 = dot(v2, f.n), along = dot(v2, f.t);
  asp_coefficients c = {.v1 = sqrt(dot(v1, v1)),
                        .alpha1 = atan2(fmax(f.v_n, 0), f.v_t),
                        .v2 = sqrt(dot(v2, v2)),
                        .cor_t_defined = f.has_direction};
  if (impact->outcome == ASP_DEPOSIT)
    return c;
  if (!f.has_direction)
    along = sqrt(fmax(0, c.v2 * c.v2 - n2 * n2));
  c.alpha2 = atan2(n2, along);
  c.cor_v = ratio(c.v2, c.v1);
  c.cor_alpha = ratio(c.alpha2, c.alpha1);
  c.cor_n = ratio(n2, f.v_n);
  c.cor_t = f.has_direction ? along / f.v_t : 0;
  return c;
}
