#include "app/walker.h"

#include <BulletCollision/CollisionDispatch/btGhostObject.h>
#include <BulletDynamics/Character/btKinematicCharacterController.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

namespace tyndall {
namespace {

constexpr float kStep = 1.0f / 120.0f;  // seconds of one collision step
constexpr float kFlyRadius = 0.2f;      // metres

btVector3 to_bullet(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}
glm::vec3 from_bullet(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}

}  // namespace

struct Walker::Implementation {
    Body body;
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};

    struct Collider {
        std::vector<glm::vec3> positions;
        std::vector<int> indices;
        std::unique_ptr<btTriangleIndexVertexArray> triangles;
        std::unique_ptr<btBvhTriangleMeshShape> shape;
        std::unique_ptr<btCollisionObject> object;
    };
    std::vector<std::unique_ptr<Collider>> colliders;

    btGhostPairCallback pair_callback;
    btCapsuleShape capsule;
    btSphereShape sphere{kFlyRadius};
    btPairCachingGhostObject ghost;
    std::unique_ptr<btKinematicCharacterController> controller;

    explicit Implementation(const Body& wanted)
        : body(wanted), capsule(body.radius_m, body.height_m - 2.0f * body.radius_m) {
        broadphase.getOverlappingPairCache()->setInternalGhostPairCallback(&pair_callback);
        world.setGravity({0.0f, -9.81f, 0.0f});
        ghost.setCollisionShape(&capsule);
        ghost.setCollisionFlags(btCollisionObject::CF_CHARACTER_OBJECT);
        controller = std::make_unique<btKinematicCharacterController>(&ghost, &capsule, body.step_m,
                                                                      btVector3(0.0f, 1.0f, 0.0f));
        controller->setGravity({0.0f, -9.81f, 0.0f});
        controller->setMaxSlope(btRadians(body.slope_deg));
        controller->setUseGhostSweepTest(false);
        controller->setMaxJumpHeight(0.5f);
        controller->setJumpSpeed(3.2f);
        world.addCollisionObject(&ghost, btBroadphaseProxy::CharacterFilter, btBroadphaseProxy::StaticFilter);
        world.addAction(controller.get());
    }

    ~Implementation() {
        clear();
        world.removeAction(controller.get());
        world.removeCollisionObject(&ghost);
    }

    void clear() {
        for (const auto& collider : colliders) world.removeCollisionObject(collider->object.get());
        colliders.clear();
    }

    /// From the capsule's centre to the eye.
    [[nodiscard]] glm::vec3 eye_offset() const { return {0.0f, body.eye_m - 0.5f * body.height_m, 0.0f}; }
    [[nodiscard]] glm::vec3 eye() const { return from_bullet(ghost.getWorldTransform().getOrigin()) + eye_offset(); }
};

Walker::Walker() : Walker(Body{}) {}
Walker::Walker(const Body& body) : self_(std::make_unique<Implementation>(body)) {}
Walker::~Walker() = default;

void Walker::add_collider(std::span<const glm::vec3> positions, std::span<const uint32_t> indices) {
    if (indices.size() < 3 || positions.empty()) return;
    auto collider = std::make_unique<Implementation::Collider>();
    collider->positions.assign(positions.begin(), positions.end());
    collider->indices.assign(indices.begin(), indices.end());
    collider->triangles = std::make_unique<btTriangleIndexVertexArray>(
        static_cast<int>(collider->indices.size() / 3), collider->indices.data(), static_cast<int>(3 * sizeof(int)),
        static_cast<int>(collider->positions.size()), &collider->positions.front().x,
        static_cast<int>(sizeof(glm::vec3)));
    collider->shape = std::make_unique<btBvhTriangleMeshShape>(collider->triangles.get(), true);
    collider->object = std::make_unique<btCollisionObject>();
    collider->object->setCollisionShape(collider->shape.get());
    self_->world.addCollisionObject(collider->object.get(), btBroadphaseProxy::StaticFilter,
                                    btBroadphaseProxy::CharacterFilter | btBroadphaseProxy::DefaultFilter);
    self_->colliders.push_back(std::move(collider));
}

void Walker::clear_colliders() {
    self_->clear();
}
bool Walker::has_colliders() const {
    return !self_->colliders.empty();
}

void Walker::place(const glm::vec3& eye) {
    glm::vec3 centre = eye - self_->eye_offset();
    const btVector3 from = to_bullet(eye), to = to_bullet(eye - glm::vec3(0.0f, 100.0f, 0.0f));
    btCollisionWorld::ClosestRayResultCallback ground(from, to);
    ground.m_collisionFilterGroup = btBroadphaseProxy::CharacterFilter;
    ground.m_collisionFilterMask = btBroadphaseProxy::StaticFilter;
    self_->world.rayTest(from, to, ground);
    if (ground.hasHit()) centre.y = ground.m_hitPointWorld.y() + 0.5f * self_->body.height_m + 0.02f;
    self_->controller->warp(to_bullet(centre));
    self_->controller->setLinearVelocity({0.0f, 0.0f, 0.0f});
    self_->controller->reset(&self_->world);
}

glm::vec3 Walker::walk(const glm::vec3& velocity, float seconds) {
    const int steps = std::clamp(static_cast<int>(seconds / kStep + 0.5f), 1, 60);
    const float dt = seconds / static_cast<float>(steps);
    self_->controller->setWalkDirection(to_bullet(glm::vec3(velocity.x, 0.0f, velocity.z) * dt));
    for (int i = 0; i < steps; ++i) self_->world.stepSimulation(dt, 1, dt);
    return self_->eye();
}

void Walker::jump() {
    if (self_->controller->onGround()) self_->controller->jump();
}

glm::vec3 Walker::fly(const glm::vec3& eye, const glm::vec3& displacement) const {
    glm::vec3 at = eye;
    glm::vec3 left = displacement;
    for (int slide = 0; slide < 3 && glm::dot(left, left) > 1e-10f; ++slide) {
        const btTransform from(btQuaternion::getIdentity(), to_bullet(at)),
            to(btQuaternion::getIdentity(), to_bullet(at + left));
        btCollisionWorld::ClosestConvexResultCallback hit(from.getOrigin(), to.getOrigin());
        hit.m_collisionFilterGroup = btBroadphaseProxy::CharacterFilter;
        hit.m_collisionFilterMask = btBroadphaseProxy::StaticFilter;
        self_->world.convexSweepTest(&self_->sphere, from, to, hit);
        if (!hit.hasHit()) return at + left;
        const float travelled = std::max(0.0f, hit.m_closestHitFraction - 1e-3f);
        const glm::vec3 normal = from_bullet(hit.m_hitNormalWorld);
        at += left * travelled;
        left *= 1.0f - travelled;
        left -= normal * std::min(0.0f, glm::dot(left, normal));
    }
    return at;
}

}  // namespace tyndall
