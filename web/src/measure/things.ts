import type { BendRow, Shape, Vec2, Vec3 } from '../types.ts';
import { millimetres } from '../units.ts';
import { edgeForms } from './edges.ts';

export type MeasuredView = 'flat' | 'folded';

/** What was picked to measure from or to. `upper`: on which side of the sheet; in the pattern the upper one. */
export type Ref =
  | { kind: 'corner'; edge: number; end: 0 | 1; upper: boolean }
  | { kind: 'middle'; edge: number; upper: boolean }
  | { kind: 'edge'; edge: number; upper: boolean } // straight
  | { kind: 'circle'; edge: number; upper: boolean } // a hole, or an arc: by its centre
  | { kind: 'bend'; part: number; line: number } // in the folded part its axis
  | { kind: 'flange'; part: number; upper: boolean; at: Vec2 }; // where it was picked, in the pattern

/** What that is, in mm: in the pattern (z = 0), or where the folded part has it. */
export type Thing =
  | { type: 'point'; at: Vec3 }
  | { type: 'line'; a: Vec3; b: Vec3 }
  | { type: 'circle'; at: Vec3; normal: Vec3; radius: number; whole: boolean }
  | { type: 'plane'; at: Vec3; normal: Vec3 }; // the normal of the upper side

/** A shape with what its measuring takes from the report. */
export interface Measured {
  shape: Shape;
  thickness: number; // mm
  bends: BendRow[];
  units: 'mm' | 'inch' | 'm' | undefined; // of the bends
}

/** Exactly where it is; null where that is not known exactly, or nowhere. */
export function thingOf(of: Measured, view: MeasuredView, ref: Ref): Thing | null {
  const { shape } = of;
  if (ref.kind === 'bend') return view === 'flat' ? bendLine(shape, ref) : bendAxis(of, ref.part);
  const put = placing(of, view, ref.kind === 'flange' ? ref.part : (edgeForms(shape)[ref.edge]?.part ?? -1), ref.upper);
  if (!put) return null;
  if (ref.kind === 'flange')
    return view === 'flat' ? null : { type: 'plane', at: put(ref.at), normal: direction(put, [0, 0]) };
  const form = edgeForms(shape)[ref.edge]!;
  if (ref.kind === 'circle') {
    if (!form.circle) return null;
    const { centre, radius, whole } = form.circle;
    return { type: 'circle', at: put(centre), normal: direction(put, centre), radius, whole };
  }
  if (!form.ends) return null;
  const [a, b] = form.ends;
  if (ref.kind === 'corner') return { type: 'point', at: put(form.ends[ref.end]) };
  if (!form.straight) return null;
  if (ref.kind === 'middle') return { type: 'point', at: put([(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]) };
  return { type: 'line', a: put(a), b: put(b) };
}

type Put = (p: Vec2, up?: number) => Vec3;

/** From the pattern to where a part is: on one of its sides, or `up` above that. */
function placing({ shape, thickness }: Measured, view: MeasuredView, part: number, upper: boolean): Put | null {
  if (!shape.parts[part]) return null;
  if (view === 'flat') return ([x, y], up = 0) => [x, y, up];
  const m = shape.parts[part]!.place;
  if (!m) return null;
  const side = (upper ? 0.5 : -0.5) * thickness;
  return ([x, y], up = 0) =>
    [0, 4, 8].map((row) => m[row]! * x + m[row + 1]! * y + m[row + 2]! * (side + up) + m[row + 3]!) as Vec3;
}

const direction = (put: Put, at: Vec2): Vec3 => {
  const [from, to] = [put(at), put(at, 1)];
  return to.map((v, k) => v - from[k]!) as Vec3;
};

/** Where a place in space is in the pattern of a flange; null for what has no place of its own. */
export function inPlace({ parts }: Shape, part: number, [x, y, z]: Vec3): Vec2 | null {
  const m = parts[part]?.place;
  if (!m) return null;
  const d = [x - m[3]!, y - m[7]!, z - m[11]!];
  return [0, 1].map((k) => m[k]! * d[0]! + m[4 + k]! * d[1]! + m[8 + k]! * d[2]!) as Vec2;
}

function bendLine(
  { bend_lines: l, bend_line_part }: Shape,
  { part, line }: { part: number; line: number },
): Thing | null {
  if (bend_line_part[line] !== part) return null;
  const [ax, ay, bx, by] = l.subarray(4 * line, 4 * line + 4) as unknown as [number, number, number, number];
  return { type: 'line', a: [ax, ay, 0], b: [bx, by, 0] };
}

/** Of a cylindrical bend, from a flange beside it: above where it begins, by the radius of the sheet's middle. */
function bendAxis(of: Measured, part: number): Thing | null {
  const { shape, thickness, bends, units } = of,
    row = bends.find((b) => b.id === shape.parts[part]?.name);
  if (row?.kind !== 'cylinder' || row.inside_radius === null) return null;
  const radius = row.inside_radius * millimetres(units) + thickness / 2,
    { facet_part, facet_parent, facet_hinge: h } = shape;
  for (let f = 0; f < facet_parent.length; ++f) {
    if (facet_parent[f]! < 0) continue;
    const [own, other] = [facet_part[f]!, facet_part[facet_parent[f]!]!],
      flange = own === part ? other : other === part ? own : -1,
      put = shape.parts[flange]?.kind === 'flange' ? placing({ ...of, thickness: 0 }, 'folded', flange, true) : null;
    if (!put) continue;
    const up = row.direction === 'up' ? radius : -radius;
    return { type: 'line', a: put([h[4 * f]!, h[4 * f + 1]!], up), b: put([h[4 * f + 2]!, h[4 * f + 3]!], up) };
  }
  return null;
}
