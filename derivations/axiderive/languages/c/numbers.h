/* Plain C99, without allocation; link with -lm. */
#include <math.h>

/* what was found for the last parameters stays, in each thread; found anew where a compiler has no word for that */
#if defined(__GNUC__)
#define KEPT __extension__ static __thread
#elif defined(_MSC_VER)
#define KEPT static __declspec(thread)
#else
#define KEPT
#endif

/* as NumPy has them: what is no number stays none */
static inline double minimum(double x, double y) { return x < y || x != x ? x : y; }
static inline double maximum(double x, double y) { return x > y || x != x ? x : y; }
/* as Python has them */
static inline double lower(double x, double y) { return y < x ? y : x; }
static inline double higher(double x, double y) { return y > x ? y : x; }

/* a number as a share, from a half on and below one, times a power of two */
static inline double share_of(double x)
{
  int power;
  return frexp(x, &power);
}
static inline int power_of(double x)
{
  int power;
  (void)frexp(x, &power);
  return power;
}

/* the number in the middle of all between two positive ones */
static inline double halfway(double low, double high)
{
  union { double number; long long bits; } first, second;
  first.number = low;
  second.number = high;
  first.bits += (second.bits - first.bits) / 2;
  return first.number;
}

/* whole waves within a reach, and radii around them in units of their length: decades, sixteen in each wave, decades */
static inline int waves_within(double reach)
{
  return isfinite(reach) && reach > 4.0 ? (int)(reach < 4096.0 ? reach : 4096.0) : 4;
}
static inline double radius_of_waves(int place, int waves)
{
  if (place < 15)
    return pow(10.0, 10.0 * place - 150.0);
  return place < 16 * waves + 15 ? (place - 14) / 16.0 : (waves + 1.0) * pow(10.0, 10.0 * (place - 16 * waves - 15));
}

/* a sum that carries what rounding loses; what is infinite or no number stays that */
struct sum {
  double high, low;
};

static inline void sum_add(struct sum *sum, double x)
{
  double high = sum->high + x, part = high - sum->high;
  sum->low += (sum->high - (high - part)) + (x - part);
  sum->high = high;
}

static inline double sum_of(const struct sum *sum)
{
  return isfinite(sum->high) ? sum->high + sum->low : sum->high;
}

/* nodes and weights on (0, 1), in equal panels; the tables hold the lower half */
struct pairs {
  const double (*half)[2];
  int count, panels;
  const double *weights;
};

/* what is no number at the end is none in one panel too */
static inline int panels_of(double length)
{
  return length < 4096.0 ? (int)ceil(length) : isfinite(length) ? 4096 : 1;
}

static inline struct pairs pairs_of(const double (*half)[2], int count, int panels)
{
  struct pairs own = {0, 0, 0, 0};
  own.half = half;
  own.count = count;
  own.panels = panels;
  return own;
}

static inline double node_of(const struct pairs *pairs, int place, double *weight)
{
  int one = pairs->panels == 1, within = one ? place : place % pairs->count, start = one ? 0 : place / pairs->count;
  int lower = within < pairs->count / 2;
  const double *own = pairs->half[lower ? within : pairs->count - 1 - within];
  /* a division takes longer than most of what is summed */
  if (one) {
    *weight = pairs->weights ? pairs->weights[place] : own[1];
    return lower ? own[0] : 1.0 - own[0];
  }
  *weight = own[1] / pairs->panels;
  return (start + (lower ? own[0] : 1.0 - own[0])) / pairs->panels;
}

/* the same for what has a power of the place as a weight, whose moments are products of rationals: the smooth factor
   is a sum of Legendre's polynomials; `beyond` the value at zero the weights are those over the place */
struct products {
  double power, weights[64];
  int count, beyond;
};

static inline struct pairs products_of(const double (*half)[2], int count, double power, int beyond,
                                       struct products *kept)
{
  struct pairs own = pairs_of(half, count, 1);
  double last[32], now[32], even[32], odd[32], moment = 1.0 / (1.0 + power), *weights = kept->weights;
  int place, order;
  own.weights = weights;
  if (kept->count == count && kept->power == power && kept->beyond == beyond)
    return own;
  kept->count = count;
  kept->power = power;
  kept->beyond = beyond;
  for (place = 0; place < count / 2; place++) {
    last[place] = 1.0;
    now[place] = 2.0 * half[place][0] - 1.0;
    even[place] = moment;
    odd[place] = 0.0;
  }
  for (order = 1; order < count; order++) {
    double up = (2.0 * order + 1.0) / (order + 1.0), down = order / (order + 1.0), share;
    double *sum = order % 2 ? odd : even;
    moment = moment * (power + (1.0 - order)) / (power + (1.0 + order));
    share = (2.0 * order + 1.0) * moment;
    for (place = 0; place < count / 2; place++) {
      double next = up * (2.0 * half[place][0] - 1.0) * now[place] - down * last[place];
      sum[place] += share * now[place];
      last[place] = now[place];
      now[place] = next;
    }
  }
  for (place = 0; place < count / 2; place++) {
    double node = half[place][0], weight = half[place][1];
    weights[place] = weight * (even[place] + odd[place]) / (beyond ? node : 1.0);
    weights[count - 1 - place] = weight * (even[place] - odd[place]) / (beyond ? 1.0 - node : 1.0);
  }
  return own;
}
