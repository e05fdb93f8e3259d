#pragma once

#include <planish/sheet/sheet.hpp>

#include <map>
#include <tuple>
#include <vector>

namespace planish {

/// Whether a bend is drawn as a fold: sharp, or of an inside radius that nobody can see.
bool is_fold(const Bend& bend);

/// How far beyond the borders at which folds join flanges the line lies where the middle surfaces
/// meet, mm; by face, loop and border, for these borders alone.
using ToFoldLines = std::map<std::tuple<int, int, int>, double>;
ToFoldLines distances_to_fold_lines(const Sheet& sheet);

/// The curves of a loop, with straight borders at folds moved to their lines. The straight borders
/// beside them go on to it, or end there; where these run along the fold, it ends in a step.
std::vector<Curve2> drawn_to_fold_lines(const Sheet& sheet, FaceId face, int loop,
                                        const ToFoldLines& distances);

/// Corners without those where the outline runs on, or runs back over itself.
std::vector<Vec2> without_runs(std::vector<Vec2> corners, double chord);

}  // namespace planish
