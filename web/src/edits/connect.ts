import type { BendRow, BendSpec, PlateSpec, PlatesSpec, Vec3 } from '../types.ts';
import { round } from '../units.ts';

const same = (a: string[], b: string[]) => a.length === b.length && [...a].sort().join('\n') === [...b].sort().join('\n');

export const bendSpecOf = (spec: PlatesSpec, row: BendRow): BendSpec | undefined => spec.bends?.find((b) => same(b.between, row.between ?? []));

/** `patch` on the bend of the report's `row`; keys that are undefined are left to the program. Where the file names no bends
 * the program found them: then all it found are named first, or only this one would remain. */
export function setBend(spec: PlatesSpec, rows: BendRow[], row: BendRow, patch: Partial<BendSpec>): PlatesSpec {
  const bends: BendSpec[] = spec.bends?.length ? spec.bends : rows.map((r) => ({ between: r.between ?? [] }));
  const named = bends.some((b) => same(b.between, row.between ?? [])) ? bends : [...bends, { between: row.between ?? [] }];
  return { ...spec, bends: named.map((b) => (same(b.between, row.between ?? []) ? withoutHoles({ ...b, ...patch }) : b)) };
}

function withoutHoles(bend: BendSpec): BendSpec {
  return Object.fromEntries(Object.entries(bend).filter(([, v]) => v !== undefined)) as unknown as BendSpec;
}

/** Every corner of plate `id` taken elsewhere. */
export function movePlate(spec: PlatesSpec, id: string, to: (p: Vec3) => Vec3): PlatesSpec {
  const place = (p: Vec3) => to(p).map((v) => round(v)) as Vec3;
  const moved = (plate: PlateSpec): PlateSpec => ({
    ...plate, outline: plate.outline.map(place), ...(plate.holes ? { holes: plate.holes.map((h) => h.map(place)) } : {}),
  });
  return { ...spec, plates: spec.plates.map((p) => (p.id === id ? moved(p) : p)) };
}

export function middleOf(plate: PlateSpec): Vec3 {
  const n = plate.outline.length;
  return [0, 1, 2].map((k) => plate.outline.reduce((sum, p) => sum + p[k]!, 0) / n) as Vec3;
}

/** Turned by `degrees` about the axis through `middle` along x, y or z. */
export function turned(p: Vec3, middle: Vec3, axis: 0 | 1 | 2, degrees: number): Vec3 {
  const a = (degrees * Math.PI) / 180, c = Math.cos(a), s = Math.sin(a), i = (axis + 1) % 3, j = (axis + 2) % 3;
  const out = [...p] as Vec3, u = p[i]! - middle[i]!, v = p[j]! - middle[j]!;
  out[i] = middle[i]! + c * u - s * v;
  out[j] = middle[j]! + s * u + c * v;
  return out;
}

/** "2 3" or "2, 3"; empty: chosen by the program. Null where it is no list. */
export function parseEdges(text: string): number[] | undefined | null {
  const words = text.split(/[\s,;]+/).filter(Boolean);
  if (words.length === 0) return undefined;
  const numbers = words.map(Number);
  return numbers.every((n) => Number.isInteger(n) && n >= 0) ? numbers : null;
}
