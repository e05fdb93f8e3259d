import type { Vec2, Vec3 } from './types.ts';

/** From where one looks, with z up: each part is −1, 0 or 1. */
export type Side = Vec3;

const faces: { name: string; normal: Side; right: Side; up: Side }[] = [
  { name: 'Front', normal: [0, -1, 0], right: [1, 0, 0], up: [0, 0, 1] },
  { name: 'Right', normal: [1, 0, 0], right: [0, 1, 0], up: [0, 0, 1] },
  { name: 'Back', normal: [0, 1, 0], right: [-1, 0, 0], up: [0, 0, 1] },
  { name: 'Left', normal: [-1, 0, 0], right: [0, -1, 0], up: [0, 0, 1] },
  { name: 'Top', normal: [0, 0, 1], right: [1, 0, 0], up: [0, 1, 0] },
  { name: 'Bottom', normal: [0, 0, -1], right: [1, 0, 0], up: [0, -1, 0] },
];

/** All faces, edges and corners. */
export const sides: Side[] = [-1, 0, 1].flatMap((z) =>
  [-1, 0, 1].flatMap((y) => [-1, 0, 1].flatMap((x): Side[] => (x || y || z ? [[x, y, z]] : []))),
);

/** "Front", "Front top", "Front right top". */
export const nameOfSide = (side: Side): string =>
  faces
    .filter(({ normal }) => dot(normal, side) > 0)
    .map(({ name }, i) => (i ? name.toLowerCase() : name))
    .join(' ');

/** The next side in a direction of the screen, seen from a side. */
export function sideBeside(side: Side, across: number, up: number): Side {
  const right = side[0] || side[1] ? unit([-side[1], side[0], 0]) : ([1, 0, 0] as Vec3),
    d = unit(side),
    top = cross(d, right),
    wanted = unit(d.map((v, k) => v + across * right[k]! + up * top[k]!) as Vec3);
  return sides
    .filter((s) => s !== side && s.join() !== side.join())
    .reduce((best, s) => (dot(unit(s), wanted) > dot(unit(best), wanted) ? s : best));
}

/** How the cube is seen: where its axes point on the screen, right and up, and towards the eye. */
export interface Attitude {
  axes: [Vec3, Vec3, Vec3];
}

const inner = 0.52; // where faces end and edges begin
const bounds = [-1, -inner, inner, 1];

/** A cell of a face as it is seen: its side and its corners, in halves of the cube's edge. */
export interface Cell {
  side: Side;
  corners: Vec2[];
}

const seen = ({ axes }: Attitude, p: Vec3): Vec3 =>
  [0, 1, 2].map((k) => p[0] * axes[0][k]! + p[1] * axes[1][k]! + p[2] * axes[2][k]!) as Vec3;

const facing = 0.03; // the least share of a face that is drawn

export function cellsOf(attitude: Attitude): {
  cells: Cell[];
  faces: { name: string; at: Vec2; right: Vec2; up: Vec2 }[];
} {
  const shown = faces.filter(({ normal }) => seen(attitude, normal)[2] > facing);
  const cells = shown.flatMap(({ normal, right, up }) =>
    [-1, 0, 1].flatMap((i) =>
      [-1, 0, 1].map((j): Cell => {
        const corner = (a: number, b: number): Vec2 => {
          const [u, v] = [bounds[i + 1 + a]!, bounds[j + 1 + b]!],
            [x, y] = seen(attitude, normal.map((n, k) => n + u * right[k]! + v * up[k]!) as Vec3);
          return [x, y];
        };
        return {
          side: normal.map((n, k) => n + i * right[k]! + j * up[k]!) as Side,
          corners: [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)],
        };
      }),
    ),
  );
  const flat = (p: Vec3): Vec2 => [seen(attitude, p)[0], seen(attitude, p)[1]];
  return {
    cells,
    faces: shown.map(({ name, normal, right, up }) => ({ name, at: flat(normal), right: flat(right), up: flat(up) })),
  };
}

/** The cell under a point, in the same measure. */
export const cellAt = (cells: Cell[], [x, y]: Vec2): Cell | null =>
  cells.find(({ corners }) =>
    corners.every((a, i) => {
      const b = corners[(i + 1) % corners.length]!;
      return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) >= 0;
    }),
  ) ?? null;

const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
function unit(a: Vec3): Vec3 {
  const l = Math.hypot(...a) || 1;
  return a.map((v) => v / l) as Vec3;
}
