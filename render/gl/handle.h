// One GL object with one owner; deleted when the owner goes.
#pragma once

#include <utility>

namespace kaori::gl {

// A number that GL gave, with the function that gives it back. Moves, and does not copy. Must be dropped
// while its context is current.
class Handle {
 public:
  using Delete = void (*)(unsigned);

  Handle() = default;
  // Takes the object over; `destroy` is called once, with `id`, unless that is 0.
  Handle(unsigned id, Delete destroy) : id_(id), destroy_(destroy) {}
  // The other is left without an object.
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, 0)), destroy_(other.destroy_) {}
  // The objects change places; the old one goes with `other`.
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(destroy_, other.destroy_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_ != 0) destroy_(id_);
  }

  // 0: no object.
  unsigned id() const { return id_; }

 private:
  unsigned id_ = 0;
  Delete destroy_ = nullptr;
};

}  // namespace kaori::gl
