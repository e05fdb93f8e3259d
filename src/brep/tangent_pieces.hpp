#pragma once

#include "assembly.hpp"

namespace planish::brep {

// What is cut of an opening across a tangent line: its parts over the flange and over the bend.

/// Sets what is cut to a section, a closed chain of edges of the solid; returns whether it crosses
/// the tangent line just once each way. `across`: the flange and the bend (tangent_runs.hpp).
bool divide(const Recognition& of, TangentOpening& opening, const Frame& across,
            const std::vector<CoEdge>& section);

/// Sets what is cut to what all edges of the opening's walls leave open round the middle of what is
/// cut now, if that is narrower: beside a drill that stands over the bend the wall is innermost now
/// at one of its ends, now at the other. Nothing changes where that is not seen whole from there.
void narrow_to_cell(const Recognition& of, TangentOpening& opening, const Frame& across);

}  // namespace planish::brep
