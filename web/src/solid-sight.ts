import { namedPieces, type NamedPiece, type NamedPlaces, type Solid } from './solid-mesh.ts';
import { weightsUnder } from './triangle-under.ts';
import type { Vec3 } from './types.ts';
import { cross, dot, normalised, plus, scaled } from './vectors.ts';

const samples = 8; // pieces of a face or an edge
const enough = 0.7; // of what the best direction shows: a little more is no reason to turn the part

/**
 * The first of several directions towards the eye from which what is named is well seen, the solid not before it: if
 * some of it is hidden from all of them, one of `others` that shows more.
 */
export function directionThatShows(shape: Solid, named: NamedPlaces, directions: Vec3[], others: Vec3[] = []): Vec3 {
  const all = namedPieces(shape, named).map((own) => own.slice(0, samples)),
    first = best(shape, all, directions);
  if (first.names === all.length || !others.length) return first.direction;
  const other = best(shape, all, others);
  return other.names > first.names ? other.direction : first.direction;
}

/** Of directions that show as many names as any does, the first that shows enough of them. */
function best(shape: Solid, all: NamedPiece[][], directions: Vec3[]) {
  const seen = directions.map((direction) => {
    const towards = normalised(direction),
      hides = hiding(shape, towards),
      sizes = all.map((own) => own.reduce((sum, piece) => sum + shownSize(piece, towards, hides), 0));
    return { direction, names: sizes.filter((s) => s > 0).length, size: sizes.reduce((sum, s) => sum + s, 0) };
  });
  const names = Math.max(...seen.map((s) => s.names)),
    most = seen.filter((s) => s.names === names),
    least = enough * Math.max(...most.map((s) => s.size));
  return most.find((s) => s.size >= least)!;
}

/** As much of a piece as is turned to the eye, by those of its places that are seen. */
function shownSize(piece: NamedPiece, towards: Vec3, hides: (at: Vec3) => boolean): number {
  const size = piece.normal ? Math.abs(dot(piece.normal, towards)) : piece.size;
  if (size <= 1e-9 * piece.size) return 0;
  const places = placesOn(piece);
  return (size * places.filter((at) => !hides(at)).length) / places.length;
}

/** Its middle, and a place towards each of its corners. */
export const placesOn = ({ middle, corners }: NamedPiece): Vec3[] => [
  middle,
  ...corners.map((c) => plus(scaled(c, 0.7), scaled(middle, 0.3))),
];

/** What tells whether the solid, seen along parallels, lies before a place. */
export function hiding({ space_points: p, space_triangles: t }: Solid, towards: Vec3): (at: Vec3) => boolean {
  const right = normalised(cross(Math.abs(towards[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0], towards)),
    up = cross(towards, right),
    s = new Float64Array(p.length);
  let [low, high] = [Infinity, -Infinity];
  for (let i = 0; i < p.length; i += 3) {
    const at: Vec3 = [p[i]!, p[i + 1]!, p[i + 2]!];
    s[i] = dot(at, right);
    s[i + 1] = dot(at, up);
    s[i + 2] = dot(at, towards);
    for (let k = i; k < i + 3; ++k) [low, high] = [Math.min(low, s[k]!), Math.max(high, s[k]!)];
  }
  const beside = 1e-6 * (high - low); // of points in single precision
  return (at) => {
    const x = dot(at, right),
      y = dot(at, up),
      before = dot(at, towards) + beside;
    for (let i = 0; i < t.length; i += 3) {
      const a = 3 * t[i]!,
        b = 3 * t[i + 1]!,
        c = 3 * t[i + 2]!;
      if (s[a + 2]! <= before && s[b + 2]! <= before && s[c + 2]! <= before) continue;
      const under = weightsUnder(s, a, b, c, x, y);
      if (!under) continue;
      const [u, v, w] = under;
      if (u * s[a + 2]! + v * s[b + 2]! + w * s[c + 2]! > before) return true;
    }
    return false;
  };
}
