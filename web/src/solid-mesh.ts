import type { Place, Shape, Vec3 } from './types.ts';
import { cross, minus, plus, scaled } from './vectors.ts';

/** The triangles of a solid, each with the number of its face. */
export type Solid = Pick<Shape, 'space_points' | 'space_triangles' | 'space_faces'>;

/** Faces of a solid by number, and edges by the two faces that meet there. */
export interface NamedPlaces {
  faces: { name: string; number: number }[];
  edges: { name: string; between: [number, number] }[];
}

export const unnamed: NamedPlaces = { faces: [], edges: [] };

/** The faces and edges among places. */
export function namedPlaces(places: Place[] = []): NamedPlaces {
  const named: NamedPlaces = { faces: [], edges: [] };
  for (const { kind, id, faces } of places) {
    const name = `${kind} ${id}`;
    if (kind === 'face' && !named.faces.some((f) => f.number === id)) named.faces.push({ name, number: Number(id) });
    if (kind === 'edge' && faces?.length === 2 && !named.edges.some((e) => e.name === name))
      named.edges.push({ name, between: [faces[0]!, faces[1]!] });
  }
  return named;
}

/** A line between two triangles of different faces; of open bodies also one with a triangle on one side. */
export interface SolidLine {
  ends: [number, number]; // points
  faces: number[];
}

/** The edges of a solid, piece by piece. */
export function solidLines({ space_triangles: t, space_faces: faces }: Solid): SolidLine[] {
  const sides = new Map<string, SolidLine>();
  for (let i = 0; i < t.length; ++i) {
    const a = t[i]!,
      b = t[i % 3 === 2 ? i - 2 : i + 1]!,
      key = a < b ? `${a} ${b}` : `${b} ${a}`,
      known = sides.get(key);
    if (known) known.faces.push(faces[Math.floor(i / 3)]!);
    else sides.set(key, { ends: [a, b], faces: [faces[Math.floor(i / 3)]!] });
  }
  return [...sides.values()].filter(({ faces: [a, b] }) => a !== b);
}

export const pointOf = ({ space_points: p }: Solid, i: number): Vec3 => [p[3 * i]!, p[3 * i + 1]!, p[3 * i + 2]!];

export const isBetween = ({ faces }: SolidLine, [a, b]: [number, number]) => faces.includes(a) && faces.includes(b);

/** A stretch of a named edge, or a triangle of a named face, whose normal is as long as twice its area. */
export interface NamedPiece {
  name: string;
  middle: Vec3;
  corners: Vec3[];
  normal: Vec3 | null;
  size: number;
}

/** The pieces of what is named, each one's largest first. */
export function namedPieces(shape: Solid, named: NamedPlaces): NamedPiece[][] {
  const { space_triangles: t, space_faces } = shape,
    corners = (row: ArrayLike<number>) => Array.from(row, (i) => pointOf(shape, i)),
    lines = named.edges.length ? solidLines(shape) : [];
  const faces = named.faces.map(({ name, number }) => {
    const own: NamedPiece[] = [];
    space_faces.forEach((of, i) => {
      if (of !== number) return;
      const [a, b, c] = corners(t.subarray(3 * i, 3 * i + 3)) as [Vec3, Vec3, Vec3],
        normal = cross(minus(b, a), minus(c, a));
      own.push({ name, middle: mean([a, b, c]), corners: [a, b, c], normal, size: Math.hypot(...normal) });
    });
    return own;
  });
  const edges = named.edges.map(({ name, between }) =>
    lines
      .filter((line) => isBetween(line, between))
      .map(({ ends }) => corners(ends) as [Vec3, Vec3])
      .map(([a, b]) => ({
        name,
        middle: mean([a, b]),
        corners: [a, b],
        normal: null,
        size: Math.hypot(...minus(b, a)),
      })),
  );
  return [...faces, ...edges].filter((p) => p.length > 0).map((p) => p.sort((a, b) => b.size - a.size));
}

const mean = (all: Vec3[]): Vec3 => scaled(all.reduce(plus), 1 / all.length);
