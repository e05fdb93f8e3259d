#pragma once

#include <planish/base/result.hpp>
#include <planish/brake/codes.hpp>
#include <planish/job/codes.hpp>
#include <planish/sheet/codes.hpp>
#include <planish/slit/codes.hpp>

/// The sentences with which `job` refuses.
namespace planish::refuse {

constexpr Refusal overlap_too_large{
    code::overlap,
    "{@part} overlap by {area}, {depth} deep. Corners are mended up to {most_area} and "
    "{most_depth}."};
constexpr Refusal relief_parts_sheet{code::unsupported_shape, "A relief parts the sheet."};
constexpr Refusal volume_wrong{
    code::pattern_wrong,
    "Flat area at K = ½ times thickness is {ratio} of the solid's volume (1 is right, {allowed} is "
    "the most it may be off). The pattern cannot be trusted and is not written."};
constexpr Refusal length_wrong{
    code::pattern_wrong,
    "An edge of the solid and its image in the pattern differ in length by {off}. The pattern "
    "cannot be trusted and is not written."};
constexpr Refusal refold_wrong{
    code::pattern_wrong,
    "The refolded contour leaves the solid's edge by {off}. The pattern cannot be trusted and is "
    "not written."};

}  // namespace planish::refuse
