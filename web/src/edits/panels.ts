import type { LegCurve, MouldSpec, PanelName, SlitSpec } from './slit-types.ts';
import type { Vec2 } from '../types.ts';
import { fileDigits, round } from '../units.ts';
import { fitted, lengthOf } from './slit.ts';

/** The leg curve of a panel; undefined where there is no such panel. */
export const legOf = (spec: SlitSpec, panel: PanelName): LegCurve | undefined =>
  panel === 'leg' ? spec.leg_curve : spec.second_panel?.leg_curve;

/** `patch` on the leg curve of a panel; keys that are undefined are left out. */
export function setLeg(spec: SlitSpec, panel: PanelName, patch: Partial<LegCurve>): SlitSpec {
  const leg = legOf(spec, panel);
  if (!leg) return spec;
  const changed = without({ ...leg, ...patch });
  return panel === 'leg'
    ? { ...spec, leg_curve: changed }
    : { ...spec, second_panel: { ...spec.second_panel!, leg_curve: changed } };
}

/** Both leg curves, `factor` times as long; those that the program scales stay. */
export function scaledLegs(spec: SlitSpec, factor: number): SlitSpec {
  const longer = (s: SlitSpec, panel: PanelName) => {
    const leg = legOf(s, panel);
    return leg && !leg.fit ? setLeg(s, panel, { bezier: fitted(leg.bezier, factor * lengthOf(leg.bezier)) }) : s;
  };
  return longer(longer(spec, 'leg'), 'second');
}

const reached = 0.7; // of the way that strips could reach at most: they go up from one panel and come down to the other

/**
 * A panel like the first at the far ends of the strips, behind the first and in reach of all strips; it takes the place
 * of ends that are placed.
 */
export function addSecondPanel(spec: SlitSpec): SlitSpec {
  const { sheet, leg_curve } = spec,
    [from, to] = [leg_curve.bezier[0]!, leg_curve.bezier.at(-1)!],
    away: Vec2 = [from[1] - to[1], to[0] - from[0]],
    leaning = 2 * sheet.panel_height * Math.sin(((leg_curve.lean ?? 0) * Math.PI) / 180), // brings the edges nearer
    step = (reached * reachOf(sheet) + leaning) / (Math.hypot(...away) || 1),
    digits = fileDigits(spec.units);
  const bezier = leg_curve.bezier.map((p) => p.map((v, k) => round(v + step * away[k]!, digits)) as Vec2);
  const { ends: _placed, ...rest } = spec;
  return { ...rest, second_panel: { height: sheet.panel_height, leg_curve: { ...leg_curve, bezier } } };
}

/** How far away a second panel as high as the first may stand so that every strip reaches its edge. */
function reachOf({ strips, panel_height, half_length = 0 }: SlitSpec['sheet']): number {
  const ways = (typeof strips === 'object' ? strips : []).map(({ end, left_start, right_start }) => {
    const start = ((left_start ?? panel_height) + (right_start ?? panel_height)) / 2,
      last = end ?? panel_height + half_length,
      up = 2 * panel_height + half_length - last - start; // from edge to edge: the sheet ends in one line
    return Math.sqrt(Math.max(0, (last - start) ** 2 - up ** 2));
  });
  return ways.length ? Math.min(...ways) : half_length;
}

/**
 * A symmetric sheet as one that is not: its other half has a panel of its own, and the strips are as long as both
 * halves. What only symmetric sheets have, and what counts the ridges of one half, is left out.
 */
export function ownSecondPanel(spec: SlitSpec): SlitSpec {
  const { sheet, leg_curve } = spec,
    beyond = (end: number) => round(2 * end - sheet.panel_height);
  const half_length = 2 * sheet.half_length,
    whole: SlitSpec['sheet'] =
      typeof sheet.strips === 'object'
        ? {
            ...sheet,
            half_length,
            strips: sheet.strips.map((s) => (s.end === undefined ? s : { ...s, end: beyond(s.end) })),
          }
        : { ...sheet, half_length };
  const { seat_curve: _seat, end_angle: _angle, anchors: _anchors, scan: _scan, align_scan: _align, ...rest } = spec;
  return {
    ...rest,
    symmetric: false,
    sheet: whole,
    second_panel: {
      height: sheet.panel_height,
      leg_curve: { ...leg_curve, bezier: leg_curve.bezier.map(([x, z]): Vec2 => [round(-x), z]) },
    },
  };
}

export function removeSecondPanel(spec: SlitSpec): SlitSpec {
  const { second_panel: _gone, ...rest } = spec;
  return rest;
}

/** `patch` on the mould; keys that are undefined are left out, and so is a mould without any. */
export function setMould(spec: SlitSpec, patch: Partial<MouldSpec>): SlitSpec {
  const mould = without({ ...spec.mould, ...patch }),
    { mould: _before, ...rest } = spec;
  return Object.keys(mould).length ? { ...rest, mould } : rest;
}

const without = <T extends object>(o: T): T =>
  Object.fromEntries(Object.entries(o).filter(([, v]) => v !== undefined)) as T;
