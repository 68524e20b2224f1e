// DROP on the Open Dynamics Engine, through its own broad phase and its iterative solver.
#include "perf/peers/heap_engine.h"

#ifdef BALLPARK_ODE
#define dDOUBLE
#include <ode/ode.h>
#endif

namespace ballpark::perf {

#ifdef BALLPARK_ODE

namespace {

class OdeHeap : public HeapEngine {
 public:
  explicit OdeHeap(const HeapScene& scene) : scene_(scene) {
    dInitODE();
    world_ = dWorldCreate();
    dWorldSetGravity(world_, 0, 0, -scene.gravity);
    dWorldSetQuickStepNumIterations(world_, 10);
    space_ = dHashSpaceCreate(nullptr);
    dHashSpaceSetLevels(space_, -4, 2);  // cells from 0.06 m on
    contacts_ = dJointGroupCreate(0);
    dCreatePlane(space_, 0, 0, 1, 0);
    for (const double side : {1.0, -1.0}) {
      const double offset = side > 0 ? 0 : -scene.width;
      dCreatePlane(space_, side, 0, 0, offset);
      dCreatePlane(space_, 0, side, 0, offset);
    }
    for (const auto& x : scene.positions) {
      const dBodyID body = dBodyCreate(world_);
      dMass mass;
      dMassSetSphere(&mass, scene.density, scene.radius);
      dBodySetMass(body, &mass);
      dBodySetPosition(body, x[0], x[1], x[2]);
      dGeomSetBody(dCreateSphere(space_, scene.radius), body);
      bodies_.push_back(body);
    }
  }
  ~OdeHeap() override {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
    dCloseODE();
  }

  void step() override {
    dSpaceCollide(space_, this, &OdeHeap::collide);
    dWorldQuickStep(world_, scene_.step);
    dJointGroupEmpty(contacts_);
  }

  std::vector<std::array<double, 3>> positions() const override {
    std::vector<std::array<double, 3>> list;
    for (const dBodyID body : bodies_) {
      const dReal* x = dBodyGetPosition(body);
      list.push_back({x[0], x[1], x[2]});
    }
    return list;
  }

 private:
  static void collide(void* data, dGeomID a, dGeomID b) {
    auto& self = *static_cast<OdeHeap*>(data);
    dContact contact;
    if (dCollide(a, b, 1, &contact.geom, sizeof contact) == 0) return;
    contact.surface.mode = dContactApprox1 | dContactBounce;
    contact.surface.mu = self.scene_.friction;
    contact.surface.bounce = self.scene_.restitution;
    contact.surface.bounce_vel = 0;
    dJointAttach(dJointCreateContact(self.world_, self.contacts_, &contact), dGeomGetBody(a), dGeomGetBody(b));
  }

  HeapScene scene_;
  dWorldID world_;
  dSpaceID space_;
  dJointGroupID contacts_;
  std::vector<dBodyID> bodies_;
};

}  // namespace

std::unique_ptr<HeapEngine> ode_heap(const HeapScene& scene) {
  return std::make_unique<OdeHeap>(scene);
}

#else

std::unique_ptr<HeapEngine> ode_heap(const HeapScene&) {
  return nullptr;
}

#endif

}  // namespace ballpark::perf
