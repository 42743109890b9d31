#include <benchmarks/peers.h>

#include <vector>

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

namespace hair::bench {

namespace {

constexpr float kSkin = 3e-3f;             // as GuideSettings::skin
constexpr float kLinearDensity = 6.5e-6f;  // as GuideSettings::linearDensity, kg/m

btVector3 toBullet(glm::vec3 v) {
  return {v.x, v.y, v.z};
}
glm::vec3 fromBullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}
btTransform toBullet(const RigidTransform& t) {
  return btTransform(btQuaternion(t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w),
                     toBullet(t.translation));
}

const btVector3 kGravity(0, -9.81f, 0);

class BulletRopes final : public GuideSolver {
 public:
  BulletRopes(const GuideWork& work, int iterations)
      : groom_(sphereGroom(work)),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_),
        sphereShape_(kSphereRadius),
        sphere_(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &sphereShape_)) {
    world_.setGravity(kGravity);
    btSoftBodyWorldInfo& info = world_.getWorldInfo();
    info.m_gravity = kGravity;
    info.m_dispatcher = &dispatcher_;
    info.m_broadphase = &broadphase_;
    info.m_sparsesdf.Initialize();
    sphere_.setCollisionFlags(sphere_.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    sphere_.setActivationState(DISABLE_DEACTIVATION);
    world_.addRigidBody(&sphere_);

    std::vector<btVector3> points;
    for (const glm::vec3 p : groom_.guidePoints) points.push_back(toBullet(p));
    const float mass = kLinearDensity * kGuideLength / static_cast<float>(work.links);
    const std::vector<btScalar> masses(points.size(), mass);
    body_ = std::make_unique<btSoftBody>(&info, static_cast<int>(points.size()), points.data(),
                                         masses.data());
    for (int root = 0; root < body_->m_nodes.size(); root += static_cast<int>(work.links) + 1) {
      body_->setMass(root, 0);
      for (int i = 0; i < static_cast<int>(work.links); ++i)
        body_->appendLink(root + i, root + i + 1);
    }
    body_->m_cfg.piterations = iterations;
    body_->m_cfg.kDF = 0.3f;
    body_->m_cfg.collisions = btSoftBody::fCollision::SDF_RS;
    body_->m_materials[0]->m_kLST = 1;
    body_->getCollisionShape()->setMargin(kSkin);
    body_->setActivationState(DISABLE_DEACTIVATION);
    world_.addSoftBody(body_.get());
  }
  ~BulletRopes() override {
    world_.removeSoftBody(body_.get());
    world_.removeRigidBody(&sphere_);
  }

  void step(const RigidTransform& sphere) override {
    sphere_.setWorldTransform(toBullet(sphere));
    for (std::size_t root = 0; root < groom_.guidePoints.size(); root += groom_.pointsPerGuide) {
      btSoftBody::Node& node = body_->m_nodes[static_cast<int>(root)];
      node.m_x = node.m_q = toBullet(sphere.point(groom_.guidePoints[root]));
      node.m_v = btVector3(0, 0, 0);
    }
    world_.stepSimulation(kFrameSeconds, 0);
  }
  void copyPoints(std::span<glm::vec3> out) const override {
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = fromBullet(body_->m_nodes[static_cast<int>(i)].m_x);
  }

 private:
  Groom groom_;
  btSoftBodyRigidBodyCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btSoftRigidDynamicsWorld world_;
  btSphereShape sphereShape_;
  btRigidBody sphere_;
  std::unique_ptr<btSoftBody> body_;
};

class BulletChains final : public GuideSolver {
 public:
  BulletChains(const GuideWork& work, int substeps)
      : groom_(sphereGroom(work)),
        links_(static_cast<int>(work.links)),
        substeps_(substeps),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
    world_.setGravity(kGravity);
    const float length = kGuideLength / static_cast<float>(work.links);
    const float mass = kLinearDensity * length;
    const btVector3 inertia(mass * length * length / 12, 1e-3f * mass * length * length,
                            mass * length * length / 12);
    for (std::size_t root = 0; root < groom_.guidePoints.size(); root += groom_.pointsPerGuide) {
      // A chain lies along its own +Y; its base turns that outwards.
      const btVector3 outwards = toBullet(glm::normalize(groom_.guidePoints[root]));
      rest_.emplace_back(shortestArcQuat(btVector3(0, 1, 0), outwards),
                         toBullet(groom_.guidePoints[root]));
      auto body = std::make_unique<btMultiBody>(links_, 0.0f, btVector3(0, 0, 0), true, false);
      for (int i = 0; i < links_; ++i)
        body->setupSpherical(i, mass, inertia, i - 1, btQuaternion::getIdentity(),
                             btVector3(0, i == 0 ? 0 : length / 2, 0), btVector3(0, length / 2, 0),
                             true);
      body->finalizeMultiDof();
      body->setBaseWorldTransform(rest_.back());
      world_.addMultiBody(body.get());
      bodies_.push_back(std::move(body));
    }
  }
  ~BulletChains() override {
    for (const auto& body : bodies_) world_.removeMultiBody(body.get());
  }

  void step(const RigidTransform& sphere) override {
    const btTransform moved = toBullet(sphere);
    for (std::size_t s = 0; s < bodies_.size(); ++s)
      bodies_[s]->setBaseWorldTransform(moved * rest_[s]);
    const btScalar substep = kFrameSeconds / static_cast<float>(substeps_);
    for (int i = 0; i < substeps_; ++i) world_.stepSimulation(substep, 0);
  }
  void copyPoints(std::span<glm::vec3> out) const override {
    const float half = 0.5f * kGuideLength / static_cast<float>(links_);
    std::size_t p = 0;
    for (const auto& body : bodies_) {
      out[p++] = fromBullet(body->getBasePos());
      for (int i = 0; i < links_; ++i)
        out[p++] = fromBullet(body->localPosToWorld(i, btVector3(0, half, 0)));
    }
  }

 private:
  Groom groom_;
  int links_, substeps_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btMultiBodyConstraintSolver solver_;
  btMultiBodyDynamicsWorld world_;
  std::vector<btTransform> rest_;
  std::vector<std::unique_ptr<btMultiBody>> bodies_;
};

}  // namespace

std::unique_ptr<GuideSolver> makeBulletRopes(const GuideWork& work, int iterations) {
  return std::make_unique<BulletRopes>(work, iterations);
}

std::unique_ptr<GuideSolver> makeBulletChains(const GuideWork& work, int substeps) {
  return std::make_unique<BulletChains>(work, substeps);
}

}  // namespace hair::bench
