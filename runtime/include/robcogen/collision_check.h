// Whether a robot touches itself or an obstacle, in one state or in several, one in each lane. A check ends as soon as
// the answer is known: links are placed one after another from the base, and their shapes are looked at only where
// spheres around them are near something.
//
// The header <name>/collision_check.h of a robot has its shapes and functions that call these.
#pragma once

#include <cstddef>
#include <cstring>
#include <type_traits>

#include "robcogen/lanes.h"

#if defined(__GNUC__)
#define ROBCOGEN_INLINE inline __attribute__((always_inline))
#else
#define ROBCOGEN_INLINE inline
#endif

namespace robcogen {

// The tables of a robot's shapes.
namespace collision {

// A sphere (m) around its members: bodies of a link, or spheres of a body.
struct Group {
  int first, count;
  double radius;
};
struct Pair {
  int a, b;
};
// Two links, and the pairs of their bodies that are checked.
struct LinkPair {
  int a, b, first, count;
};

// As in lanes.h: the linker must not replace a function for one processor by that for another.
namespace {

// Sets of lanes: a bit for each. A number has one lane.
using LaneSet = unsigned;

template <class Scalar>
constexpr int kLaneCount = 1;
template <class Scalar, int kSize>
constexpr int kLaneCount<Lanes<Scalar, kSize>> = kSize;

template <class Scalar>
constexpr LaneSet kAllLanes = (LaneSet(2) << (kLaneCount<Scalar> - 1)) - 1;

// The lanes in which x is negative, or not a number: a state without meaning is not free.
template <class Scalar>
ROBCOGEN_INLINE LaneSet negative(const Scalar& x) noexcept {
  return !(x >= Scalar(0)) ? 1u : 0u;
}

template <class Scalar, int kSize>
ROBCOGEN_INLINE LaneSet negative(const Lanes<Scalar, kSize>& x) noexcept {
  static_assert(kSize <= 32, "a bit for each lane");
  if constexpr (kSize == 1) {
    return negative(x[0]);
  } else if constexpr (kSize > lanes::kInRegister<Scalar>) {
    return negative(x.low()) | negative(x.high()) << (kSize / 2);
  } else {
#if ROBCOGEN_HAS_VECTORS && defined(__AVX__)
    using Vector = lanes::Vector<Scalar, kSize>;
    [[maybe_unused]] Vector signs;  // of lanes that are free
    if constexpr (kSize * sizeof(Scalar) == 32) {
      const auto is_free = x.vector() >= Vector{};
      std::memcpy(&signs, &is_free, sizeof(signs));
    }
    if constexpr (std::is_same_v<Scalar, float> && kSize == 8)
      return kAllLanes<Lanes<float, 8>> & ~static_cast<LaneSet>(__builtin_ia32_movmskps256(signs));
    if constexpr (std::is_same_v<Scalar, double> && kSize == 4)
      return kAllLanes<Lanes<double, 4>> & ~static_cast<LaneSet>(__builtin_ia32_movmskpd256(signs));
#endif
    LaneSet result = 0;
    for (int i = 0; i < kSize; ++i) result |= negative(x[i]) << i;
    return result;
  }
}

constexpr std::size_t at(int k) noexcept {
  return static_cast<std::size_t>(k);
}

// The lanes in which the points a and b (m) are nearer to each other than this distance.
template <class Scalar>
ROBCOGEN_INLINE LaneSet nearer(const Scalar* a, const Scalar* b, double distance) noexcept {
  const Scalar x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return negative(x * x + y * y + z * z - Scalar(distance * distance));
}

// Whether any lane is hit: the check ends with the first one.
struct AnyLane {
  LaneSet hit = 0;
  ROBCOGEN_INLINE bool matter(LaneSet lanes) const noexcept { return lanes != 0; }
  ROBCOGEN_INLINE bool end(LaneSet lanes) noexcept {
    hit = lanes;
    return lanes != 0;
  }
};

// Which lanes are hit: the check ends when all are.
struct EachLane {
  LaneSet all, hit = 0;
  ROBCOGEN_INLINE bool matter(LaneSet lanes) const noexcept { return (lanes & ~hit) != 0; }
  ROBCOGEN_INLINE bool end(LaneSet lanes) noexcept {
    hit |= lanes;
    return hit == all;
  }
};

// No obstacles.
struct Nothing {
  template <class Scalar>
  constexpr LaneSet operator()(const Scalar&, const Scalar&, const Scalar&, double) const noexcept {
    return 0;
  }
};

template <class Shapes, class Scalar, class Obstacles, class Found>
class Check {
 public:
  ROBCOGEN_INLINE Check(const Scalar* q, const Obstacles& obstacles, Found& lanes) noexcept
      : q_(q), obstacles_(obstacles), lanes_(lanes) {}

  ROBCOGEN_INLINE void run() noexcept {
    const bool ends = Shapes::place(q_, workspace_, links_, [this](int link) noexcept {
      if constexpr (!std::is_same_v<Obstacles, Nothing>) return obstacle_ends(link);
      return (void)link, false;
    });
    if (!ends) pairs_end();
  }

 private:
  const Scalar* q_;
  const Obstacles& obstacles_;
  Found& lanes_;
  bool is_inside_placed_[Shapes::kLinkCount] = {};
  Scalar workspace_[Shapes::kWorkspace];
  Scalar links_[3 * Shapes::kLinkCount];
  Scalar bodies_[3 * Shapes::kBodyCount];
  Scalar spheres_[3 * Shapes::kSphereCount];

  ROBCOGEN_INLINE void place_inside(int link) noexcept {
    if (is_inside_placed_[link]) return;
    is_inside_placed_[link] = true;
    Shapes::place_inside(link, q_, workspace_, bodies_, spheres_);
  }

  ROBCOGEN_INLINE LaneSet at_obstacle(const Scalar* center, double radius) const noexcept {
    return static_cast<LaneSet>(obstacles_(center[0], center[1], center[2], radius));
  }

  // A sphere around one member is this member, and is not looked at twice.
  bool obstacle_ends(int link) noexcept {
    const Group& l = Shapes::kLinks[at(link)];
    LaneSet near = at_obstacle(links_ + 3 * link, l.radius);
    if (!lanes_.matter(near)) return false;
    if (l.count == 1 && Shapes::kBodies[at(l.first)].count == 1) return lanes_.end(near);
    place_inside(link);
    for (int b = l.first; b < l.first + l.count; ++b) {
      const Group& body = Shapes::kBodies[at(b)];
      if (l.count > 1) near = at_obstacle(bodies_ + 3 * b, body.radius);
      if (!lanes_.matter(near)) continue;
      if (body.count == 1) {
        if (lanes_.end(near)) return true;
        continue;
      }
      for (int s = body.first; s < body.first + body.count; ++s)
        if (lanes_.end(at_obstacle(spheres_ + 3 * s, Shapes::kRadii[at(s)]))) return true;
    }
    return false;
  }

  bool pairs_end() noexcept {
    for (const LinkPair& pair : Shapes::kLinkPairs) {
      const double distance = Shapes::kLinks[at(pair.a)].radius + Shapes::kLinks[at(pair.b)].radius;
      if (lanes_.matter(nearer(links_ + 3 * pair.a, links_ + 3 * pair.b, distance)) && pair_ends(pair)) return true;
    }
    return false;
  }

  bool pair_ends(const LinkPair& links) noexcept {
    place_inside(links.a);
    place_inside(links.b);
    for (int p = links.first; p < links.first + links.count; ++p) {
      const auto [a, b] = Shapes::kBodyPairs[at(p)];
      const Group &first = Shapes::kBodies[a], &second = Shapes::kBodies[at(b)];
      const LaneSet near = nearer(bodies_ + 3 * a, bodies_ + 3 * b, first.radius + second.radius);
      if (!lanes_.matter(near)) continue;
      if (first.count == 1 && second.count == 1) {
        if (lanes_.end(near)) return true;
        continue;
      }
      for (int s = first.first; s < first.first + first.count; ++s) {
        const Scalar* sphere = spheres_ + 3 * s;
        const double radius = Shapes::kRadii[at(s)];
        if (!lanes_.matter(nearer(sphere, bodies_ + 3 * b, radius + second.radius))) continue;
        for (int t = second.first; t < second.first + second.count; ++t)
          if (lanes_.end(nearer(sphere, spheres_ + 3 * t, radius + Shapes::kRadii[at(t)]))) return true;
      }
    }
    return false;
  }
};

}  // namespace
}  // namespace collision

namespace {

// Whether the robot with these shapes touches itself or an obstacle. `q`: a number for each position, or a value with
// lanes: then true if it does in any lane. `obstacles(x, y, z, radius)` tells in which lanes the sphere touches one: a
// bit for each lane, or, if only one answer for all lanes is asked for, a bool.
template <class Shapes, class Scalar, class Obstacles>
ROBCOGEN_INLINE bool in_collision(const Scalar* q, const Obstacles& obstacles) noexcept {
  collision::AnyLane lanes;
  collision::Check<Shapes, Scalar, Obstacles, collision::AnyLane>(q, obstacles, lanes).run();
  return lanes.hit != 0;
}

template <class Shapes, class Scalar>
ROBCOGEN_INLINE bool self_collision(const Scalar* q) noexcept {
  return in_collision<Shapes>(q, collision::Nothing());
}

// The lanes in which it does, a bit for each.
template <class Shapes, class Scalar, class Obstacles>
ROBCOGEN_INLINE collision::LaneSet lanes_in_collision(const Scalar* q, const Obstacles& obstacles) noexcept {
  collision::EachLane lanes{collision::kAllLanes<Scalar>};
  collision::Check<Shapes, Scalar, Obstacles, collision::EachLane>(q, obstacles, lanes).run();
  return lanes.hit;
}

}  // namespace
}  // namespace robcogen

#undef ROBCOGEN_INLINE
