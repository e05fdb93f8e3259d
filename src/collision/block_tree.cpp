#include "block_tree.hpp"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>

#include <cstdint>
#include <cstdlib>

namespace planish::collision_detail {
namespace {

using Object = fcl::CollisionObjectd;

/// A hull for which FCL needs no faces: it asks for the farthest corner in a direction only.
std::unique_ptr<Object> hull(const std::vector<Vec3>& corners, int number) {
  const auto no_faces = std::make_shared<const std::vector<int>>();
  auto object = std::make_unique<Object>(std::make_shared<fcl::Convexd>(
      std::make_shared<const std::vector<Vec3>>(corners), 0, no_faces));
  // NOLINTNEXTLINE(performance-no-int-to-ptr): a number, kept where FCL has room for it
  object->setUserData(reinterpret_cast<void*>(static_cast<std::intptr_t>(number)));
  return object;
}

int number_of(const Object* object) {
  return static_cast<int>(reinterpret_cast<std::intptr_t>(object->getUserData()));
}

Box3 object_box(const Object* object) { return {object->getAABB().min_, object->getAABB().max_}; }

struct BlockPairs {
  int apart = 0;  ///< blocks whose numbers differ by less are not tested
  Box3 found;
};

bool test(Object* a, Object* b, void* data) {
  auto& pairs = *static_cast<BlockPairs*>(data);
  if (std::abs(number_of(a) - number_of(b)) < pairs.apart) return false;
  fcl::CollisionResultd result;
  if (fcl::collide(a, b, fcl::CollisionRequestd(), result) > 0)
    pairs.found.extend(object_box(a).intersection(object_box(b)));
  return false;  // go on
}

}  // namespace

struct BlockTree::Model {
  std::vector<std::unique_ptr<Object>> objects;
  mutable fcl::DynamicAABBTreeCollisionManagerd manager;
};

BlockTree::BlockTree(const std::vector<std::vector<Vec3>>& blocks)
    : model_(std::make_unique<Model>()) {
  std::vector<Object*> registered;
  for (const auto& block : blocks) {
    model_->objects.push_back(hull(block, static_cast<int>(registered.size())));
    registered.push_back(model_->objects.back().get());
  }
  if (registered.empty()) return;
  model_->manager.registerObjects(registered);
  model_->manager.setup();
}

BlockTree::~BlockTree() = default;
BlockTree::BlockTree(BlockTree&&) noexcept = default;
BlockTree& BlockTree::operator=(BlockTree&&) noexcept = default;

Box3 BlockTree::meetings(const BlockTree& other) const {
  BlockPairs pairs;
  if (!model_->objects.empty() && !other.model_->objects.empty())
    model_->manager.collide(&other.model_->manager, &pairs, test);
  return pairs.found;
}

Box3 BlockTree::own_meetings() const {
  BlockPairs pairs{.apart = 2, .found = {}};
  if (!model_->objects.empty()) model_->manager.collide(&pairs, test);
  return pairs.found;
}

}  // namespace planish::collision_detail
