#include <planish/brake/tools.hpp>

namespace planish {

Result<void> check(const BrakeTools&) { return {}; }

}  // namespace planish
