#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/scene/scene.h"

namespace bench {

/// A scene of free weights without air, as a program that steps discs in a room sees it.
class DiscWorld {
 public:
  DiscWorld() = default;
  DiscWorld(const DiscWorld&) = delete;
  DiscWorld& operator=(const DiscWorld&) = delete;
  virtual ~DiscWorld() = default;

  /// @return  false if it could not go on
  virtual bool step() = 0;
  virtual Eigen::Vector2d position(int disc) const = 0;  ///< [m]
  virtual Eigen::Vector2d velocity(int disc) const = 0;  ///< [m/s]
  /// Impulses that discs exchanged with walls and each other so far, each step's counted once.
  virtual int impacts() const = 0;
};

/// What may be chosen of an engine.
struct WorldOptions {
  double step = 1.0 / 60;  ///< [s]
  bool mayRest = true;     ///< slow bounces end; false: none does, as e = 1 needs it
  double slop = 1e-3;      ///< overlap that is left alone [m]; Chipmunk only
  bool isHashed = false;   ///< spatial hash in place of a tree; Chipmunk only
};

using MakeWorld = std::unique_ptr<DiscWorld> (*)(const core::Scene&, const WorldOptions&);

struct Engine {
  std::string name;
  MakeWorld make = nullptr;
  WorldOptions options = {};
};

std::unique_ptr<DiscWorld> ourWorld(const core::Scene& scene, const WorldOptions& options);
/// @pre the restitutions of room and weights are the same: Box2D takes the larger
std::unique_ptr<DiscWorld> box2dWorld(const core::Scene& scene, const WorldOptions& options);
std::unique_ptr<DiscWorld> chipmunkWorld(const core::Scene& scene, const WorldOptions& options);

/// Those that were there when the program was built.
std::vector<Engine> otherEngines();
/// Us first, then the same, with every choice that some crowd may like best.
std::vector<Engine> crowdEngines();

/// How far two discs overlap at most now [m]; 0 if none do.
double largestOverlap(const core::Scene& scene, const DiscWorld& world);
/// Kinetic energy of all discs [J].
double kineticEnergy(const core::Scene& scene, const DiscWorld& world);

}  // namespace bench
