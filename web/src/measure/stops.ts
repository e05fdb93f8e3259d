import { labelPlaces } from '../label-places.ts';
import type { Vec2, Vec3 } from '../types.ts';
import { edgeForms } from './edges.ts';
import { thingOf, type Measured, type MeasuredView, type Ref, type Thing } from './things.ts';

/** Something that can be measured, where arrow keys find it. */
export interface Stop {
  ref: Ref;
  at: Vec3;
  onSheet: boolean; // what is not, an axis, is never hidden
}

const known = new WeakMap<Measured, Map<MeasuredView, Stop[]>>();
const alongEdge = 0.3; // where an edge is found: apart from its corners and its middle

/** All that can be picked in a view, each once: edges that meet share a corner, arcs of one circle their centre. */
export function stopsOf(of: Measured, view: MeasuredView): Stop[] {
  const views = known.get(of) ?? new Map<MeasuredView, Stop[]>();
  known.set(of, views);
  const stops = views.get(view) ?? collected(of, view);
  views.set(view, stops);
  return stops;
}

function collected(of: Measured, view: MeasuredView): Stop[] {
  const out = new Map<string, Stop>();
  const add = (ref: Ref, onSheet = true) => {
    const thing = thingOf(of, view, ref),
      key = thing && JSON.stringify([keyOf(thing), 'upper' in ref ? ref.upper : null]);
    if (key && !out.has(key)) out.set(key, { ref, at: placeOf(thing, onSheet ? alongEdge : 0.5), onSheet });
  };
  const sides = view === 'flat' ? [true] : [true, false];
  edgeForms(of.shape).forEach((_, edge) => {
    for (const upper of sides) {
      add({ kind: 'corner', edge, end: 0, upper });
      add({ kind: 'corner', edge, end: 1, upper });
      for (const kind of ['middle', 'edge', 'circle'] as const) add({ kind, edge, upper });
    }
  });
  const lines = [...of.shape.bend_line_part.entries()];
  for (const [line, part] of view === 'flat' ? lines : lines.filter(([l, p]) => p !== of.shape.bend_line_part[l - 1]))
    add({ kind: 'bend', part, line: view === 'flat' ? line : 0 }, view === 'flat');
  if (view === 'folded')
    for (const [part, { at }] of labelPlaces(of.shape))
      for (const upper of sides) add({ kind: 'flange', part, upper, at });
  return [...out.values()];
}

/** Alike for what is the same thing, whichever edge it was found by. */
function keyOf(thing: Thing): unknown[] {
  const short = (p: Vec3) => p.map((v) => Math.round(1e3 * v));
  if (thing.type === 'line') return ['line', ...[short(thing.a), short(thing.b)].map(String).sort()];
  if (thing.type === 'circle') return ['circle', short(thing.at), Math.round(1e3 * thing.radius), short(thing.normal)];
  return [thing.type, short(thing.at)];
}

const placeOf = (thing: Thing, share: number): Vec3 =>
  thing.type === 'line' ? (thing.a.map((v, k) => v + share * (thing.b[k]! - v)) as Vec3) : thing.at;

/** By key: the direction on the screen, whose y goes down. */
export const arrows: Record<string, Vec2> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** Places of which several coincide lie beside each other, by less than is seen, so that keys reach each. */
export function apart(places: Vec2[]): Vec2[] {
  const count = new Map<string, number>();
  return places.map(([x, y]) => {
    const key = `${x.toFixed(1)} ${y.toFixed(1)}`,
      n = count.get(key) ?? 0;
    count.set(key, n + 1);
    return [x + 1.5 * n, y];
  });
}

/** The places that lie in a direction from one, within 45° of it: the nearest first. */
export function towards(places: Vec2[], from: Vec2, [dx, dy]: Vec2): number[] {
  const found: { i: number; cost: number }[] = [];
  places.forEach(([x, y], i) => {
    const [vx, vy] = [x - from[0], y - from[1]],
      along = vx * dx + vy * dy,
      off = Math.abs(vx * dy - vy * dx);
    if (along > 0 && off <= along) found.push({ i, cost: along + off });
  });
  return found.sort((a, b) => a.cost - b.cost).map(({ i }) => i);
}

/** All places, the nearest first. */
export const nearestTo = (places: Vec2[], [mx, my]: Vec2): number[] =>
  places
    .map(([x, y], i) => ({ i, cost: Math.hypot(x - mx, y - my) }))
    .sort((a, b) => a.cost - b.cost)
    .map(({ i }) => i);
