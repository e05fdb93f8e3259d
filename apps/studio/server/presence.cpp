#include "presence.hpp"

namespace planish::studio {

void Presence::arrive() {
  const std::lock_guard lock(mutex_);
  ++open_;
}

void Presence::leave() {
  const std::lock_guard lock(mutex_);
  --open_;
  since_ = Clock::now();
}

Presence::Clock::duration Presence::absence() const {
  const std::lock_guard lock(mutex_);
  return open_ > 0 ? Clock::duration::zero() : Clock::now() - since_;
}

}  // namespace planish::studio
