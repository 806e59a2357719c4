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

static bool draw_face(const asp_wall *wall, const asp_view *view, asp_stream *stream, face *out) {
  bool drawn = asp_spread_draw(wall->spread, view, stream, &out->delta);
  double c = cos(out->delta), s = sin(out->delta);
  out->q = wall->isotropic ? view->slope * asp_stream_normal(stream) : 0;
  double side = out->q * c, scale = 1 / sqrt(1 + side * side);
  out->m[0] = -s * scale;
  out->m[1] = -side * scale;
  out->m[2] = c * scale;
  return drawn;
}

static const face mean_face = {{0, 0, 1}, 0, 0};

/* The rebound from one face, in (t, b, n). False where the particle cannot hit it. */
static bool rebound(const asp_wall *wall, const asp_particle *particle, const frame *f,
                    const face *on, double out[3], bool *deposit) {
  double approach = f->v_n * on->m[2] - f->v_t * on->m[0];
  if (!(approach > 0))
    return false;
  double along[3] = {f->v_t + approach * on->m[0], approach * on->m[1],
                     -f->v_n + approach * on->m[2]};
  double speed = sqrt(dot(along, along));
  asp_hit hit = {approach, speed, particle->d_p, particle->density, particle->pair, wall->deposit};
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

/* A velocity that leaves the mean wall in (t, b, n) may, at the last bits of a grazing one, point
 * into it in the lab frame. Take those bits from the speed along the wall, so that no energy is
 * made. */
static void leave(const frame *f, double v[3]) {
  for (int i = 0; i < 8 && !(dot(v, f->n) > 0); i++) {
    double speed = sqrt(dot(v, v)), step = 4 * (double)(1 << i) * DBL_EPSILON;
    for (int j = 0; j < 3; j++)
      v[j] = (1 - step) * v[j] + step * speed * f->n[j];
  }
}

static void bounce_off_mean_wall(const asp_wall *wall, const asp_particle *particle, const frame *f,
                                 asp_impact *impact) {
  double local[3];
  bool deposit;
  impact->delta_alpha = impact->tilt_out = 0;
  impact->hits = 1;
  if (!rebound(wall, particle, f, &mean_face, local, &deposit))
    for (int i = 0; i < 3; i++)
      local[i] = deposit = 0;
  to_lab(f, local, impact->v2);
  impact->outcome = deposit ? ASP_DEPOSIT : ASP_REBOUND;
  if (local[2] > 0)
    leave(f, impact->v2);
}

static void bounce_off_rough_wall(const asp_wall *wall, const asp_particle *particle, frame f,
                                  asp_stream *stream, asp_impact *impact) {
  double slope = asp_surface_slope(wall->surface, particle->d_p);
  asp_view view = {slope, atan(slope), 0, particle->d_p, NULL};
  frame first = f;
  impact->hits = 1;
  for (int i = 0; i < ASP_HITS_MAX; i++) {
    if (!f.has_direction)
      draw_direction(&f, stream);
    view.alpha1 = atan2(fmax(f.v_n, 0), f.v_t);
    face on;
    double local[3];
    bool deposit;
    if (!draw_face(wall, &view, stream, &on) || !rebound(wall, particle, &f, &on, local, &deposit))
      continue;
    if (deposit || local[2] > 0 || wall->multiple) {
      if (impact->hits == 1) {
        impact->delta_alpha = on.delta;
        impact->tilt_out = atan(on.q);
      }
      to_lab(&f, local, impact->v2);
      impact->outcome = deposit ? ASP_DEPOSIT : ASP_REBOUND;
      if (deposit)
        return;
      if (local[2] > 0) {
        leave(&f, impact->v2);
        return;
      }
      impact->hits++;
      f = frame_of(impact->v2, first.n);
    }
  }
  impact->capped = true;
  bounce_off_mean_wall(wall, particle, &first, impact);
}

void asp_wall_impact(const asp_wall *wall, const asp_particle *particle, const double v1[3],
                     const double n[3], asp_key key, asp_impact *impact) {
  frame f = frame_of(v1, n);
  impact->capped = false;
  if (wall->rough) {
    asp_stream stream = asp_stream_create(key);
    bounce_off_rough_wall(wall, particle, f, &stream, impact);
  } else {
    bounce_off_mean_wall(wall, particle, &f, impact);
  }
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
  c.cor_v = c.v2 / c.v1;
  c.cor_alpha = c.alpha2 / c.alpha1;
  c.cor_n = n2 / f.v_n;
  c.cor_t = f.has_direction ? along / f.v_t : 0;
  return c;
}
