#include "render/passes/lock_order.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

namespace kaori::passes {
namespace {

// Which lock each vertex belongs to: what triangles join hangs together.
class Locks {
 public:
  // Corners of a triangle are of one lock.
  explicit Locks(const face::Prop& prop) : parent_(prop.vertices.size()) {
    std::iota(parent_.begin(), parent_.end(), 0U);
    for (const face::Triangle& t : prop.triangles) {
      parent_[Root(t[1])] = Root(t[0]);
      parent_[Root(t[2])] = Root(t[0]);
    }
  }

  // Spread over 0..1 by the golden ratio, so that neighbours differ.
  float NumberOf(std::uint32_t vertex) {
    const float spread = static_cast<float>(Root(vertex)) * 0.6180340F;
    return spread - std::floor(spread);
  }

 private:
  // Union-find with path halving (Tarjan and van Leeuwen 1984).
  std::uint32_t Root(std::uint32_t v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }
  std::vector<std::uint32_t> parent_;
};

}  // namespace

std::vector<float> LockNumbers(const face::Prop& hair) {
  Locks locks(hair);
  std::vector<float> numbers(hair.vertices.size());
  for (std::uint32_t v = 0; v < numbers.size(); ++v) numbers[v] = locks.NumberOf(v);
  return numbers;
}

// A stable sort by the lock's reach keeps each lock's triangles in their order.
LockOrder OuterLocksFirst(const face::Prop& hair, const std::vector<float>& numbers) {
  glm::vec3 middle{};
  for (const face::PropVertex& v : hair.vertices)
    middle += v.position / static_cast<float>(hair.vertices.size());
  struct Lock {
    float reach = 0;     // Its farthest point from the middle, square metres.
    float forwards = 0;  // The sum of how far its points lie before the middle, metres.
  };
  std::map<float, Lock> locks;
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    const glm::vec3 away = hair.vertices[v].position - middle;
    Lock& lock = locks[numbers[v]];
    lock.reach = std::max(lock.reach, away.x * away.x + away.z * away.z);
    lock.forwards += away.z;
  }
  LockOrder order{hair.triangles, 0};
  const auto lock_of = [&](const face::Triangle& t) -> const Lock& { return locks[numbers[t[0]]]; };
  std::ranges::stable_sort(order.triangles, std::ranges::greater{},
                           [&](const face::Triangle& t) { return lock_of(t).reach; });
  const auto behind =
      std::stable_partition(order.triangles.begin(), order.triangles.end(),
                            [&](const face::Triangle& t) { return lock_of(t).forwards >= 0; });
  order.behind_from = static_cast<std::size_t>(behind - order.triangles.begin());
  return order;
}

}  // namespace kaori::passes
