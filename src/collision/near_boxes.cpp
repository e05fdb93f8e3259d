#include "triangle_tree.hpp"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision_object.h>

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

namespace planish::collision_detail {
namespace {

using Object = fcl::CollisionObjectd;

struct Found {
  std::map<const Object*, int> number;
  std::vector<std::pair<int, int>> pairs;
};

bool note(Object* a, Object* b, void* data) {
  auto& found = *static_cast<Found*>(data);
  found.pairs.emplace_back(std::minmax(found.number.at(a), found.number.at(b)));
  return false;  // go on
}

}  // namespace

std::vector<std::pair<int, int>> near_boxes(const std::vector<Box3>& boxes, double reach) {
  Found found;
  std::vector<std::unique_ptr<Object>> objects;
  std::vector<Object*> registered;
  for (const Box3& box : boxes) {
    const Vec3 size = box.sizes() + Vec3::Constant(reach);
    objects.push_back(std::make_unique<Object>(std::make_shared<fcl::Boxd>(size),
                                               Eigen::Matrix3d::Identity(), box.center()));
    found.number.emplace(objects.back().get(), static_cast<int>(found.number.size()));
    registered.push_back(objects.back().get());
  }
  fcl::DynamicAABBTreeCollisionManagerd manager;
  manager.registerObjects(registered);
  manager.setup();
  manager.collide(&found, note);
  std::ranges::sort(found.pairs);  // the order does not depend on addresses
  return std::move(found.pairs);
}

}  // namespace planish::collision_detail
