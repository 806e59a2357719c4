/* The slopes of a Gaussian wall as a particle that comes in at alpha1 sees them: each face counts
 * with the width that it shows to the particle, which is shadow and flux together. With x = p/s_eff
 * and a = tan(alpha1)/s_eff the density is phi(x) (x + a) / Z over x > -a, Z = phi(a) + a Phi(a).
 * Computer graphics knows it as the distribution of visible normals of a Beckmann surface. It takes
 * height and slope at a hit as independent, which they are not quite. A particle that flies up
 * after an earlier hit (a < 0) meets the same law.
 *
 * The quantile is the quick one of visible.h for all but one draw in 256; those, and particles that
 * fly up, go through the safeguarded inversion. There the integral from the end of the support is a
 * series where its closed form would be a difference of nearly equal numbers. */
#include "spread/visible.h"
#include "spread/invert.h"
#include "spread/models.h"

#include <float.h>

/* Beyond this a particle that flies up meets practically nothing, and the law there is taken for
 * that of the limit, a gamma law in a (x + a). */
#define A_LEAST (-1e8)

/* Rounded from the law inverted by bisection. */
const float asp_visible_grid[ASP_VISIBLE_ROWS][ASP_VISIBLE_COLUMNS] = {
    {0.0885f, 0.1662f, 0.2682f, 0.3945f, 0.5452f, 0.7201f, 0.9193f, 1.1428f, 1.3906f,
     1.6627f, 1.9591f, 2.2798f, 2.6249f, 2.9942f, 3.3878f, 3.8057f, 4.2479f, 4.7144f,
     5.2052f, 5.7203f, 6.2597f, 6.8234f, 7.4114f, 8.0237f, 8.6603f},
    {-0.0374f, 0.0464f, 0.1555f, 0.2897f, 0.4484f, 0.6315f, 0.8385f, 1.0694f, 1.3241f,
     1.6025f,  1.9045f, 2.2303f, 2.5799f, 2.9532f, 3.3504f, 3.7715f, 4.2166f, 4.6856f,
     5.1787f,  5.6958f, 6.2370f, 6.8024f, 7.3918f, 8.0055f, 8.6433f},
    {-0.1799f, -0.0886f, 0.0295f, 0.1733f, 0.3419f, 0.5345f, 0.7507f, 0.9900f, 1.2524f,
     1.5377f,  1.8460f,  2.1773f, 2.5318f, 2.9095f, 3.3106f, 3.7351f, 4.1832f, 4.6550f,
     5.1505f,  5.6698f,  6.2129f, 6.7800f, 7.3710f, 7.9861f, 8.6252f},
    {-0.3426f, -0.2412f, -0.1116f, 0.0442f, 0.2247f, 0.4286f, 0.6553f, 0.9043f, 1.1753f,
     1.4683f,  1.7834f,  2.1208f,  2.4806f, 2.8630f, 3.2682f, 3.6964f, 4.1478f, 4.6224f,
     5.1205f,  5.6421f,  6.1873f,  6.7562f, 7.3489f, 7.9655f, 8.6059f},
    {-0.5292f, -0.4142f, -0.2697f, -0.0987f, 0.0963f, 0.3137f, 0.5526f, 0.8124f, 1.0931f,
     1.3945f,  1.7171f,  2.0609f,  2.4264f,  2.8139f, 3.2235f, 3.6556f, 4.1104f, 4.5881f,
     5.0889f,  5.6129f,  6.1602f,  6.7311f,  7.3256f, 7.9437f, 8.5856f},
    {-0.7443f, -0.6103f, -0.4459f, -0.2557f, -0.0429f, 0.1904f, 0.4432f, 0.7152f, 1.0064f,
     1.3170f,  1.6475f,  1.9983f,  2.3698f,  2.7625f,  3.1767f, 3.6129f, 4.0712f, 4.5521f,
     5.0557f,  5.5822f,  6.1319f,  6.7048f,  7.3011f,  7.9208f, 8.5642f},
    {-0.9922f, -0.8310f, -0.6398f, -0.4252f, -0.1911f, 0.0605f, 0.3290f, 0.6143f, 0.9167f,
     1.2370f,  1.5758f,  1.9337f,  2.3114f,  2.7095f,  3.1284f, 3.5688f, 4.0308f, 4.5149f,
     5.0214f,  5.5505f,  6.1025f,  6.6775f,  7.2756f,  7.8971f, 8.5420f},
    {-1.2748f, -1.0738f, -0.8470f, -0.6024f, -0.3437f, -0.0718f, 0.2133f, 0.5124f, 0.8264f,
     1.1564f,  1.5035f,  1.8686f,  2.2525f,  2.6559f,  3.0796f,  3.5241f, 3.9898f, 4.4771f,
     4.9865f,  5.5182f,  6.0725f,  6.6495f,  7.2496f,  7.8728f,  8.5192f},
    {-1.5852f, -1.3275f, -1.0563f, -0.7777f, -0.4928f, -0.2004f, 0.1012f, 0.4136f, 0.7387f,
     1.0781f,  1.4330f,  1.8049f,  2.1946f,  2.6032f,  3.0313f,  3.4797f, 3.9490f, 4.4394f,
     4.9516f,  5.4858f,  6.0424f,  6.6215f,  7.2233f,  7.8482f,  8.4962f},
    {-1.8950f, -1.5671f, -1.2488f, -0.9374f, -0.6283f, -0.3176f, -0.0016f, 0.3225f, 0.6573f,
     1.0048f,  1.3667f,  1.7445f,  2.1395f,  2.5527f,  2.9849f,  3.4369f,  3.9093f, 4.4027f,
     4.9175f,  5.4540f,  6.0127f,  6.5937f,  7.1973f,  7.8238f,  8.4732f},
    {-2.1528f, -1.7622f, -1.4063f, -1.0696f, -0.7425f, -0.4179f, -0.0909f, 0.2423f, 0.5846f,
     0.9386f,  1.3062f,  1.6890f,  2.0883f,  2.5053f,  2.9410f,  3.3962f,  3.8714f, 4.3673f,
     4.8844f,  5.4231f,  5.9837f,  6.5665f,  7.1718f,  7.7997f,  8.4505f},
    {-2.3293f, -1.9024f, -1.5245f, -1.1727f, -0.8341f, -0.5005f, -0.1661f, 0.1734f, 0.5212f,
     0.8800f,  1.2518f,  1.6384f,  2.0412f,  2.4614f,  2.8999f,  3.3576f,  3.8353f, 4.3334f,
     4.8525f,  5.3931f,  5.9554f,  6.5398f,  7.1465f,  7.7758f,  8.4279f},
    {-2.4441f, -2.0010f, -1.6122f, -1.2523f, -0.9072f, -0.5682f, -0.2291f, 0.1145f, 0.4660f,
     0.8281f,  1.2030f,  1.5924f,  1.9978f,  2.4204f,  2.8612f,  3.3210f,  3.8006f, 4.3006f,
     4.8214f,  5.3636f,  5.9274f,  6.5132f,  7.1212f,  7.7518f,  8.4050f},
    {-2.5232f, -2.0730f, -1.6790f, -1.3149f, -0.9663f, -0.6242f, -0.2823f, 0.0638f, 0.4177f,
     0.7821f,  1.1590f,  1.5504f,  1.9577f,  2.3821f,  2.8246f,  3.2860f,  3.7672f, 4.2686f,
     4.7908f,  5.3343f,  5.8994f,  6.4864f,  7.0956f,  7.7272f,  8.3815f},
    {-2.5810f, -2.1278f, -1.7313f, -1.3652f, -1.0148f, -0.6710f, -0.3275f, 0.0201f, 0.3753f,
     0.7410f,  1.1193f,  1.5119f,  1.9205f,  2.3460f,  2.7897f,  3.2523f,  3.7346f, 4.2371f,
     4.7604f,  5.3049f,  5.8709f,  6.4589f,  7.0690f,  7.7016f,  8.3567f},
    {-2.6252f, -2.1707f, -1.7733f, -1.4063f, -1.0550f, -0.7105f, -0.3663f, -0.0180f, 0.3380f,
     0.7043f,  1.0833f,  1.4766f,  1.8858f,  2.3121f,  2.7564f,  3.2197f,  3.7027f,  4.2058f,
     4.7298f,  5.2750f,  5.8417f,  6.4303f,  7.0411f,  7.6743f,  8.3301f},
    {-2.6601f, -2.2053f, -1.8076f, -1.4404f, -1.0890f, -0.7442f, -0.3999f, -0.0514f, 0.3048f,
     0.6714f,  1.0505f,  1.4441f,  1.8535f,  2.2800f,  2.7245f,  3.1880f,  3.6712f,  4.1746f,
     4.6989f,  5.2443f,  5.8113f,  6.4001f,  7.0112f,  7.6446f,  8.3007f},
};

typedef struct law {
  double a;
  double z;       /* the norm; over phi(a) where a < 0 */
  double density; /* phi(a) */
} law;

/* 1 - t M(t) for t > 0, M = Q/phi: the norm for a = -t over phi(t), about 1/t^2 for large t. There
 * by the asymptotic series 1/t^2 - 3/t^4 + 15/t^6 - ... */
static double mills_gap(double t) {
  if (t < 12)
    return 1 - t * asp_gauss_below(-t) / asp_gauss_density(t);
  double square = t * t, term = 1 / square, sum = 0;
  for (int k = 3; k < 29; k += 2) {
    sum += term;
    term *= -k / square;
  }
  return sum;
}

static law law_at(const asp_view *view) {
  double a = tan(view->alpha1) / view->slope;
  a = fmin(fmax(a, A_LEAST), ASP_VISIBLE_A_MOST);
  double density = asp_gauss_density(a);
  double z = a < 0 ? mills_gap(-a) : density + a * asp_gauss_below(a);
  return (law){a, z, density};
}

/* The integral of t exp(a t - t^2/2) from 0 to a small y, by its series. */
static double near_end(double a, double y) {
  double previous = 0, c = 1, power = y * y, sum = 0;
  for (int n = 0; n < 24; n++) {
    sum += c * power / (n + 2);
    double next = (a * c - previous) / (n + 1);
    previous = c;
    c = next;
    power *= y;
  }
  return sum;
}

static asp_point down_at(const void *of, double x) {
  const law *w = of;
  double a = w->a, y = x + a, phi = asp_gauss_density(x);
  asp_point p = {.density = phi * y / w->z};
  p.above = (phi + a * asp_gauss_below(-x)) / w->z;
  if (y * (1 + a) < 0.5)
    p.below = w->density * near_end(a, y) / w->z;
  else
    p.below = fmax(0, (a * (asp_gauss_below(x) - asp_gauss_below(-a)) + w->density - phi) / w->z);
  return p;
}

/* For a < 0, counted from the end of the support: y = x + a. */
static asp_point up_at(const void *of, double y) {
  const law *w = of;
  double t = -w->a, x = y + t, decay = exp(-y * (t + 0.5 * y));
  asp_point p = {.density = decay * y / w->z};
  p.above = decay * (y + t * mills_gap(x)) / x / w->z;
  p.below = y * (1 + t) < 0.5 ? near_end(w->a, y) / w->z : 1 - p.above;
  return p;
}

static asp_point at(const law *w, double x) {
  return w->a < 0 ? up_at(w, x + w->a) : down_at(w, x);
}

/* The start is exact at the end of the support, and far from it for a large a. */
static double down_quantile(const law *w, double u) {
  double far = gsl_cdf_ugaussian_Pinv(u), most = sqrt(-2 * log1p(-u)) + 1;
  double end = w->density > DBL_MIN ? sqrt(2 * u * w->z / w->density) : INFINITY;
  return asp_invert(down_at, w, -w->a, most, fmax(far, fmin(end, 1) - w->a), u);
}

/* The start lies between the laws for a = 0 (Rayleigh) and a large negative one (gamma). */
static double up_quantile(const law *w, double u) {
  double r2 = -2 * log1p(-u), t = -w->a, length = 1 / (sqrt(t * t + r2) + t);
  return t + asp_invert(up_at, w, 0, (r2 + 16) * length, r2 * length * (1 + t / (1 + t)), u);
}

static double density(const asp_view *view, double delta) {
  law w = law_at(view);
  double p = tan(delta), y = p / view->slope + w.a;
  if (!(y > 0) || delta >= ASP_DELTA_MOST)
    return 0;
  return at(&w, p / view->slope).density * (1 + p * p) / view->slope;
}

static double distribution(const asp_view *view, double delta) {
  law w = law_at(view);
  double x = tan(delta) / view->slope;
  if (delta <= -ASP_DELTA_MOST || !(x > -w.a))
    return 0;
  return delta >= ASP_DELTA_MOST ? 1 : at(&w, x).below;
}

static double quantile(const asp_view *view, double u) {
  if (view->sigma < ASP_SIGMA_ZERO)
    return 0;
  double a = tan(view->alpha1) / view->slope;
  if (u >= ASP_VISIBLE_U_LEAST && a >= 0)
    return atan(asp_visible_quick(a, u) * view->slope);
  law w = law_at(view);
  double x = w.a < 0 ? up_quantile(&w, u) : down_quantile(&w, u);
  return fmax(atan(x * view->slope), -view->alpha1);
}

const asp_spread_model asp_spread_visible = {
    .name = "visible",
    .summary = "slopes of a Gaussian wall as the particle sees them: shadow and flux exactly",
    .source = "derived for this project; Heitz & d'Eon 2014 (visible normals) has the same law",
    .upward = true,
    .density = density,
    .distribution = distribution,
    .quantile = quantile,
    .quantile_n = asp_visible_quantile_n,
};
