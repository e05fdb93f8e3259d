import type { SlitSpec, StripEnd, StripSpec } from './slit-types.ts';
import type { Vec3 } from '../types.ts';
import { fileDigits, round } from '../units.ts';
import { minus, normalised, plus, scaled } from '../vectors.ts';
import { scaledLegs } from './panels.ts';

type Sheet = SlitSpec['sheet'];

/** The strips one by one; none where slits are curves. */
export const stripsOf = ({ strips = [], strip_width }: Sheet): StripSpec[] =>
  typeof strips === 'number' ? Array.from({ length: strips }, () => ({ width: strip_width ?? 0 })) : strips;

const widthOf = (sheet: Sheet) => stripsOf(sheet).reduce((sum, s) => sum + s.width + (s.gap ?? 0), sheet.margin ?? 0);
export const sheetWidth = (spec: SlitSpec): number => (spec.slits ? curvedWidth(spec) : widthOf(spec.sheet));

/** Of a sheet with curves for slits: as told, or that of its outline's points. */
function curvedWidth({ sheet, outline }: SlitSpec): number {
  const across = (outline ?? []).flatMap((part) => (part.points ?? part.bezier ?? []).map((p) => p[1] ?? 0));
  return sheet.width ?? (across.length ? Math.max(...across) - Math.min(...across) : 0);
}

/** The sheet with strips that have their own widths. */
const withStrips = ({ strip_width: _one, ...sheet }: Sheet, strips: StripSpec[]): Sheet => ({ ...sheet, strips });

/** Another sheet. Leg curves grow and shrink with the sheet's width. */
function withSheet(spec: SlitSpec, sheet: Sheet): SlitSpec {
  const before = widthOf(spec.sheet),
    after = widthOf(sheet);
  return before === after || before <= 0 ? { ...spec, sheet } : scaledLegs({ ...spec, sheet }, after / before);
}

export const setStripWidth = (spec: SlitSpec, strip_width: number): SlitSpec =>
  withSheet(spec, { ...spec.sheet, strips: stripsOf(spec.sheet).length, strip_width });

export const setMargin = (spec: SlitSpec, margin: number): SlitSpec => withSheet(spec, { ...spec.sheet, margin });

/** A number of strips of one width. */
export function setStripCount(spec: SlitSpec, strips: number): SlitSpec {
  const { strip_width = stripsOf(spec.sheet)[0]?.width ?? 0 } = spec.sheet;
  return renumbered(withSheet(spec, { ...spec.sheet, strips, strip_width }), (i) => (i < strips ? i : null));
}

/** Gives each strip its own width, leaving the sheet unchanged. */
export function ownWidths(spec: SlitSpec): SlitSpec {
  return { ...spec, sheet: withStrips(spec.sheet, stripsOf(spec.sheet)) };
}

/** The same number of strips, of one width without gaps, on a sheet of the same width. */
export function uniform(spec: SlitSpec): SlitSpec {
  const strips = stripsOf(spec.sheet).length;
  return {
    ...spec,
    sheet: { ...spec.sheet, strips, strip_width: round((widthOf(spec.sheet) - (spec.sheet.margin ?? 0)) / strips) },
  };
}

/** `patch` on a strip of its own width; keys that are undefined are left out. */
export function setStrip(spec: SlitSpec, index: number, patch: Partial<StripSpec>): SlitSpec {
  const changed = (s: StripSpec) =>
    Object.fromEntries(Object.entries({ ...s, ...patch }).filter(([, v]) => v !== undefined)) as unknown as StripSpec;
  const strips = stripsOf(spec.sheet).map((s, i) => (i === index ? changed(s) : s));
  return withSheet(spec, withStrips(spec.sheet, strips));
}

/** Adds a strip like the one at `index`, after it. */
export function addStrip(spec: SlitSpec, index: number): SlitSpec {
  const strips = stripsOf(spec.sheet),
    sheet = withStrips(spec.sheet, [...strips.slice(0, index + 1), strips[index]!, ...strips.slice(index + 1)]);
  return renumbered(withSheet(spec, sheet), (i) => (i > index ? i + 1 : i));
}

/** Removes a strip with everything that belongs to it. The last one stays. */
export function removeStrip(spec: SlitSpec, index: number): SlitSpec {
  const strips = stripsOf(spec.sheet).filter((_, i) => i !== index);
  if (!strips.length) return spec;
  const less = withSheet(spec, withStrips(spec.sheet, strips));
  return renumbered(less, (i) => (i === index ? null : i > index ? i - 1 : i));
}

/** Updates references to strips whose numbers have changed; null: the strip is gone. */
function renumbered(spec: SlitSpec, to: (strip: number) => number | null): SlitSpec {
  const of = <T extends { strip?: number }>(list: T[] | undefined) =>
    list?.flatMap((item) => {
      if (item.strip === undefined) return [item]; // a scan of any strip
      const strip = to(item.strip);
      return strip === null ? [] : [{ ...item, strip }];
    });
  const lists = { anchors: of(spec.anchors), ends: of(spec.ends), scan: of(spec.scan) },
    { anchors: _a, ends: _e, scan: _s, ...rest } = spec;
  return { ...rest, ...Object.fromEntries(Object.entries(lists).filter(([, list]) => list?.length)) };
}

export const endOf = (spec: SlitSpec, strip: number): StripEnd | undefined => spec.ends?.find((e) => e.strip === strip);

/** `patch` on a strip's end; undefined members are free, and a completely free end is omitted. */
export function setEnd(spec: SlitSpec, strip: number, patch: Omit<Partial<StripEnd>, 'strip'>): SlitSpec {
  const end = Object.fromEntries(
    Object.entries({ ...endOf(spec, strip), strip, ...patch }).filter(([, v]) => v !== undefined),
  ) as unknown as StripEnd;
  const others = (spec.ends ?? []).filter((e) => e.strip !== strip),
    ends = Object.keys(end).length > 1 ? [...others, end].sort((a, b) => a.strip - b.strip) : others;
  const { ends: _before, ...rest } = spec;
  return ends.length ? { ...rest, ends } : rest;
}

/** How a strip ends now, in the unit of the file: from its ridges in millimetres, of which `scale` make one. */
export function endAsItIs(
  spec: SlitSpec,
  ridges: [Vec3, Vec3][],
  scale: number,
): Omit<Required<StripEnd>, 'strip'> | null {
  const middle = ([left, right]: [Vec3, Vec3]) => scaled(plus(left, right), 0.5),
    last = ridges.at(-1),
    before = ridges.at(-2);
  if (!last || !before) return null;
  const rounded = (v: Vec3, digits: number) => v.map((x) => round(x, digits)) as Vec3;
  return {
    position: rounded(scaled(middle(last), 1 / scale), fileDigits(spec.units)),
    direction: rounded(normalised(minus(middle(last), middle(before))), 6),
    across: rounded(normalised(minus(last[1], last[0])), 6),
  };
}
