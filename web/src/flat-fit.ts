import { dimensionReach } from './flat-dimensions.ts';
import type { Lie } from './flat-scene.ts';
import { smallestRectangle, type Rectangle } from './rectangle.ts';
import type { Vec2 } from './types.ts';

/** What of a pattern must be visible: its corners, and the rectangle with its dimension lines. */
export interface Extent {
  x0: number;
  y0: number;
  x1: number;
  y1: number;
  rectangle: Rectangle | null;
}

export function extentOf(points: Float32Array): Extent {
  const b: Extent = { x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity, rectangle: smallestRectangle(points) };
  const include = (x: number, y: number) => {
    b.x0 = Math.min(b.x0, x);
    b.x1 = Math.max(b.x1, x);
    b.y0 = Math.min(b.y0, y);
    b.y1 = Math.max(b.y1, y);
  };
  for (let i = 0; i < points.length; i += 2) include(points[i]!, points[i + 1]!);
  for (const [x, y] of b.rectangle?.corners ?? []) include(x, y);
  return b;
}

/** How the pattern lies when all of it is seen in a view of so many pixels. */
export function fitted(extent: Extent, width: number, height: number): Lie {
  const [side, above, below] = [18, 30, 18],
    [across, up] = [reach(extent, 0), reach(extent, 1)];
  const scale = Math.min(scaleToFit(across, width - 2 * side), scaleToFit(up, height - above - below));
  const [x0, x1] = reachAt(across, scale),
    [y0, y1] = reachAt(up, scale);
  return { scale, offset: [width / 2 - (x0 + x1) / 2, (height + above - below) / 2 + (y0 + y1) / 2] };
}

/** A place along an axis of the pattern, and how far from it in pixels. */
interface Reach {
  at: number;
  by: number;
}

function reach({ x0, y0, x1, y1, rectangle }: Extent, axis: 0 | 1): Reach[] {
  const corners = axis ? [y0, y1] : [x0, x1];
  return [
    ...corners.map((at) => ({ at, by: 0 })),
    ...(rectangle ? dimensionReach(rectangle.corners) : []).map(({ at, by }) => ({ at: at[axis], by: by[axis] })),
  ];
}

const reachAt = (places: Reach[], scale: number): Vec2 => {
  const all = places.map(({ at, by }) => scale * at + by);
  return [Math.min(...all), Math.max(...all)];
};

/**
 * The largest scale at which all places lie within `room` pixels; of too small a room a hundredth of what the pattern
 * alone would have.
 */
function scaleToFit(places: Reach[], room: number): number {
  const own = places.map((p) => p.at),
    width = Math.max(Math.max(...own) - Math.min(...own), 1e-6);
  const most = Math.max(room, 1) / width;
  let [low, high] = [0, most];
  for (let i = 0; i < 40; ++i) {
    const middle = (low + high) / 2,
      [from, to] = reachAt(places, middle);
    if (to - from <= room) low = middle;
    else high = middle;
  }
  return Math.max(low, most / 100);
}
