/* Plain C99, without memory of its own; link with -lm. */
#include <math.h>

/* as NumPy has them: what is no number stays none */
static inline double minimum(double x, double y) { return x < y || x != x ? x : y; }
static inline double maximum(double x, double y) { return x > y || x != x ? x : y; }
/* as Python has them */
static inline double lower(double x, double y) { return y < x ? y : x; }
static inline double higher(double x, double y) { return y > x ? y : x; }

/* a sum that is exact before it is rounded: parts that do not overlap, the smallest first */
struct sum {
  int count;
  double part[64];
};

static inline void sum_add(struct sum *sum, double x)
{
  int place, kept = 0;
  for (place = 0; place < sum->count; place++) {
    double y = sum->part[place], high, low;
    if (fabs(x) < fabs(y)) {
      double other = x;
      x = y;
      y = other;
    }
    high = x + y;
    low = y - (high - x);
    if (low != 0.0)
      sum->part[kept++] = low;
    x = high;
  }
  sum->part[kept] = x;
  sum->count = kept + 1;
}

static inline double sum_of(const struct sum *sum)
{
  int place = sum->count;
  double high = 0.0, low = 0.0;
  while (place > 0) {
    double x = high, y = sum->part[--place];
    high = x + y;
    low = y - (high - x);
    if (low != 0.0)
      break;
  }
  /* half way between two numbers the next part decides */
  if (place > 0 && ((low < 0.0 && sum->part[place - 1] < 0.0) || (low > 0.0 && sum->part[place - 1] > 0.0))) {
    double twice = 2.0 * low, next = high + twice;
    if (twice == next - high)
      high = next;
  }
  return high;
}

/* nodes and weights on (0, 1), in equal panels; the tables hold the lower half */
struct pairs {
  const double (*half)[2];
  int count, panels;
};

static inline int panels_of(double length) { return length < 4096.0 ? (int)ceil(length) : 4096; }

static inline double node_of(const struct pairs *pairs, int place, double *weight)
{
  int within = place % pairs->count, start = place / pairs->count;
  int lower = within < pairs->count / 2;
  const double *own = pairs->half[lower ? within : pairs->count - 1 - within];
  *weight = own[1] / pairs->panels;
  return (start + (lower ? own[0] : 1.0 - own[0])) / pairs->panels;
}
