#include <chipmunk/chipmunk.h>
#include <cmath>
#include <cstdio>
#include <limits>
#include <unistd.h>

#include "tests/bench/peers/discs.h"

namespace bench {
namespace {

/// The first space of a program makes Debian's build say that it checks its assertions: among the
/// errors, where it does not get into the table.
cpSpace* newSpace() {
  std::fflush(stdout);
  const int output = dup(STDOUT_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  cpSpace* space = cpSpaceNew();
  std::fflush(stdout);
  dup2(output, STDOUT_FILENO);
  close(output);
  return space;
}

class ChipmunkWorld : public DiscWorld {
 public:
  ChipmunkWorld(const core::Scene& scene, const WorldOptions& options)
      : m_space(newSpace()), m_step(options.step) {
    cpSpaceSetGravity(m_space, cpv(0, -scene.gravity));
    cpSpaceSetCollisionSlop(m_space, options.slop);
    if (options.mayRest) cpSpaceSetSleepTimeThreshold(m_space, 0.5);
    cpCollisionHandler* handler = cpSpaceAddDefaultCollisionHandler(m_space);
    handler->postSolveFunc = countImpact;
    handler->userData = this;
    addWalls(scene);
    for (const core::Weight& weight : scene.weights) addDisc(scene, weight);
    if (options.isHashed && !scene.weights.empty())
      cpSpaceUseSpatialHash(m_space, 2 * scene.weights[0].radius,
                            static_cast<int>(10 * scene.weights.size()));
  }
  ~ChipmunkWorld() override {
    for (cpShape* shape : m_shapes) {
      cpSpaceRemoveShape(m_space, shape);
      cpShapeFree(shape);
    }
    for (cpBody* disc : m_discs) {
      cpSpaceRemoveBody(m_space, disc);
      cpBodyFree(disc);
    }
    cpSpaceFree(m_space);
  }

  bool step() override {
    cpSpaceStep(m_space, m_step);
    return true;
  }
  Eigen::Vector2d position(int disc) const override {
    const cpVect place = cpBodyGetPosition(m_discs[disc]);
    return {place.x, place.y};
  }
  Eigen::Vector2d velocity(int disc) const override {
    const cpVect velocity = cpBodyGetVelocity(m_discs[disc]);
    return {velocity.x, velocity.y};
  }
  int impacts() const override { return m_impacts; }

 private:
  static void countImpact(cpArbiter* arbiter, cpSpace* /*space*/, cpDataPointer self) {
    if (cpvlength(cpArbiterTotalImpulse(arbiter)) > 0)
      ++static_cast<ChipmunkWorld*>(self)->m_impacts;
  }

  void add(const core::Scene& scene, cpShape* shape) {
    // It multiplies the two shapes' own.
    cpShapeSetElasticity(shape, std::sqrt(scene.restitution));
    cpShapeSetFriction(shape, 0);
    m_shapes.push_back(cpSpaceAddShape(m_space, shape));
  }

  void addWalls(const core::Scene& scene) {
    // Thick, so that nothing is pushed out on the far side.
    constexpr double kThickness = 1;
    const double left = -kThickness, right = scene.room.width + kThickness;
    const double bottom = -kThickness, top = scene.room.height + kThickness;
    const cpVect corners[] = {cpv(left, bottom), cpv(right, bottom), cpv(right, top),
                              cpv(left, top)};
    for (int i = 0; i < 4; ++i)
      add(scene, cpSegmentShapeNew(cpSpaceGetStaticBody(m_space), corners[i], corners[(i + 1) % 4],
                                   kThickness));
  }

  void addDisc(const core::Scene& scene, const core::Weight& weight) {
    cpBody* disc =
        cpSpaceAddBody(m_space, cpBodyNew(weight.mass, std::numeric_limits<double>::infinity()));
    cpBodySetPosition(disc, cpv(weight.position.x(), weight.position.y()));
    cpBodySetVelocity(disc, cpv(weight.velocity.x(), weight.velocity.y()));
    m_discs.push_back(disc);
    add(scene, cpCircleShapeNew(disc, weight.radius, cpvzero));
  }

  cpSpace* m_space;
  double m_step;
  std::vector<cpBody*> m_discs;
  std::vector<cpShape*> m_shapes;
  int m_impacts = 0;
};

}  // namespace

std::unique_ptr<DiscWorld> chipmunkWorld(const core::Scene& scene, const WorldOptions& options) {
  return std::make_unique<ChipmunkWorld>(scene, options);
}

}  // namespace bench
