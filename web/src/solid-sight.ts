import { namedPieces, pointOf, type NamedPiece, type NamedPlaces, type Solid } from './solid-mesh.ts';
import type { Vec3 } from './types.ts';
import { cross, dot, minus, normalised } from './vectors.ts';

const samples = 8; // pieces of a face or an edge
const enough = 0.7; // of what the best direction shows: a little more is no reason to turn the part

/** The first of several directions towards the eye from which what is named is well seen, the solid not before it. */
export function directionThatShows(shape: Solid, named: NamedPlaces, directions: Vec3[]): Vec3 {
  const pieces = namedPieces(shape, named).flatMap((own) => own.slice(0, samples)),
    reach = extent(shape),
    seen = directions.map(normalised).map((towards) => {
      let sum = 0;
      for (const piece of pieces) if (!isHidden(shape, piece, towards, reach)) sum += shownSize(piece, towards);
      return sum;
    });
  const least = enough * Math.max(...seen);
  return directions[seen.findIndex((s) => s >= least)]!;
}

/** Of a face as much as is turned to the eye. */
const shownSize = ({ normal, size }: NamedPiece, towards: Vec3) => (normal ? Math.max(0, dot(normal, towards)) : size);

/** Whether another triangle lies before a piece. */
function isHidden(shape: Solid, { middle, normal }: NamedPiece, towards: Vec3, reach: number): boolean {
  if (normal && dot(normal, towards) <= 0) return true;
  const { space_triangles: t } = shape,
    beside = 1e-6 * reach;
  for (let i = 0; i < t.length; i += 3) {
    const a = pointOf(shape, t[i]!),
      u = minus(pointOf(shape, t[i + 1]!), a),
      v = minus(pointOf(shape, t[i + 2]!), a),
      across = cross(towards, v),
      scale = dot(u, across);
    if (Math.abs(scale) <= 1e-9 * Math.hypot(...u) * Math.hypot(...v)) continue;
    const from = minus(middle, a),
      x = dot(from, across) / scale,
      turned = cross(from, u),
      y = dot(towards, turned) / scale;
    if (x >= 0 && y >= 0 && x + y <= 1 && dot(v, turned) / scale > beside) return true;
  }
  return false;
}

/** The longest way through the box of a solid. */
function extent({ space_points: p }: Solid): number {
  const range = [0, 1, 2].map((k) => {
    let [low, high] = [Infinity, -Infinity];
    for (let i = k; i < p.length; i += 3) {
      low = Math.min(low, p[i]!);
      high = Math.max(high, p[i]!);
    }
    return high - low;
  });
  return Math.hypot(...range);
}
