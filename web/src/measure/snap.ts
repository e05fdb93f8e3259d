import type { Vec2 } from '../types.ts';
import { edgeForms } from './edges.ts';
import { thingOf, type Measured, type MeasuredView, type Ref } from './things.ts';

/** Where a place is on the screen, in pixels of the view. */
export type OnScreen = (x: number, y: number, z: number) => Vec2;

const near = 9, // pixels
  shareOfEdge = 0.3, // small edges leave room for themselves
  shareOfRadius = 0.6,
  onRim = 1.5; // pixels

/** An edge under the pointer, on one side of the sheet, so many pixels away. */
export interface EdgeUnder {
  edge: number;
  upper: boolean;
  distance: number;
}

/**
 * The corner, middle or centre that a pointer snaps to: the nearest that is near and that `isSeen`. Of edges that
 * appear small only what lies nearer counts; on the rim of a hole what lies farther away does not.
 */
export function snapAt(
  of: Measured,
  view: MeasuredView,
  toScreen: OnScreen,
  [sx, sy]: Vec2,
  isSeen: (at: Vec2, upper: boolean, place: [number, number, number]) => boolean,
  under: EdgeUnder | null = null,
): Ref | null {
  const found: { ref: Ref; distance: number; at: [number, number, number]; screen: Vec2 }[] = [];
  const offer = (ref: Ref & { upper: boolean }, within: number) => {
    const thing = thingOf(of, view, ref);
    if (thing?.type !== 'point' && thing?.type !== 'circle') return;
    const screen = toScreen(...thing.at),
      distance = Math.hypot(screen[0] - sx, screen[1] - sy);
    if (distance < within) found.push({ ref, distance, at: thing.at, screen });
  };
  const scale = Math.hypot(...scaleOf(toScreen));
  edgeForms(of.shape).forEach(({ ends, straight, circle, part }, edge) => {
    if (view === 'folded' && !of.shape.parts[part]?.place) return;
    for (const upper of view === 'flat' ? [true] : [true, false]) {
      if (circle) offer({ kind: 'circle', edge, upper }, Math.min(near, shareOfRadius * circle.radius * scale));
      if (!ends || circle?.whole) continue; // where arcs of one hole meet is no corner
      const within = Math.min(near, shareOfEdge * scale * Math.hypot(ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]));
      offer({ kind: 'corner', edge, end: 0, upper }, within);
      offer({ kind: 'corner', edge, end: 1, upper }, within);
      if (straight) offer({ kind: 'middle', edge, upper }, within);
    }
  });
  found.sort((a, b) => a.distance - b.distance);
  const best = found.find(({ ref, screen, at }) => isSeen(screen, 'upper' in ref && ref.upper, at)),
    rim = under && under.distance <= onRim ? rimOf(of, view, under) : null;
  return rim && under!.distance < (best?.distance ?? Infinity) ? rim : (best?.ref ?? null);
}

/** The hole whose rim an edge is. */
function rimOf(of: Measured, view: MeasuredView, { edge, upper }: EdgeUnder): Ref | null {
  const ref: Ref = { kind: 'circle', edge, upper },
    thing = thingOf(of, view, ref);
  return thing?.type === 'circle' && thing.whole ? ref : null;
}

/** Pixels a millimetre, in the direction in which they are most. */
function scaleOf(toScreen: OnScreen): Vec2 {
  const [x0, y0] = toScreen(0, 0, 0);
  const lengths = [toScreen(1, 0, 0), toScreen(0, 1, 0), toScreen(0, 0, 1)].map(([x, y]) => Math.hypot(x - x0, y - y0));
  return [Math.max(...lengths), 0];
}

/** The edge or circle of a line that was picked. */
export function refOfEdge(of: Measured, edge: number, upper: boolean): Ref | null {
  const form = edgeForms(of.shape)[edge];
  if (form?.circle) return { kind: 'circle', edge, upper };
  return form?.straight ? { kind: 'edge', edge, upper } : null;
}
