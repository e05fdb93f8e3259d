#include "exchange_lock.hpp"

namespace planish::brep {

std::unique_lock<std::mutex> exchange_lock() {
  static std::mutex mutex;
  return std::unique_lock(mutex);
}

}  // namespace planish::brep
