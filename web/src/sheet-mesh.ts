import { ShapeUtils, Vector2 } from 'three';
import { shareOf, transformsAt, transformsHolding, unit, type Share } from './folding.ts';
import { insideFacet } from './facet.ts';
import { featureOfEdge } from './lines.ts';
import type { Shape } from './types.ts';

/**
 * The parts of a shape that do not change during folding: triangles, rim and lines over *corners*, points of the flat
 * pattern on one facet each. Corners on hinges are mitred, so that the skins of neighbouring facets meet.
 */
export interface SheetMesh {
  shape: Shape;
  corners: Float32Array; // x, y in the flat pattern
  cornerFacet: Uint32Array;
  mitreStarts: Uint32Array; // of corner c: mitres mitreStarts[c] … mitreStarts[c+1]−1
  mitreHinge: Uint32Array; // facet whose hinge it is
  mitreSign: Int8Array; // −1: towards the parent, 1: towards the child
  triangles: Uint32Array; // of the upper skin
  triangleFacet: Uint32Array;
  rim: Uint32Array; // pairs of corners by edge, in the direction of the cut
  cuts: Uint32Array; // of these, what is cut
  forms: Uint32Array; // of these, outlines of formed features
  hinges: Uint32Array; // pairs of corners: all hinges but those within a curved bend
  creases: Uint32Array; // of these, where bends begin and end and what is folded sharply, and bend lines
}

export interface FoldedSheet {
  positions: Float32Array;
  normals: Float32Array;
}

const smoothBelow = 0.45; // radians: hinges that turn less are shaded as one curved surface

export function makeSheetMesh(shape: Shape): SheetMesh {
  const builder = new Builder(shape);
  const facets = shape.facet_parent.length;
  for (let f = 0; f < facets; ++f)
    for (let p = shape.facet_starts[f]!; p < shape.facet_starts[f + 1]!; ++p) builder.addPolygon(f, p);
  for (let e = 0; e < shape.edge_facet.length; ++e) builder.addEdge(e);
  for (let f = 0; f < facets; ++f) builder.addHinge(f);
  builder.addBendLines();
  return builder.finish();
}

class Builder {
  private readonly corners: number[] = [];
  private readonly facet: number[] = [];
  private readonly triangles: number[] = [];
  private readonly triangleFacet: number[] = [];
  private readonly rim: number[] = [];
  private readonly cuts: number[] = [];
  private readonly forms: number[] = [];
  private readonly hinges: number[] = [];
  private readonly creases: number[] = [];

  private readonly shape: Shape;
  constructor(shape: Shape) {
    this.shape = shape;
  }

  addPolygon(facet: number, polygon: number) {
    const { polygon_starts, ring_starts, points } = this.shape;
    const base = this.facet.length;
    const rings: Vector2[][] = [];
    for (let r = polygon_starts[polygon]!; r < polygon_starts[polygon + 1]!; ++r) {
      const ring: Vector2[] = [];
      for (let i = ring_starts[r]!; i < ring_starts[r + 1]!; ++i) {
        this.corner(facet, points[2 * i]!, points[2 * i + 1]!);
        ring.push(new Vector2(points[2 * i]!, points[2 * i + 1]!));
      }
      rings.push(ring);
    }
    const outer = rings[0];
    if (!outer || outer.length < 3) return;
    const simple = rings.length === 1 && outer.length <= 4 && convex(outer);
    const list = simple ? fan(outer.length) : ShapeUtils.triangulateShape(outer, rings.slice(1));
    for (const [a, b, c] of list as [number, number, number][]) {
      this.triangles.push(base + a, base + b, base + c);
      this.triangleFacet.push(facet);
    }
  }

  addEdge(e: number) {
    const { edges, edge_facet, edge_number } = this.shape;
    const f = edge_facet[e]!;
    const pair = [
      this.corner(f, edges[4 * e]!, edges[4 * e + 1]!),
      this.corner(f, edges[4 * e + 2]!, edges[4 * e + 3]!),
    ];
    this.rim.push(...pair);
    (featureOfEdge(this.shape, edge_number[e]!) === null ? this.cuts : this.forms).push(...pair);
  }

  addHinge(f: number) {
    const { facet_parent, facet_part, facet_angle, facet_hinge: h } = this.shape;
    const parent = facet_parent[f]!;
    if (parent < 0) return;
    const isBend = (part: number) => this.shape.parts[part]?.kind === 'bend';
    const own = facet_part[f]!,
      other = facet_part[parent]!,
      sharp = Math.abs(facet_angle[f]!) >= smoothBelow;
    if (own === other && isBend(own) && !sharp) return;
    const pair = [this.corner(f, h[4 * f]!, h[4 * f + 1]!), this.corner(f, h[4 * f + 2]!, h[4 * f + 3]!)];
    this.hinges.push(...pair);
    if (sharp || (own !== other && (isBend(own) || isBend(other)))) this.creases.push(...pair);
  }

  /** Where the press brake strikes, on the facets of the bend that the lines run over. */
  addBendLines() {
    const { bend_lines: l, bend_line_part, facet_part } = this.shape,
      facets = new Map<number, number[]>();
    facet_part.forEach((part, f) => {
      if (this.shape.parts[part]?.kind === 'bend') facets.set(part, [...(facets.get(part) ?? []), f]);
    });
    bend_line_part.forEach((part, i) => {
      const x = (l[4 * i]! + l[4 * i + 2]!) / 2,
        y = (l[4 * i + 1]! + l[4 * i + 3]!) / 2;
      const f = facets.get(part)?.find((g) => insideFacet(this.shape, g, x, y));
      if (f !== undefined)
        this.creases.push(this.corner(f, l[4 * i]!, l[4 * i + 1]!), this.corner(f, l[4 * i + 2]!, l[4 * i + 3]!));
    });
  }

  finish(): SheetMesh {
    const hinges = hingesByFacet(this.shape);
    const tolerance = 1e-4 + 1e-6 * extent(this.corners);
    const starts = [0],
      mitreHinge: number[] = [],
      mitreSign: number[] = [];
    for (let c = 0; c < this.facet.length; ++c) {
      const f = this.facet[c]!;
      for (const hinge of hinges[f]!) {
        if (!onHinge(this.shape.facet_hinge, hinge, this.corners[2 * c]!, this.corners[2 * c + 1]!, tolerance))
          continue;
        mitreHinge.push(hinge);
        mitreSign.push(hinge === f ? -1 : 1);
      }
      starts.push(mitreHinge.length);
    }
    return {
      shape: this.shape,
      corners: Float32Array.from(this.corners),
      cornerFacet: Uint32Array.from(this.facet),
      mitreStarts: Uint32Array.from(starts),
      mitreHinge: Uint32Array.from(mitreHinge),
      mitreSign: Int8Array.from(mitreSign),
      triangles: Uint32Array.from(this.triangles),
      triangleFacet: Uint32Array.from(this.triangleFacet),
      rim: Uint32Array.from(this.rim),
      cuts: Uint32Array.from(this.cuts),
      forms: Uint32Array.from(this.forms),
      hinges: Uint32Array.from(this.hinges),
      creases: Uint32Array.from(this.creases),
    };
  }

  private corner(facet: number, x: number, y: number): number {
    this.corners.push(x, y);
    this.facet.push(facet);
    return this.facet.length - 1;
  }
}

function fan(n: number): number[][] {
  return n === 3
    ? [[0, 1, 2]]
    : [
        [0, 1, 2],
        [0, 2, 3],
      ];
}

function convex(ring: Vector2[]): boolean {
  return ring.every((b, i) => {
    const a = ring[(i + ring.length - 1) % ring.length]!,
      c = ring[(i + 1) % ring.length]!;
    return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x) >= 0;
  });
}

function hingesByFacet(shape: Shape): number[][] {
  const out: number[][] = Array.from(shape.facet_parent, () => []);
  shape.facet_parent.forEach((parent, f) => {
    if (parent < 0) return;
    out[f]!.push(f);
    out[parent]!.push(f);
  });
  return out;
}

function onHinge(hinge: Float32Array, f: number, x: number, y: number, tolerance: number): boolean {
  const px = hinge[4 * f]!,
    py = hinge[4 * f + 1]!,
    dx = hinge[4 * f + 2]! - px,
    dy = hinge[4 * f + 3]! - py;
  const l = Math.hypot(dx, dy);
  if (l === 0) return false;
  const along = ((x - px) * dx + (y - py) * dy) / l,
    across = ((x - px) * dy - (y - py) * dx) / l;
  return Math.abs(across) <= tolerance && along >= -tolerance && along <= l + tolerance;
}

function extent(values: number[]): number {
  let most = 0;
  for (const v of values) most = Math.max(most, Math.abs(v));
  return most;
}

/** How a sheet is folded and where it lies: facet `held` at a matrix, row by row. */
export interface Pose {
  share: Share;
  held: number;
  at: ArrayLike<number>;
}

/**
 * Both skins at share `s` of the fold: the upper one's corners, then the lower one's, `thickness` apart; facet `held`
 * stays in place.
 */
export const foldSheet = (
  mesh: SheetMesh,
  share: number,
  thickness: number,
  held = 0,
  into?: FoldedSheet,
): FoldedSheet => skinsOf(mesh, transformsHolding(mesh.shape, share, held), share, thickness, into);

/** The same in a pose of its own. */
export const poseSheet = (
  mesh: SheetMesh,
  { share, held, at }: Pose,
  thickness: number,
  into?: FoldedSheet,
): FoldedSheet => skinsOf(mesh, transformsAt(mesh.shape, share, held, at), share, thickness, into);

/** `into`: arrays to write to, if they have the length. */
function skinsOf(
  mesh: SheetMesh,
  transforms: Float64Array,
  share: Share,
  thickness: number,
  into?: FoldedSheet,
): FoldedSheet {
  const { corners, cornerFacet, shape } = mesh;
  const slopes = mitreSlopes(shape, share);
  const count = cornerFacet.length,
    half = thickness / 2;
  const fits = into?.positions.length === 6 * count,
    positions = fits ? into.positions : new Float32Array(6 * count),
    normals = fits ? into.normals : new Float32Array(6 * count);
  for (let c = 0; c < count; ++c) {
    const o = 16 * cornerFacet[c]!;
    let mx = 0,
      my = 0,
      nx = 0,
      ny = 0;
    for (let m = mesh.mitreStarts[c]!; m < mesh.mitreStarts[c + 1]!; ++m) {
      const h = mesh.mitreHinge[m]!,
        sign = mesh.mitreSign[m]!,
        x = sign * slopes[2 * h]!,
        y = sign * slopes[2 * h + 1]!;
      mx += x;
      my += y;
      if (Math.abs(shape.facet_angle[h]!) < smoothBelow) {
        nx += x;
        ny += y;
      }
    }
    const x = corners[2 * c]!,
      y = corners[2 * c + 1]!,
      length = Math.hypot(nx, ny, 1);
    for (let row = 0; row < 3; ++row) {
      const t = o + 4 * row,
        a = transforms[t]!,
        b = transforms[t + 1]!,
        e = transforms[t + 2]!;
      const at = a * x + b * y + transforms[t + 3]!,
        off = half * (a * mx + b * my + e),
        n = (a * nx + b * ny + e) / length;
      positions[3 * c + row] = at + off;
      positions[3 * (count + c) + row] = at - off;
      normals[3 * c + row] = n;
      normals[3 * (count + c) + row] = -n;
    }
  }
  return { positions, normals };
}

/**
 * For each facet's hinge the step, in the facet's plane and for a unit of height, from its edge to the mitre with the
 * child.
 */
function mitreSlopes(shape: Shape, share: Share): Float64Array {
  const out = new Float64Array(2 * shape.facet_parent.length);
  for (let f = 0; f < shape.facet_parent.length; ++f) {
    const h = shape.facet_hinge,
      angle = shareOf(share, f) * shape.facet_angle[f]!;
    const [ux, uy] = unit(h[4 * f + 2]! - h[4 * f]!, h[4 * f + 3]! - h[4 * f + 1]!);
    const t = Math.max(-1.5, Math.min(1.5, Math.tan(angle / 2)));
    out[2 * f] = uy * t;
    out[2 * f + 1] = -ux * t;
  }
  return out;
}
