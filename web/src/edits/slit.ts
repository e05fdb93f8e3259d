import type { AnchorSpec, CurveName, SlitSpec } from './slit-types.ts';
import type { Vec2, Vec3 } from '../types.ts';
import { fileDigits, round } from '../units.ts';
import { legOf, setLeg } from './panels.ts';

export function bezierPoints(control: Vec2[], count = 64): Vec2[] {
  return Array.from({ length: count + 1 }, (_, i) => bezierAt(control, i / count));
}

function bezierAt(control: Vec2[], t: number): Vec2 {
  const x = control.map((p) => p[0]),
    y = control.map((p) => p[1]);
  for (let last = control.length - 1; last > 0; --last)
    for (let i = 0; i < last; ++i) {
      x[i]! += t * (x[i + 1]! - x[i]!);
      y[i]! += t * (y[i + 1]! - y[i]!);
    }
  return [x[0] ?? 0, y[0] ?? 0];
}

const lengths = new WeakMap<Vec2[], number>(); // of curves that do not change while another one is dragged

export function lengthOf(control: Vec2[]): number {
  const known = lengths.get(control);
  if (known !== undefined) return known;
  const p = bezierPoints(control, 400),
    length = p.reduce((sum, b, i) => (i ? sum + Math.hypot(b[0] - p[i - 1]![0], b[1] - p[i - 1]![1]) : 0), 0);
  lengths.set(control, length);
  return length;
}

/** The same curve with one more control point. */
export function raised(control: Vec2[]): Vec2[] {
  const n = control.length;
  return Array.from({ length: n + 1 }, (_, i) => {
    const a = control[Math.max(i - 1, 0)]!,
      b = control[Math.min(i, n - 1)]!,
      t = i / n;
    return [round(t * a[0] + (1 - t) * b[0]), round(t * a[1] + (1 - t) * b[1])];
  });
}

/** Scaled from its first point so that it is `length` long. */
export function fitted(control: Vec2[], length: number): Vec2[] {
  const own = lengthOf(control),
    [o] = control;
  if (!o || own <= 0) return control;
  const s = length / own;
  return control.map((p) => [round(o[0] + s * (p[0] - o[0]), 4), round(o[1] + s * (p[1] - o[1]), 4)]);
}

/** Without an inner control point; the ends of the curve stay. */
export const lowered = (control: Vec2[], index: number): Vec2[] =>
  index > 0 && index < control.length - 1 ? control.filter((_, i) => i !== index) : control;

/** A leg curve keeps its length, since the sheet keeps its width. */
export function removePoint(spec: SlitSpec, curve: CurveName, index: number): SlitSpec {
  const seat = spec.seat_curve;
  if (curve === 'seat') return seat ? { ...spec, seat_curve: { ...seat, bezier: lowered(seat.bezier, index) } } : spec;
  const bezier = legOf(spec, curve)?.bezier;
  return bezier ? setLeg(spec, curve, { bezier: fitted(lowered(bezier, index), lengthOf(bezier)) }) : spec;
}

const placed = (spec: SlitSpec, at: Vec3) => at.map((v) => round(v, fileDigits(spec.units))) as Vec3;

export function addAnchor(spec: SlitSpec, anchor: AnchorSpec): SlitSpec {
  return { ...spec, anchors: [...(spec.anchors ?? []), { ...anchor, at: placed(spec, anchor.at) }] };
}

export function moveAnchor(spec: SlitSpec, index: number, at: Vec3): SlitSpec {
  return { ...spec, anchors: spec.anchors?.map((a, i) => (i === index ? { ...a, at: placed(spec, at) } : a)) };
}

export function removeAnchor(spec: SlitSpec, index: number): SlitSpec {
  const anchors = (spec.anchors ?? []).filter((_, i) => i !== index);
  const { anchors: _gone, ...rest } = spec;
  return anchors.length ? { ...rest, anchors } : rest;
}
