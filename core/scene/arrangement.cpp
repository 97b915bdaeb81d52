#include "core/scene/arrangement.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/scene/free_places.h"
#include "core/scene/overlaps.h"
#include "core/scene/placing.h"
#include "core/scene/scene_limits.h"

namespace core {

namespace {

// M. Okabe and K. Ito, Color Universal Design (2008); a dark grey for their black, which would
// be lost on a dark background. Neighbors in the list differ in lightness as well as in hue.
constexpr std::array<Color, 8> kDistinctColors{{{0xe6, 0x9f, 0x00},
                                                {0x56, 0xb4, 0xe9},
                                                {0x00, 0x9e, 0x73},
                                                {0xd5, 0x5e, 0x00},
                                                {0x00, 0x72, 0xb2},
                                                {0xcc, 0x79, 0xa7},
                                                {0xf0, 0xe4, 0x42},
                                                {0x50, 0x50, 0x50}}};

/// A fixed number that looks random: the index-th output of SplitMix64 started at 0.
/// Source: G. Steele, D. Lea, C. Flood, OOPSLA 2014, Fig. 13 and 17.
std::uint64_t scrambled(std::uint64_t index) {
  std::uint64_t z = (index + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

/// One channel of a color given by hue, saturation and value, each from 0 to 1.
/// @param turn  5/6 for red, 3/6 for green, 1/6 for blue
std::uint8_t channel(double hue, double saturation, double value, double turn) {
  const double place = (hue + turn) - std::floor(hue + turn);
  const double missing = std::clamp(2 - std::abs(6 * place - 2), 0.0, 1.0);
  return static_cast<std::uint8_t>(std::lround(255 * value * (1 - saturation * missing)));
}

/// Stretch of x the pivots may stand on [m].
struct Stretch {
  double left;
  double right;

  double width() const { return right - left; }
};

/// How far to a side the weight swings from below its pivot, radius included [m].
double reachOf(const Weight& weight) {
  const Rope& rope = *weight.rope;
  const double widest = std::min(std::abs(rope.angle), std::numbers::pi / 2);
  const bool startsAtRest = rope.angularVelocity == 0;
  return rope.length * (startsAtRest ? std::sin(widest) : 1) + weight.radius;
}

std::vector<Weight*> hangingWeights(Scene& scene) {
  std::vector<Weight*> hanging;
  for (Weight& weight : scene.weights) {
    if (weight.rope) hanging.push_back(&weight);
  }
  return hanging;
}

/// Pivots from which every swing stays between the walls; left > right if there are none.
Stretch whereSwingsFit(const std::vector<Weight*>& hanging, double roomWidth) {
  double reach = 0;
  for (const Weight* weight : hanging) reach = std::max(reach, reachOf(*weight));
  return {reach, roomWidth - reach};
}

/// Pivots from which every weight at least starts between the walls; left > right if none.
Stretch whereStartsFit(const std::vector<Weight*>& hanging, double roomWidth) {
  Stretch stretch{0, roomWidth};
  for (const Weight* weight : hanging) {
    const double aside = startPosition(*weight).x() - weight->rope->pivot.x();
    stretch.left = std::max(stretch.left, weight->radius - aside);
    stretch.right = std::min(stretch.right, roomWidth - weight->radius - aside);
  }
  return stretch;
}

/// Ties the ropes at even intervals: each in the middle of its equal part of the room, or
/// closer together where the stretch is too short for that.
void spread(const std::vector<Weight*>& hanging, Stretch stretch, double roomWidth) {
  const auto count = static_cast<double>(hanging.size());
  const double middle = std::midpoint(stretch.left, stretch.right);
  double interval = roomWidth / count;
  if (count > 1) interval = std::min(interval, stretch.width() / (count - 1));
  for (std::size_t i = 0; i < hanging.size(); ++i) {
    const double place = static_cast<double>(i) - (count - 1) / 2;
    hanging[i]->rope->pivot.x() = middle + place * interval;
  }
}

void hangEvenly(Scene& scene) {
  const std::vector<Weight*> hanging = hangingWeights(scene);
  if (hanging.empty()) return;
  const double height = hanging.front()->rope->pivot.y();
  for (Weight* weight : hanging) weight->rope->pivot.y() = height;

  const double roomWidth = scene.room.width;
  const Stretch forSwings = whereSwingsFit(hanging, roomWidth);
  if (forSwings.width() >= 0) {
    spread(hanging, forSwings, roomWidth);
    if (overlapsAmong(startDiscs(scene)).empty()) return;
  }
  const Stretch forStarts = whereStartsFit(hanging, roomWidth);
  spread(hanging, forStarts.width() >= 0 ? forStarts : Stretch{0, roomWidth}, roomWidth);
}

}  // namespace

Color defaultColor(int index) {
  assert(index >= 0);
  const auto place = static_cast<std::size_t>(index);
  if (place < kDistinctColors.size()) return kDistinctColors[place];
  const std::uint64_t bits = scrambled(place);
  const auto fraction = [bits](int byte) {
    return static_cast<double>((bits >> (8 * byte)) & 0xffU) / 256;
  };
  // Neither so pale nor so dark that it is lost on a light or a dark background.
  const double hue = fraction(0);
  const double saturation = 0.55 + 0.35 * fraction(1);
  const double value = 0.6 + 0.3 * fraction(2);
  return {channel(hue, saturation, value, 5.0 / 6), channel(hue, saturation, value, 3.0 / 6),
          channel(hue, saturation, value, 1.0 / 6)};
}

Color colorOf(const Scene& scene, int index) {
  const auto& color = scene.weights[static_cast<std::size_t>(index)].color;
  return color ? *color : defaultColor(index);
}

Scene withWeightCount(const Scene& scene, int count) {
  assert(0 <= count && count <= kMostWeights);
  const auto wanted = static_cast<std::size_t>(count);
  Scene result = scene;
  std::vector<Weight>& weights = result.weights;
  if (weights.size() > wanted) weights.resize(wanted);

  Weight copy = weights.empty() ? firstWeight(scene.room) : weights.back();
  copy.color.reset();
  while (copy.rope && weights.size() < wanted) weights.push_back(copy);
  hangEvenly(result);

  // What is missing still are copies of a free weight: they stand beside it, not on it,
  // as long as there is room.
  for (const Eigen::Vector2d& place : freePlaces(result, copy, wanted - weights.size())) {
    weights.push_back(copy);
    weights.back().position = place;
  }
  while (weights.size() < wanted) weights.push_back(copy);
  return result;
}

}  // namespace core
