import type { Vec2 } from './types.ts';

export interface Rectangle {
  corners: [Vec2, Vec2, Vec2, Vec2];
  size: Vec2;
  turned: boolean;
}

/**
 * The rectangle of least area about points `x, y, x, y …`, its first side the longer one unless it lies along the axes.
 * One along the axes is kept where none is smaller by a thousandth.
 */
export function smallestRectangle(points: ArrayLike<number>): Rectangle | null {
  const hull = convexHull(points);
  if (hull.length < 3) return null;
  let best = along(hull, 1, 0);
  let least = best.size[0] * best.size[1] * 0.999;
  hull.forEach((a, i) => {
    const b = hull[(i + 1) % hull.length]!,
      l = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (l === 0) return;
    const r = along(hull, (b[0] - a[0]) / l, (b[1] - a[1]) / l),
      area = r.size[0] * r.size[1];
    if (area < least) {
      best = { ...r, turned: true };
      least = area;
    }
  });
  return best;
}

/**
 * How long the sides of a drawn rectangle are said to be: as in the report, whose arcs are arcs and not the lines that
 * are drawn for them, wherever it means the same rectangle.
 */
export function sidesAsReported(drawn: Vec2, reported: Vec2): Vec2 {
  const off = (r: Vec2) => Math.max(...r.map((v, i) => Math.abs(v / drawn[i]! - 1)));
  const best = [reported, [reported[1], reported[0]] as Vec2].reduce((a, b) => (off(b) < off(a) ? b : a));
  return off(best) < 0.02 ? best : drawn;
}

function along(hull: Vec2[], ux: number, uy: number): Rectangle {
  let [u0, u1, v0, v1] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const [x, y] of hull) {
    const u = x * ux + y * uy,
      v = y * ux - x * uy;
    u0 = Math.min(u0, u);
    u1 = Math.max(u1, u);
    v0 = Math.min(v0, v);
    v1 = Math.max(v1, v);
  }
  const at = (u: number, v: number): Vec2 => [u * ux - v * uy, u * uy + v * ux];
  return { corners: [at(u0, v0), at(u1, v0), at(u1, v1), at(u0, v1)], size: [u1 - u0, v1 - v0], turned: false };
}

export function convexHull(points: ArrayLike<number>): Vec2[] {
  const sorted: Vec2[] = [];
  for (let i = 0; i + 1 < points.length; i += 2) sorted.push([points[i]!, points[i + 1]!]);
  sorted.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (list: Vec2[]) => {
    const out: Vec2[] = [];
    for (const p of list) {
      while (out.length > 1 && turn(out.at(-2)!, out.at(-1)!, p) <= 0) out.pop();
      out.push(p);
    }
    return out.slice(0, -1);
  };
  return [...half(sorted), ...half([...sorted].reverse())];
}

const turn = (a: Vec2, b: Vec2, c: Vec2) => (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);
