import type { Vec3 } from './types.ts';

const edgeOn = 1e-9; // of the size of its parts: the area of a triangle that is seen along its plane

/**
 * The weights of a triangle's corners at a place (x, y) of the screen, of sum 1, or null beside the triangle and
 * where it is seen along its plane. `screen` has three numbers for each corner, of which the first two are read; a, b
 * and c are where theirs begin.
 */
export function weightsUnder(
  screen: Float32Array | Float64Array,
  a: number,
  b: number,
  c: number,
  x: number,
  y: number,
): Vec3 | null {
  const ax = screen[a]! - x,
    bx = screen[b]! - x,
    cx = screen[c]! - x;
  if ((ax < 0 && bx < 0 && cx < 0) || (ax > 0 && bx > 0 && cx > 0)) return null;
  const ay = screen[a + 1]! - y,
    by = screen[b + 1]! - y,
    cy = screen[c + 1]! - y;
  if ((ay < 0 && by < 0 && cy < 0) || (ay > 0 && by > 0 && cy > 0)) return null;
  const u = bx * cy - by * cx,
    v = cx * ay - cy * ax,
    w = ax * by - ay * bx,
    sum = u + v + w;
  if (Math.abs(sum) <= edgeOn * (Math.abs(u) + Math.abs(v) + Math.abs(w))) return null;
  if (sum > 0 ? u < 0 || v < 0 || w < 0 : u > 0 || v > 0 || w > 0) return null;
  return [u / sum, v / sum, w / sum];
}
