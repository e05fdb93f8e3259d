import type { ReportSlitStanding, ReportSlit } from '../generated/report.ts';
import type { SlitSpec } from './edits/slit-types.ts';
import type { Shape, Vec3 } from './types.ts';
import { millimetres } from './units.ts';

/** What pushes a slit sheet and what it stands on, mm. */
export interface Forces {
  arrows: [Vec3, Vec3][]; // tail and tip, which is where the force acts
  centre: Vec3 | null; // of mass
  support: Vec3[]; // corners of what touches the ground
}

export const noForces: Forces = { arrows: [], centre: null, support: [] };

const longest = 0.25; // of the shape's size: the arrow of the largest force
const spreadOver = [1 / 6, 1 / 2, 5 / 6]; // where arrows stand for a force that is spread over a strip

export function forcesOf(shape: Shape | null, spec: Pick<SlitSpec, 'loads' | 'symmetric'> | null): Forces {
  const slit = shape?.report.slit,
    strips = shape?.handles.ridges;
  if (!slit || !strips) return noForces;
  const loads = (spec?.loads ?? []).flatMap(({ strip, at, force }) => {
    const rows = strips[strip];
    if (!rows?.length) return [];
    const places = at === undefined ? spreadOver : [at];
    return places.flatMap((share) => {
      const point = middleAt(rows, share),
        part = force.map((v) => (v ?? 0) / places.length) as Vec3;
      if (spec?.symmetric === false || Math.abs(point[0]) < 1e-6) return [{ point, part }];
      const half = part.map((v) => v / 2) as Vec3; // each half bears its own
      return [
        { point, part: half },
        { point: [-point[0], point[1], point[2]] as Vec3, part: half },
      ];
    });
  });
  const largest = Math.max(...loads.map(({ part }) => Math.hypot(...part)), 0),
    scale = largest > 0 ? (longest * sizeOf(strips)) / largest : 0;
  return {
    arrows: loads.map(({ point, part }) => [point.map((v, k) => v - scale * part[k]!) as Vec3, point]),
    ...standingOf(slit, millimetres(shape.report.units)),
  };
}

/** The middle of a strip, at a share of its length. */
function middleAt(rows: [Vec3, Vec3][], share: number): Vec3 {
  const at = share * (rows.length - 1),
    i = Math.min(Math.floor(at), rows.length - 2),
    middle = (row: [Vec3, Vec3] | undefined, k: number) => (row ? (row[0][k]! + row[1][k]!) / 2 : 0);
  return [0, 1, 2].map((k) => {
    const a = middle(rows[Math.max(i, 0)], k);
    return a + (at - i) * (middle(rows[i + 1] ?? rows[0], k) - a);
  }) as Vec3;
}

function sizeOf(strips: [Vec3, Vec3][][]): number {
  const points = strips.flat(2);
  return Math.hypot(
    ...[0, 1, 2].map((k) => Math.max(...points.map((p) => p[k]!)) - Math.min(...points.map((p) => p[k]!))),
  );
}

function standingOf({ standing }: ReportSlit, scale: number): Pick<Forces, 'centre' | 'support'> {
  if (!standing) return { centre: null, support: [] };
  const { centre_of_mass, support }: ReportSlitStanding = standing;
  return {
    centre: centre_of_mass.map((v) => (v ?? 0) * scale) as Vec3,
    support: support.map(([x, z]) => [(x ?? 0) * scale, 0, (z ?? 0) * scale]),
  };
}
