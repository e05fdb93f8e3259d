import { facetTransforms } from './folding.ts';
import type { Shape, Vec2 } from './types.ts';

const sameSide = 0.9; // cosine of the angle between the normals of a flange that still faces up

/** A place of a report in a pattern that is shown turned. */
export const turnedPlace = ([x, y]: Vec2, quarters: number): Vec2 =>
  quarters === 1 ? [-y, x] : quarters === 2 ? [-x, -y] : quarters === 3 ? [y, -x] : [x, y];

/**
 * The shape with its flat pattern turned by quarters, so that it lies as the one that was shown before: a pattern is
 * laid by its longest bend, which changes while one works.
 */
export function asBefore(shape: Shape, before: Shape | null): Shape {
  const quarters = before ? quartersBetween(before, shape) : 0;
  return quarters === 0 ? shape : turned(shape, quarters);
}

/** By how many quarters a new pattern must be turned to lie as another does. */
export function quartersBetween(before: Shape, after: Shape): number {
  const pair = sameFlange(before, after);
  if (!pair) return 0;
  const [old, now] = [axesOf(before, pair[0]), axesOf(after, pair[1])];
  if (dot(old.z, now.z) < sameSide) return 0;
  const angle = Math.atan2(dot(now.x, old.y), dot(now.x, old.x));
  return (Math.round(angle / (Math.PI / 2)) + 4) % 4;
}

/** Facets of a flange that both shapes have: of a plate that did not move, if there is one. */
function sameFlange(before: Shape, after: Shape): [number, number] | null {
  const places = (s: Shape) => new Map((s.handles.plates ?? []).map((p) => [p.id, JSON.stringify(p.corners)]));
  const [was, is] = [places(before), places(after)];
  const shared = after.parts.flatMap((part, row) => {
    if (part.kind !== 'flange') return [];
    const other = before.parts.findIndex(
        (p) =>
          p.kind === 'flange' &&
          p.plate === part.plate &&
          (part.plate ?? keyOf(p.faces)) === (part.plate ?? keyOf(part.faces)),
      ),
      facets = [before.facet_part.indexOf(other), after.facet_part.indexOf(row)] as [number, number];
    const rests = part.plate === undefined || was.get(part.plate) === is.get(part.plate);
    return other < 0 || facets.some((f) => f < 0) ? [] : [{ facets, rests }];
  });
  return (shared.find(({ rests }) => rests) ?? shared[0])?.facets ?? null;
}

const keyOf = (faces: number[]) => faces.join(' ');

/** The axes of the pattern in space, where a facet lies. */
function axesOf(shape: Shape, facet: number) {
  const t = facetTransforms(shape, 1),
    axis = (k: number) => [0, 1, 2].map((row) => t[16 * facet + 4 * row + k]!);
  return { x: axis(0), y: axis(1), z: axis(2) };
}

const dot = (a: number[], b: number[]) => a.reduce((sum, v, i) => sum + v * b[i]!, 0);

function turned(shape: Shape, quarters: number): Shape {
  const points = (a: Float32Array, stride = 2) => {
    const out = Float32Array.from(a);
    for (let i = 0; i < a.length; i += stride) [out[i], out[i + 1]] = turnedPlace([a[i]!, a[i + 1]!], quarters);
    return out;
  };
  const [c, s] = turnedPlace([1, 0], quarters);
  // takes the turned pattern to the same place
  const same = (m: number[]) =>
    m.map((v, i) => {
      const at = i - (i % 4);
      return i % 4 === 0 ? m[at]! * c - m[at + 1]! * s : i % 4 === 1 ? m[at]! * s + m[at + 1]! * c : v;
    });
  return {
    ...shape,
    turn: (shape.turn + quarters) % 4,
    points: points(shape.points),
    facet_hinge: points(shape.facet_hinge),
    edges: points(shape.edges),
    edge_circle: points(shape.edge_circle, 4),
    contour_points: points(shape.contour_points),
    bend_lines: points(shape.bend_lines),
    overlaps: points(shape.overlaps),
    root: same(shape.root),
    parts: shape.parts.map((p) => (p.place ? { ...p, place: same(p.place) } : p)),
  };
}
