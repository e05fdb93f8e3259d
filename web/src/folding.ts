import type { Facets, Vec3 } from './types.ts';

export type FacetTree = Pick<Facets, 'facet_parent' | 'facet_hinge' | 'facet_angle'> & { root: number[] };

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** By how much of its angle each facet is turned: all by as much, or each by its own share. */
export type Share = number | ArrayLike<number>;

export const shareOf = (share: Share, facet: number): number => (typeof share === 'number' ? share : share[facet]!);

/**
 * For each facet the 4×4 matrix, row by row, that takes the flat pattern (z = 0) to where the facet lies when every
 * bend is turned by `share` of its angle. At 0 the whole pattern lies in the root facet's plane. Parents come before
 * children.
 */
export function facetTransforms(tree: FacetTree, share: Share): Float64Array {
  const count = tree.facet_parent.length;
  const out = new Float64Array(16 * count);
  const root = tree.root.length === 16 ? tree.root : identity;
  for (let f = 0; f < count; ++f) {
    const parent = tree.facet_parent[f]!;
    if (parent < 0) out.set(root, 16 * f);
    else turnAbout(out, 16 * parent, tree.facet_hinge, 4 * f, shareOf(share, f) * tree.facet_angle[f]!, 16 * f);
  }
  return out;
}

/** out[at…] = out[parent…] · rotation by `angle` about the line through two points of the flat pattern. */
function turnAbout(out: Float64Array, parent: number, hinge: Float32Array, h: number, angle: number, at: number) {
  const px = hinge[h]!,
    py = hinge[h + 1]!;
  const [ux, uy] = unit(hinge[h + 2]! - px, hinge[h + 3]! - py);
  const c = Math.cos(angle),
    s = Math.sin(angle),
    d = 1 - c;
  const r00 = c + ux * ux * d,
    r01 = ux * uy * d,
    r02 = uy * s,
    r11 = c + uy * uy * d,
    r12 = -ux * s,
    r20 = -uy * s,
    r21 = ux * s;
  const tx = px - r00 * px - r01 * py,
    ty = py - r01 * px - r11 * py,
    tz = -r20 * px - r21 * py;
  for (let row = 0; row < 4; ++row) {
    const p = parent + 4 * row,
      a = out[p]!,
      b = out[p + 1]!,
      e = out[p + 2]!,
      w = out[p + 3]!,
      o = at + 4 * row;
    out[o] = a * r00 + b * r01 + e * r20;
    out[o + 1] = a * r01 + b * r11 + e * r21;
    out[o + 2] = a * r02 + b * r12 + e * c;
    out[o + 3] = a * tx + b * ty + e * tz + w;
  }
}

export function unit(x: number, y: number): [number, number] {
  const l = Math.hypot(x, y);
  return l > 0 ? [x / l, y / l] : [1, 0];
}

/** The place of a point of the flat pattern, `z` above it, on facet `f`. */
export function place(transforms: Float64Array, f: number, x: number, y: number, z = 0): Vec3 {
  const t = transforms,
    o = 16 * f;
  return [
    t[o]! * x + t[o + 1]! * y + t[o + 2]! * z + t[o + 3]!,
    t[o + 4]! * x + t[o + 5]! * y + t[o + 6]! * z + t[o + 7]!,
    t[o + 8]! * x + t[o + 9]! * y + t[o + 10]! * z + t[o + 11]!,
  ];
}

/**
 * The same, moved so that facet `held` is where it is when all is folded: another facet than the root stays in place.
 */
export function transformsHolding(tree: FacetTree, share: number, held: number): Float64Array {
  if (held <= 0 || held >= tree.facet_parent.length || share === 1) return facetTransforms(tree, share);
  return transformsAt(tree, share, held, facetTransforms(tree, 1).subarray(16 * held, 16 * held + 16));
}

/** The same, moved so that facet `held` lies where a matrix has it. */
export function transformsAt(tree: FacetTree, share: Share, held: number, at: ArrayLike<number>): Float64Array {
  const out = facetTransforms(tree, share);
  if (tree.facet_parent.length === 0) return out;
  const moved = product(at, 0, inverse(out, 16 * held), 0);
  for (let f = 0; f < tree.facet_parent.length; ++f) out.set(product(moved, 0, out, 16 * f), 16 * f);
  return out;
}

/** Of 4×4 matrices, row by row, that begin at `i` and `j`. */
export function product(a: ArrayLike<number>, i: number, b: ArrayLike<number>, j: number): number[] {
  return Array.from({ length: 16 }, (_, n) => {
    const row = i + 4 * Math.floor(n / 4),
      column = j + (n % 4);
    return (
      a[row]! * b[column]! + a[row + 1]! * b[column + 4]! + a[row + 2]! * b[column + 8]! + a[row + 3]! * b[column + 12]!
    );
  });
}

/** Of a rigid motion. */
export function inverse(m: ArrayLike<number>, o: number): number[] {
  const at = (r: number, c: number) => m[o + 4 * r + c]!;
  const out = [...identity];
  for (let r = 0; r < 3; ++r) {
    for (let c = 0; c < 3; ++c) out[4 * r + c] = at(c, r);
    out[4 * r + 3] = -(at(0, r) * at(0, 3) + at(1, r) * at(1, 3) + at(2, r) * at(2, 3));
  }
  return out;
}
