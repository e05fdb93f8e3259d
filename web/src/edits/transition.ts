import type { Frame, Profile, Seam, TransitionSpec } from './transition-types.ts';
import type { Vec2, Vec3 } from '../types.ts';
import { round } from '../units.ts';
import { cross, dot, normalised, plus, scaled } from '../vectors.ts';

export type ProfileKind = 'polygon' | 'circle' | 'ellipse' | 'rounded_rectangle' | 'obround' | 'spline';
export const profileKind = (p: Profile) => Object.keys(p)[0] as ProfileKind;

/** How far a profile reaches to both sides of its middle. */
export function halfSize(p: Profile): Vec2 {
  if ('circle' in p) return [p.circle.radius, p.circle.radius];
  if ('ellipse' in p) return [p.ellipse.rx, p.ellipse.ry];
  if ('rounded_rectangle' in p) return [p.rounded_rectangle.width / 2, p.rounded_rectangle.height / 2];
  if ('obround' in p) return [p.obround.length / 2, p.obround.width / 2];
  const points = 'polygon' in p ? p.polygon : p.spline;
  return [0, 1].map((k) => Math.max(...points.map((q) => Math.abs(q[k]!)))) as Vec2;
}

export type SeamKind = 'edge' | 'corner' | 'parameter';

/** The number of straight edges or sharp corners of a profile at which a seam may lie; anywhere counts as one. */
export function seamPlaces(p: Profile, kind: SeamKind): number {
  if (kind === 'parameter') return 1;
  if ('polygon' in p) return p.polygon.length;
  return kind === 'corner' ? 0 : 'rounded_rectangle' in p ? 4 : 'obround' in p ? 2 : 0;
}

/**
 * Another profile at one end. If the first profile no longer has the seam's edge or corner, the seam returns to where
 * it is shortest.
 */
export function withProfile(spec: TransitionSpec, end: 'from' | 'to', profile: Profile): TransitionSpec {
  const out = { ...spec, [end]: { ...spec[end], profile } };
  if (!out.seam || seamFits(out.seam, out.from.profile)) return out;
  const { seam: _gone, ...rest } = out;
  return rest;
}

function seamFits(seam: Seam, first: Profile): boolean {
  const [kind, at] = Object.entries(seam)[0] as [SeamKind, number];
  return kind === 'parameter' || at < seamPlaces(first, kind);
}

/** A profile of another kind about as large as `p`. */
export function asKind(p: Profile, kind: ProfileKind): Profile {
  const [a, b] = halfSize(p).map((v) => round(v, 3)) as Vec2;
  switch (kind) {
    case 'circle':
      return { circle: { radius: Math.min(a, b) } };
    case 'ellipse':
      return { ellipse: { rx: a, ry: b } };
    case 'rounded_rectangle':
      return { rounded_rectangle: { width: 2 * a, height: 2 * b, radius: round(Math.min(a, b) / 3, 3) } };
    case 'obround':
      return { obround: { length: 2 * Math.max(a, b), width: round(a === b ? 1.2 * a : 2 * Math.min(a, b), 3) } };
    case 'polygon':
      return {
        polygon: [
          [-a, -b],
          [a, -b],
          [a, b],
          [-a, b],
        ],
      };
    case 'spline':
      return {
        spline: Array.from(
          { length: 8 },
          (_, i) => [round(a * Math.cos((i * Math.PI) / 4), 3), round(b * Math.sin((i * Math.PI) / 4), 3)] as Vec2,
        ),
      };
  }
}

/** Width and height of a polygon that is a rectangle along the axes, else null. */
export function rectangleOf(polygon: Vec2[]): { width: number; height: number; at: Vec2 } | null {
  if (polygon.length !== 4) return null;
  const xs = [...new Set(polygon.map((p) => p[0]))],
    ys = [...new Set(polygon.map((p) => p[1]))];
  if (xs.length !== 2 || ys.length !== 2) return null;
  if (
    polygon.some((p, i) => {
      const q = polygon[(i + 1) % 4]!;
      return (p[0] === q[0]) === (p[1] === q[1]);
    })
  )
    return null;
  const [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  return { width: x1 - x0, height: y1 - y0, at: [(x0 + x1) / 2, (y0 + y1) / 2] };
}

export function resized(polygon: Vec2[], width: number, height: number): Vec2[] {
  const r = rectangleOf(polygon);
  return r
    ? polygon.map(([x, y]) => [
        round(r.at[0] + ((x - r.at[0]) * width) / r.width),
        round(r.at[1] + ((y - r.at[1]) * height) / r.height),
      ])
    : polygon;
}

/**
 * A plane as it is turned: its normal leans by `tiltX` towards x and by `tiltY` towards y; `twist` turns the profile in
 * it. Degrees.
 */
export interface Attitude {
  tiltX: number;
  tiltY: number;
  twist: number;
}

const rad = Math.PI / 180;

export function attitudeOf(frame: Frame | undefined): Attitude {
  const n = normalised(frame?.normal ?? [0, 0, 1]),
    tiltX = Math.atan2(n[0], n[2]),
    tiltY = Math.asin(Math.max(-1, Math.min(1, n[1])));
  const zero: Vec3 = [Math.cos(tiltX), 0, -Math.sin(tiltX)];
  const given = frame?.x ?? [1, 0, 0],
    x = plus(given, scaled(n, -dot(given, n)));
  const twist = Math.hypot(...x) < 1e-9 ? 0 : Math.atan2(dot(cross(zero, x), n), dot(zero, x));
  return { tiltX: tiltX / rad, tiltY: tiltY / rad, twist: twist / rad };
}

export function turnedTo(frame: Frame | undefined, a: Attitude): Frame {
  const [tx, ty, tw] = [a.tiltX * rad, a.tiltY * rad, a.twist * rad];
  const n: Vec3 = [Math.sin(tx) * Math.cos(ty), Math.sin(ty), Math.cos(tx) * Math.cos(ty)];
  const zero: Vec3 = [Math.cos(tx), 0, -Math.sin(tx)],
    x = plus(scaled(zero, Math.cos(tw)), scaled(cross(n, zero), Math.sin(tw)));
  const exact = (v: Vec3) => v.map((c) => round(c, 12)) as Vec3;
  return { ...frame, normal: exact(n), x: exact(x) };
}
