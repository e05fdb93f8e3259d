import type { SheetMesh } from './sheet-mesh.ts';
import type { Vec3 } from './types.ts';

/** What is cut away lies where normal · p + constant < 0, as three.js has planes. */
export interface Cut {
  normal: Vec3;
  constant: number;
}

/** The plane across a direction at a share of what lies along it; the other side of it if `flipped`. */
export function cutAt(positions: Float32Array, along: Vec3, share: number, flipped: boolean): Cut {
  const [low, high] = extentAlong(positions, along),
    at = low + share * (high - low);
  // what lies beyond the plane goes
  return flipped ? { normal: along, constant: -at } : { normal: along.map((v) => -v) as Vec3, constant: at };
}

/** From where to where places lie along a direction. */
export function extentAlong(positions: Float32Array, along: Vec3): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (let i = 0; i < positions.length; i += 3) {
    const d = along[0] * positions[i]! + along[1] * positions[i + 1]! + along[2] * positions[i + 2]!;
    low = Math.min(low, d);
    high = Math.max(high, d);
  }
  return [low, high];
}

export const isKept = ({ normal: [a, b, c], constant }: Cut, x: number, y: number, z: number): boolean =>
  a * x + b * y + c * z + constant >= -1e-6;

/** Pairs of corners of the prism between both skins of a triangle: upper, lower, posts. */
const sides = [0, 1, 1, 2, 2, 0, 3, 4, 4, 5, 5, 3, 0, 3, 1, 4, 2, 5];

/**
 * The material in a plane, as triangles: where it runs through the prisms between both skins. `positions`: the upper
 * skin's corners, then the lower one's.
 */
export function capOf({ triangles, cornerFacet }: SheetMesh, positions: Float32Array, cut: Cut): Float32Array {
  const n = cornerFacet.length,
    off = new Float64Array(2 * n),
    out: number[] = [];
  for (let c = 0; c < 2 * n; ++c) off[c] = distanceOf(cut, positions, c);
  const six = new Uint32Array(6),
    order = acrossOf(cut.normal);
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; ++k) six[k + 3] = (six[k] = triangles[t + k]!) + n;
    const first = off[six[0]!]! >= 0;
    if (six.every((c) => off[c]! >= 0 === first)) continue;
    fan(sectionOf(six, off, positions), order, out);
  }
  return Float32Array.from(out);
}

const distanceOf = ({ normal, constant }: Cut, p: Float32Array, c: number) =>
  normal[0] * p[3 * c]! + normal[1] * p[3 * c + 1]! + normal[2] * p[3 * c + 2]! + constant;

function sectionOf(six: Uint32Array, off: Float64Array, p: Float32Array): Vec3[] {
  const points: Vec3[] = [];
  for (let s = 0; s < sides.length; s += 2) {
    const [a, b] = [six[sides[s]!]!, six[sides[s + 1]!]!],
      [da, db] = [off[a]!, off[b]!];
    if (da >= 0 === db >= 0) continue;
    const t = da / (da - db);
    points.push([0, 1, 2].map((k) => p[3 * a + k]! + t * (p[3 * b + k]! - p[3 * a + k]!)) as Vec3);
  }
  return points;
}

/** Two directions in the plane. */
function acrossOf([x, y, z]: Vec3): [Vec3, Vec3] {
  const u: Vec3 = Math.abs(z) < 0.9 ? [-y, x, 0] : [0, -z, y];
  return [u, [y * u[2] - z * u[1], z * u[0] - x * u[2], x * u[1] - y * u[0]]];
}

/** A convex polygon, whose corners come in any order, as triangles. */
function fan(points: Vec3[], [u, v]: [Vec3, Vec3], out: number[]) {
  if (points.length < 3) return;
  const middle = [0, 1, 2].map((k) => points.reduce((sum, p) => sum + p[k]!, 0) / points.length);
  const angle = (p: Vec3) => {
    const d = p.map((x, k) => x - middle[k]!);
    return Math.atan2(d[0]! * v[0] + d[1]! * v[1] + d[2]! * v[2], d[0]! * u[0] + d[1]! * u[1] + d[2]! * u[2]);
  };
  const ring = points.map((p) => ({ p, a: angle(p) })).sort((p, q) => p.a - q.a);
  for (let i = 1; i + 1 < ring.length; ++i) out.push(...ring[0]!.p, ...ring[i]!.p, ...ring[i + 1]!.p);
}
