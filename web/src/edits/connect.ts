import type { BendRow, Vec2, Vec3 } from '../types.ts';
import type { BendSpec, PlateSpec, PlatesSpec } from './plates-types.ts';
import { round } from '../units.ts';
import { plus, scaled } from '../vectors.ts';
import { directionsOf, extentOf, rectangleAt } from './outline.ts';

const same = (a: string[], b: string[]) =>
  a.length === b.length && [...a].sort().join('\n') === [...b].sort().join('\n');

/**
 * Where the file has the bend of the report's `row`, else −1. Several sections may stand on one plate; both lists have
 * them in one order.
 */
function indexOf(bends: BendSpec[], rows: BendRow[], row: BendRow): number {
  const alike = (list: { between?: string[] }[]) =>
    list.flatMap((b, i) => (same(b.between ?? [], row.between ?? []) ? [i] : []));
  return alike(bends)[alike(rows).indexOf(rows.indexOf(row))] ?? -1;
}

export const bendSpecOf = (spec: PlatesSpec, rows: BendRow[], row: BendRow): BendSpec | undefined =>
  spec.bends?.[indexOf(spec.bends, rows, row)];

/** What is shown of bends: those of the file, of which the last report knows some, or those that the program found. */
export function bendsOf(spec: PlatesSpec, rows: BendRow[]): { between: string[]; row: BendRow | null }[] {
  if (!spec.bends?.length)
    return rows.filter((row) => knows(spec, row.between ?? [])).map((row) => ({ between: row.between ?? [], row }));
  const at = rows.map((row) => indexOf(spec.bends!, rows, row));
  return spec.bends.map((b, i) => ({ between: b.between, row: rows[at.indexOf(i)] ?? null }));
}

const knows = (spec: PlatesSpec, between: string[]) => between.every((id) => spec.plates.some((p) => p.id === id));

/**
 * The bends of the file. Where it has none the program found them: then all it found are named, or only the one that is
 * changed would remain.
 */
const named = (spec: PlatesSpec, rows: BendRow[]): BendSpec[] =>
  spec.bends?.length ? spec.bends : bendsOf(spec, rows).map(({ between }) => ({ between }));

/** `patch` on the bend of the report's `row`; keys that are undefined are left to the program. */
export function setBend(spec: PlatesSpec, rows: BendRow[], row: BendRow, patch: Partial<BendSpec>): PlatesSpec {
  const bends = named(spec, rows),
    at = indexOf(bends, rows, row);
  return { ...spec, bends: bends.map((b, i) => (i === at ? withoutHoles({ ...b, ...patch }) : b)) };
}

const notWith: Record<string, (keyof BendSpec)[]> = {
  auto: ['tangent_point'],
  cylinder: ['slope', 'apex', 'aperture', 'inside_radii', 'tangent_point'],
  cone: ['tangent_point'],
  general: ['slope', 'aperture', 'inside_radius', 'inside_radii'],
};
const without = (keys: (keyof BendSpec)[]): Partial<BendSpec> =>
  Object.fromEntries(keys.map((key) => [key, undefined]));

/**
 * The patch that gives a bend another surface, or leaves that to the program, without what such a surface cannot have.
 */
export const surfacePatch = (surface: NonNullable<BendSpec['surface']>): Partial<BendSpec> => ({
  ...without(notWith[surface] ?? []),
  surface: surface === 'auto' ? undefined : surface,
});

/** The patch that gives a bend its radius and removes other keys that would set it. */
export const radiusPatch = (inside_radius: number): Partial<BendSpec> => ({
  ...without(['inside_radii', 'aperture', 'apex']),
  inside_radius,
});

export const addBend = (spec: PlatesSpec, rows: BendRow[], a: string, b: string): PlatesSpec => ({
  ...spec,
  bends: [...named(spec, rows), { between: [a, b] }],
});

/** Without the bend at `index` of `bendsOf`; if none remains the program chooses again. */
export const removeBend = (spec: PlatesSpec, rows: BendRow[], index: number): PlatesSpec =>
  withBends(
    spec,
    named(spec, rows).filter((_, i) => i !== index),
  );

function withBends(spec: PlatesSpec, bends: BendSpec[] | undefined): PlatesSpec {
  const { bends: _before, ...rest } = spec;
  return bends?.length ? { ...rest, bends } : rest;
}

/** Plates that no bend joins to plate `id` yet. */
export const notJoined = (spec: PlatesSpec, rows: BendRow[], id: string): string[] =>
  spec.plates
    .map((p) => p.id)
    .filter((other) => other !== id && !bendsOf(spec, rows).some((b) => same(b.between, [id, other])));

/** The first of P1, P2 … or, of copies, of base-2, base-3 … that is free. */
function freeId(spec: PlatesSpec, stem: string, from: number): string {
  let n = from;
  while (spec.plates.some((p) => p.id === `${stem}${n}`)) ++n;
  return `${stem}${n}`;
}
export const newPlateId = (spec: PlatesSpec) => freeId(spec, 'P', 1);
export const copyId = (spec: PlatesSpec, id: string) => freeId(spec, `${id.replace(/-\d+$/, '')}-`, 2);

const room = 0.1; // between a new plate and the one beside it, as a share of its size

/**
 * A rectangle of a size in the plane of plate `beside`, or else in that of x and y, where it covers nothing along u.
 */
export function addPlate(spec: PlatesSpec, beside: string | null, size: Vec2): PlatesSpec {
  const plate = spec.plates.find((p) => p.id === beside),
    corners = plate ? plate.outline : spec.plates.flatMap((p) => p.outline);
  const d = directionsOf(plate?.outline ?? []),
    { low, high } = extentOf(d, corners),
    at: Vec2 = [high[0] + room * size[0], low[1]];
  const outline = rectangleAt(d, plate?.outline[0] ?? [0, 0, 0], { low: at, high: [at[0] + size[0], at[1] + size[1]] });
  return { ...spec, plates: [...spec.plates, { id: newPlateId(spec), outline }] };
}

/** The same plate beside itself. */
export function copyPlate(spec: PlatesSpec, id: string): PlatesSpec {
  const plate = spec.plates.find((p) => p.id === id);
  if (!plate) return spec;
  const d = directionsOf(plate.outline),
    { low, high } = extentOf(d, plate.outline),
    copy = copyId(spec, id),
    by = scaled(d.u, (1 + room) * (high[0] - low[0]));
  return movePlate({ ...spec, plates: [...spec.plates, { ...plate, id: copy }] }, copy, (p) => plus(p, by));
}

/** Without the plate and all references to it. */
export function removePlate(spec: PlatesSpec, id: string): PlatesSpec {
  const { root, ...rest } = withBends(
    spec,
    spec.bends?.filter((b) => !b.between.includes(id)),
  );
  return {
    ...rest,
    ...(root === undefined || root === id ? {} : { root }),
    plates: spec.plates.filter((p) => p.id !== id),
  };
}

/** Renames a plate everywhere. Null if the name is empty or another plate's. */
export function renamePlate(spec: PlatesSpec, id: string, to: string): PlatesSpec | null {
  if (to === '' || spec.plates.some((p) => p.id === to)) return null;
  const name = (s: string) => (s === id ? to : s);
  const edges = (e: Record<string, number[]>) =>
    Object.fromEntries(Object.entries(e).map(([plate, numbers]) => [name(plate), numbers]));
  return {
    ...spec,
    plates: spec.plates.map((p) => ({ ...p, id: name(p.id) })),
    ...(spec.bends
      ? {
          bends: spec.bends.map((b) => ({
            ...b,
            between: b.between.map(name),
            ...(b.edges ? { edges: edges(b.edges) } : {}),
          })),
        }
      : {}),
    ...(spec.root === undefined ? {} : { root: name(spec.root) }),
  };
}

function withoutHoles(bend: BendSpec): BendSpec {
  return Object.fromEntries(Object.entries(bend).filter(([, v]) => v !== undefined)) as unknown as BendSpec;
}

const isPoint = (value: unknown): value is Vec3 =>
  Array.isArray(value) && value.length === 3 && value.every((v) => typeof v === 'number');

/** The same with every point in it moved. */
function withPoints<T>(value: T, to: (p: Vec3) => Vec3): T {
  if (isPoint(value)) return to(value) as T;
  if (Array.isArray(value)) return value.map((v) => withPoints(v, to)) as T;
  if (typeof value !== 'object' || value === null) return value;
  return Object.fromEntries(Object.entries(value).map(([k, v]) => [k, withPoints(v, to)])) as T;
}

/** Every corner of plate `id` moved. */
export function movePlate(spec: PlatesSpec, id: string, to: (p: Vec3) => Vec3): PlatesSpec {
  const place = (p: Vec3) => to(p).map((v) => round(v)) as Vec3;
  const moved = (plate: PlateSpec): PlateSpec => ({
    ...plate,
    outline: plate.outline.map(place),
    ...(plate.holes ? { holes: withPoints(plate.holes, place) } : {}),
  });
  return { ...spec, plates: spec.plates.map((p) => (p.id === id ? moved(p) : p)) };
}

export function middleOf(plate: PlateSpec): Vec3 {
  const n = plate.outline.length;
  return [0, 1, 2].map((k) => plate.outline.reduce((sum, p) => sum + p[k]!, 0) / n) as Vec3;
}

/** Turned by `degrees` about the axis through `middle` along x, y or z. */
export function turned(p: Vec3, middle: Vec3, axis: 0 | 1 | 2, degrees: number): Vec3 {
  const a = (degrees * Math.PI) / 180,
    c = Math.cos(a),
    s = Math.sin(a),
    i = (axis + 1) % 3,
    j = (axis + 2) % 3;
  const out = [...p] as Vec3,
    u = p[i]! - middle[i]!,
    v = p[j]! - middle[j]!;
  out[i] = middle[i]! + c * u - s * v;
  out[j] = middle[j]! + s * u + c * v;
  return out;
}

/** "2 3", "2, 3" or "2…9"; empty: chosen by the program. Null if it is not a list. */
export function parseEdges(text: string): number[] | undefined | null {
  const words = text
    .replace(/\s*(?:…|–|-|\.\.+)\s*/g, '…')
    .split(/[\s,;]+/)
    .filter(Boolean);
  if (words.length === 0) return undefined;
  const numbers = words.flatMap((word) => {
    const [from, to = from, ...more] = word.split('…').map((n) => (n === '' ? NaN : Number(n)));
    return more.length || !(from! <= to!) || to! - from! > mostEdges
      ? [NaN]
      : Array.from({ length: to! - from! + 1 }, (_, i) => from! + i);
  });
  return numbers.every((n) => Number.isInteger(n) && n >= 0) ? numbers : null;
}

const mostEdges = 10000;

/** The inverse; three or more in a row are written as the first and the last. */
export function edgesText(edges: number[]): string {
  const runs: [number, number][] = [];
  for (const e of edges) {
    const last = runs.at(-1);
    if (last && e === last[1] + 1) last[1] = e;
    else runs.push([e, e]);
  }
  return runs.map(([a, b]) => (a === b ? `${a}` : b === a + 1 ? `${a} ${b}` : `${a}…${b}`)).join(' ');
}
