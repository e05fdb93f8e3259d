import type { Vec2 } from '../types.ts';

/** Where texts stand already. */
export type Taken = { x: number; y: number; w: number; h: number }[];

const [beside, above] = [14, 4]; // pixels that a text takes more than it is wide and high
const rings = 6;

/**
 * The place of a text's middle: the first of those offered where it covers no other text and is wholly in the view, or
 * else the nearest around the first one. `offered`: whether it is one of the former.
 */
export function placeOfText(
  places: Vec2[],
  [width, height]: Vec2,
  taken: Taken,
  [viewWidth, viewHeight]: Vec2,
): { at: Vec2; offered: boolean; box: Taken[number] } {
  const box = ([x, y]: Vec2) => ({
      x: x - (width + beside) / 2,
      y: y - (height + above) / 2,
      w: width + beside,
      h: height + above,
    }),
    isFree = (at: Vec2) => {
      const own = box(at),
        inside = own.x >= 0 && own.y >= 0 && own.x + own.w <= viewWidth && own.y + own.h <= viewHeight;
      return (
        inside &&
        taken.every((t) => t.x >= own.x + own.w || own.x >= t.x + t.w || t.y >= own.y + own.h || own.y >= t.y + t.h)
      );
    };
  const offered = places.find(isFree),
    at = offered ?? around(places[0]!, [width + beside, height + above]).find(isFree) ?? places[0]!;
  return { at, offered: offered !== undefined || at === places[0], box: box(at) };
}

/** Rows above and below, and columns left and right, the nearest first. */
function around([x, y]: Vec2, [w, h]: Vec2): Vec2[] {
  const out: { at: Vec2; distance: number }[] = [];
  for (let row = -rings; row <= rings; ++row)
    for (let column = -2; column <= 2; ++column) {
      const [dx, dy] = [(column * w) / 2, row * h];
      out.push({ at: [x + dx, y + dy], distance: Math.hypot(dx, dy) });
    }
  return out.sort((a, b) => a.distance - b.distance).map(({ at }) => at);
}
