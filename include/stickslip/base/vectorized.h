#ifndef stickslip_base_vectorized_h
#define stickslip_base_vectorized_h

#include <cstring>

/**
 * A function that is marked with it is compiled twice, the second time for
 * processors with AVX2 and fused multiplication and addition, and the loader
 * takes the one that fits. Not with sanitizers, which the loader would call
 * before they are ready.
 */
#if defined(__x86_64__) && !defined(__clang__) && __GNUC__ >= 12 && \
  !defined(__SANITIZE_ADDRESS__)
#  define STICKSLIP_VECTORIZED \
    __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#  define STICKSLIP_VECTORIZED
#endif

namespace stickslip
{
  /**
   * Four numbers that are treated at a time. Functions of these have to be
   * inline in those that are STICKSLIP_VECTORIZED.
   */
  struct FourLanes
  {
    using Lanes = double __attribute__((vector_size(32)));

    [[gnu::always_inline]] static Lanes
    load(const double *const x)
    {
      Lanes lanes;
      std::memcpy(&lanes, x, sizeof(lanes));
      return lanes;
    }

    [[gnu::always_inline]] static Lanes
    load(const float *const x)
    {
      using Floats = float __attribute__((vector_size(16)));
      Floats floats;
      std::memcpy(&floats, x, sizeof(floats));
      return __builtin_convertvector(floats, Lanes);
    }

    [[gnu::always_inline]] static void
    store(double *const x, const Lanes &lanes)
    {
      std::memcpy(x, &lanes, sizeof(lanes));
    }

    [[gnu::always_inline]] static double
    sum(const Lanes &lanes)
    {
      return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
    }
  };
} // namespace stickslip

#endif
