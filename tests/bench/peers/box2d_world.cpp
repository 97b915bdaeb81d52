#include <box2d/box2d.h>
#include <numbers>

#include "tests/bench/peers/discs.h"

namespace bench {
namespace {

b2Vec2 single(double x, double y) {
  return {static_cast<float>(x), static_cast<float>(y)};
}

class Box2dWorld : public DiscWorld, private b2ContactListener {
 public:
  Box2dWorld(const core::Scene& scene, const WorldOptions& options)
      : m_world(single(0, -scene.gravity)), m_options(options) {
    m_world.SetContactListener(this);
    m_world.SetAllowSleeping(options.mayRest);
    addWalls(scene);
    for (const core::Weight& weight : scene.weights) addDisc(scene, weight);
  }

  bool step() override {
    m_world.Step(static_cast<float>(m_options.step), 8, 3);  // as its manual recommends
    return true;
  }
  Eigen::Vector2d position(int disc) const override {
    return {m_discs[disc]->GetPosition().x, m_discs[disc]->GetPosition().y};
  }
  Eigen::Vector2d velocity(int disc) const override {
    return {m_discs[disc]->GetLinearVelocity().x, m_discs[disc]->GetLinearVelocity().y};
  }
  int impacts() const override { return m_impacts; }

 private:
  void PostSolve(b2Contact* /*contact*/, const b2ContactImpulse* impulse) override {
    if (impulse->count > 0 && impulse->normalImpulses[0] > 0) ++m_impacts;
  }

  b2FixtureDef fixture(const core::Scene& scene, const b2Shape& shape) const {
    b2FixtureDef definition;
    definition.shape = &shape;
    definition.friction = 0;
    definition.restitution = static_cast<float>(scene.restitution);
    // Else everything slower than 1 m/s is caught at once.
    definition.restitutionThreshold = 0;
    return definition;
  }

  void addWalls(const core::Scene& scene) {
    // Edges have a skin; with it they are where the walls are.
    const double skin = b2_polygonRadius;
    const double left = -skin, right = scene.room.width + skin;
    const double bottom = -skin, top = scene.room.height + skin;
    const b2BodyDef definition;
    b2Body* walls = m_world.CreateBody(&definition);
    const b2Vec2 corners[] = {single(left, bottom), single(right, bottom), single(right, top),
                              single(left, top)};
    for (int i = 0; i < 4; ++i) {
      b2EdgeShape edge;
      edge.SetTwoSided(corners[i], corners[(i + 1) % 4]);
      const b2FixtureDef wall = fixture(scene, edge);
      walls->CreateFixture(&wall);
    }
  }

  void addDisc(const core::Scene& scene, const core::Weight& weight) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.fixedRotation = true;
    definition.position = single(weight.position.x(), weight.position.y());
    definition.linearVelocity = single(weight.velocity.x(), weight.velocity.y());
    b2CircleShape circle;
    circle.m_radius = static_cast<float>(weight.radius);
    b2FixtureDef disc = fixture(scene, circle);
    disc.density =
        static_cast<float>(weight.mass / (std::numbers::pi * weight.radius * weight.radius));
    m_discs.push_back(m_world.CreateBody(&definition));
    m_discs.back()->CreateFixture(&disc);
  }

  b2World m_world;
  WorldOptions m_options;
  std::vector<b2Body*> m_discs;  // the world's
  int m_impacts = 0;
};

}  // namespace

std::unique_ptr<DiscWorld> box2dWorld(const core::Scene& scene, const WorldOptions& options) {
  return std::make_unique<Box2dWorld>(scene, options);
}

}  // namespace bench
