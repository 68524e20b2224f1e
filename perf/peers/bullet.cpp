// DROP on Bullet, through its own broad phase and its sequential impulse solver.
#include "perf/peers/heap_engine.h"

#ifdef BALLPARK_BULLET
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <numbers>
#endif

namespace ballpark::perf {

#ifdef BALLPARK_BULLET

namespace {

class BulletHeap : public HeapEngine {
 public:
  explicit BulletHeap(const HeapScene& scene)
      : scene_(scene),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broad_phase_, &solver_, &configuration_),
        ball_(static_cast<btScalar>(scene.radius)) {
    world_.setGravity({0, 0, static_cast<btScalar>(-scene.gravity)});
    world_.getSolverInfo().m_numIterations = 10;
    const auto width = static_cast<btScalar>(scene.width);
    add_plane({0, 0, 1}, 0);
    add_plane({1, 0, 0}, 0);
    add_plane({0, 1, 0}, 0);
    add_plane({-1, 0, 0}, -width);
    add_plane({0, -1, 0}, -width);
    const double r = scene.radius;
    const auto mass = static_cast<btScalar>(scene.density * 4 / 3 * std::numbers::pi * r * r * r);
    btVector3 inertia;
    ball_.calculateLocalInertia(mass, inertia);
    for (const auto& x : scene.positions) {
      btRigidBody* body = add(mass, ball_, inertia);
      btTransform place;
      place.setIdentity();
      place.setOrigin({static_cast<btScalar>(x[0]), static_cast<btScalar>(x[1]), static_cast<btScalar>(x[2])});
      body->setCenterOfMassTransform(place);
      body->setActivationState(DISABLE_DEACTIVATION);  // nobody else sleeps
      balls_.push_back(body);
    }
  }
  ~BulletHeap() override {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }

  void step() override { world_.stepSimulation(static_cast<btScalar>(scene_.step), 0); }

  std::vector<std::array<double, 3>> positions() const override {
    std::vector<std::array<double, 3>> list;
    for (const btRigidBody* body : balls_) {
      const btVector3& x = body->getCenterOfMassPosition();
      list.push_back({x.x(), x.y(), x.z()});
    }
    return list;
  }

 private:
  btRigidBody* add(btScalar mass, btCollisionShape& shape, const btVector3& inertia) {
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, &shape, inertia);
    info.m_friction = static_cast<btScalar>(std::sqrt(scene_.friction));  // Bullet multiplies both sides' values
    info.m_restitution = static_cast<btScalar>(std::sqrt(scene_.restitution));
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    world_.addRigidBody(bodies_.back().get());
    return bodies_.back().get();
  }
  void add_plane(const btVector3& normal, btScalar offset) {
    planes_.push_back(std::make_unique<btStaticPlaneShape>(normal, offset));
    add(0, *planes_.back(), {0, 0, 0});
  }

  HeapScene scene_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broad_phase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  btSphereShape ball_;
  std::vector<std::unique_ptr<btStaticPlaneShape>> planes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<btRigidBody*> balls_;
};

}  // namespace

std::unique_ptr<HeapEngine> bullet_heap(const HeapScene& scene) {
  return std::make_unique<BulletHeap>(scene);
}

#else

std::unique_ptr<HeapEngine> bullet_heap(const HeapScene&) {
  return nullptr;
}

#endif

}  // namespace ballpark::perf
