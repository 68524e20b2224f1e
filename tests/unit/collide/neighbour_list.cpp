// The neighbour list beside brute force, and when it must be made anew.
#include <algorithm>
#include <vector>

#include "engine/collide/neighbour_list.h"
#include "tests/catch.h"

using namespace ballpark::BALLPARK_PRECISION;
using ballpark::Workers;

namespace {

struct Cloud {
  VectorColumn position;
  std::vector<Real> radius, allowance;
};

Cloud cloud(std::size_t count) {
  Cloud made;
  made.position.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto uniform = [&](std::uint64_t axis) {
      return static_cast<Real>((i * (axis * 7919 + 31) * 2654435761ULL) % 1000003) / Real(1000003);
    };
    made.position.put(i, {uniform(1), uniform(2), uniform(3)});
    made.radius.push_back(Real(0.02) + Real(0.02) * uniform(4));
    made.allowance.push_back(Real(0.01) * uniform(5));
  }
  return made;
}

}  // namespace

TEST_CASE("Neighbour list: every pair within both reaches, once, in order, from both sides", "[collide]") {
  Workers workers(2);
  for (const Real length : {Real(0), Real(1)}) {
    const Period period{{length, length, length}};
    for (const std::size_t copies : {1, 3}) {
      const std::size_t of_copy = 300;
      const Cloud made = cloud(copies * of_copy);
      NeighbourList list;
      list.build(made.position, made.radius, made.allowance, of_copy, period, workers);
      std::size_t pairs = 0;
      for (std::size_t a = 0; a < copies * of_copy; ++a) {
        std::vector<std::uint32_t> expected, lower;
        for (std::size_t b = 0; b < copies * of_copy; ++b) {
          if (a == b || a / of_copy != b / of_copy) continue;
          const Real reach = made.radius[a] + made.radius[b] + made.allowance[a] + made.allowance[b];
          const Vector3<Real> apart = nearest_image(made.position.at(b) - made.position.at(a), period);
          if (dot(apart, apart) > reach * reach) continue;
          (b > a ? expected : lower).push_back(static_cast<std::uint32_t>(b));
        }
        const auto at = [&](std::uint32_t i) { return list.other.begin() + i; };
        CHECK(std::vector<std::uint32_t>(at(list.first[a]), at(list.first[a + 1])) == expected);
        std::vector<std::uint32_t> found;
        for (std::uint32_t k = list.first_lower[a]; k < list.first_lower[a + 1]; ++k) {
          const std::uint32_t pair = list.lower[k];
          CHECK(list.other[pair] == a);
          found.push_back(static_cast<std::uint32_t>(std::upper_bound(list.first.begin(), list.first.end(), pair) -
                                                     list.first.begin() - 1));
        }
        CHECK(found == lower);
        pairs += expected.size();
      }
      CHECK(pairs > 100);
      CHECK(list.candidates() == pairs);
    }
  }
}

TEST_CASE("Neighbour list: holds until a body has used up what it may go", "[collide]") {
  Workers workers(1);
  Cloud made = cloud(50);
  std::fill(made.allowance.begin(), made.allowance.end(), Real(0.01));
  const Period period{{1, 1, 1}};
  NeighbourList list;
  std::vector<Real> ahead(50, 0);
  CHECK_FALSE(list.holds(made.position, period, ahead, workers));
  list.build(made.position, made.radius, made.allowance, 50, period, workers);
  CHECK(list.holds(made.position, period, ahead, workers));
  made.position.x[7] += 1;  // the same place in a space that repeats
  CHECK(list.holds(made.position, period, ahead, workers));
  made.position.x[7] += Real(0.009);
  CHECK(list.holds(made.position, period, ahead, workers));
  ahead[7] = Real(0.002);
  CHECK_FALSE(list.holds(made.position, period, ahead, workers));
  ahead[7] = 0;
  made.position.x[7] += Real(0.002);
  CHECK_FALSE(list.holds(made.position, period, ahead, workers));
}
