import type { Vec2 } from '../types.ts';
import { fileDigits, round } from '../units.ts';
import { bezierPoints, lowered, raised, removeAnchor, removePoint } from './slit.ts';
import type { CurveName, FlatCurveName, SlitSpec } from './slit-types.ts';

/** A slit, or a part of the outline, on the flat sheet: (along, across) in the file's unit. */
export interface FlatCurve {
  name: FlatCurveName;
  control: Vec2[];
  drawn: Vec2[];
  smooth: boolean; // poles of a Bézier curve, not corners
}

type CurveSpec = NonNullable<SlitSpec['slits']>[number];
type ListName = 'slits' | 'outline';

const controlOf = (curve: CurveSpec) => (curve.bezier ?? curve.points ?? []) as Vec2[];

const curvesIn = (spec: SlitSpec, list: ListName): FlatCurve[] =>
  (spec[list] ?? []).map((curve, i) => ({
    name: `${list}-${i}`,
    control: controlOf(curve),
    drawn: curve.bezier ? bezierPoints(controlOf(curve)) : controlOf(curve),
    smooth: curve.bezier !== undefined,
  }));

/** Nothing where slits are the straight borders of strips. */
export const flatCurves = (spec: SlitSpec): FlatCurve[] =>
  spec.slits ? [...curvesIn(spec, 'slits'), ...curvesIn(spec, 'outline')] : [];

export const isFlatCurve = (name: string): name is FlatCurveName => /^(slits|outline)-\d+$/.test(name);

function changed(spec: SlitSpec, name: FlatCurveName, change: (control: Vec2[], smooth: boolean) => Vec2[]): SlitSpec {
  const [list, number] = name.split('-') as [ListName, string],
    curves = spec[list];
  return {
    ...spec,
    [list]: curves?.map((curve, i) =>
      i !== Number(number)
        ? curve
        : curve.bezier
          ? { bezier: change(controlOf(curve), true) }
          : { points: change(controlOf(curve), false) },
    ),
  };
}

/** Where a slit ends with the strips it stays there, along the sheet. */
export function moveFlatPoint(spec: SlitSpec, name: FlatCurveName, index: number, at: Vec2): SlitSpec {
  const digits = fileDigits(spec.units),
    far = spec.sheet.panel_height + spec.sheet.half_length,
    stays = (p: Vec2) => name.startsWith('slits') && round(p[0], digits) === round(far, digits),
    placed = (p: Vec2): Vec2 => [stays(p) ? p[0] : round(at[0], digits), round(at[1], digits)];
  return changed(spec, name, (control) => {
    const isEnd = index === 0 || index === control.length - 1;
    return control.map((p, i) => (i !== index ? p : isEnd ? placed(p) : (at.map((v) => round(v, digits)) as Vec2)));
  });
}

/** An inner point of any curve; its ends stay. */
const removeCurvePoint = (spec: SlitSpec, name: CurveName | FlatCurveName, index: number): SlitSpec =>
  isFlatCurve(name) ? changed(spec, name, (control) => lowered(control, index)) : removePoint(spec, name, index);

interface CurvePoint {
  curve: CurveName | FlatCurveName;
  index: number;
}

/** Without the chosen point of a curve, or the chosen anchor. */
export function withoutChosen(spec: SlitSpec, point: CurvePoint | null, anchor: number | null): SlitSpec {
  if (point) return removeCurvePoint(spec, point.curve, point.index);
  return anchor === null ? spec : removeAnchor(spec, anchor);
}

/** One more point: of a Bézier curve that leaves it as it is, of a chain a corner in the middle after `index`. */
export const addFlatPoint = (spec: SlitSpec, name: FlatCurveName, index: number): SlitSpec =>
  changed(spec, name, (control, smooth) => {
    if (smooth) return raised(control);
    const from = Math.min(index, control.length - 2),
      [a, b] = [control[from]!, control[from + 1]!],
      middle = a.map((v, k) => round((v + b[k]!) / 2, fileDigits(spec.units))) as Vec2;
    return [...control.slice(0, from + 1), middle, ...control.slice(from + 1)];
  });

export function removeSlit(spec: SlitSpec, slit: number): SlitSpec {
  return { ...spec, slits: spec.slits?.filter((_, i) => i !== slit) };
}

/** Strips of one width as such curves, straight to begin with; null where slits are otherwise. */
export function withCurvedSlits(spec: SlitSpec): SlitSpec | null {
  const { strips, strip_width: wide, panel_height: begin, half_length: long } = spec.sheet;
  if (typeof strips !== 'number' || strips < 2 || !wide || spec.sheet.margin) return null;
  const digits = fileDigits(spec.units);
  const slit = (number: number) => ({
    bezier: [0, 1, 2, 3].map((k): Vec2 => [round(begin + (k * long) / 3, digits), round(number * wide, digits)]),
  });
  return {
    ...spec,
    sheet: { width: round(strips * wide), panel_height: begin, half_length: long },
    slits: Array.from({ length: strips - 1 }, (_, i) => slit(i + 1)),
  };
}
