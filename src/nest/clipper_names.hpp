#pragma once

#include <polyclipping/clipper.hpp>

namespace planish::nest_detail {

using ClipperLib::cInt;
using ClipperLib::IntPoint;
using ClipperLib::Path;
using ClipperLib::Paths;

}  // namespace planish::nest_detail
