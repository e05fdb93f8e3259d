import { sentence } from './said.ts';
import type { Input } from './state.ts';
import { solidImage } from './solid-picture.ts';
import type { ApiProblem, FlatSize, LengthUnit, Options, Report, Shape, Vec2 } from './types.ts';

/** What became of a body, as far as is known. */
export interface BodyStatus {
  status: Report['status'];
  code?: string; // of a refusal
  message?: string;
  units?: LengthUnit;
  thickness?: number | null;
  size?: FlatSize; // of the blank
  pierces?: number;
  picture?: Picture;
  of: Options; // what was asked for
}
export type Bodies = Record<number, BodyStatus>;

/** A flat pattern, small: paths in a box of at most `extent`, y down. Without a pattern an image of the solid. */
export interface Picture {
  width: number;
  height: number;
  image?: string; // data URL
  sheet: string;
  up: string;
  down: string;
}

/** What is said of one body only waits for it while another is looked at. */
const ofOneBody = new Set(['body', 'root', 'up', 'bend_k', 'rip_edges', 'piece']);

const only = (options: Options, wanted: (name: string) => boolean): Options =>
  Object.fromEntries(Object.entries(options).filter(([name]) => wanted(name))) as Options;

/** The options that hold for every body of an assembly. */
export const sharedOptions = (options: Options): Options => only(options, (name) => !ofOneBody.has(name));

/** The options of a body, `shown` or another. */
export const optionsOf = ({ options, others }: Input, body: number, shown: number): Options =>
  body === shown ? options : { ...sharedOptions(options), ...others?.[body] };

/** The input that shows another body, with what was set for it. */
export function withBody(input: Input, shown: number, body: number): Input {
  const { [body]: _, ...rest } = input.others ?? {},
    left = only(input.options, (name) => ofOneBody.has(name) && name !== 'body'),
    others = Object.keys(left).length ? { ...rest, [shown]: left } : rest;
  return { ...input, options: { ...optionsOf(input, body, shown), body }, others };
}

/** Whether the same was asked for, of whichever body. */
export function sameOptions(a: Options, b: Options): boolean {
  const names = new Set([...Object.keys(a), ...Object.keys(b)]) as Set<keyof Options>;
  names.delete('body');
  names.delete('density'); // which the list says nothing of
  return [...names].every((name) => a[name] === b[name]);
}

export function statusOfShape(shape: Shape, of: Options): BodyStatus {
  const { report } = shape,
    { sheet, flat } = report,
    picture = pictureOf(shape);
  return {
    ...refusal(report.reason, report.status),
    of,
    units: report.units,
    ...(sheet ? { thickness: sheet.thickness } : {}),
    ...(flat ? { size: flat.size } : {}),
    ...(shape.pierces === null ? {} : { pierces: shape.pierces }),
    ...(picture ? { picture } : {}),
  };
}

export const refused = (problem: ApiProblem, of: Options): BodyStatus => ({ ...refusal(problem, 'refused'), of });

const refusal = (
  problem: ApiProblem | null,
  status: Report['status'],
): Pick<BodyStatus, 'status' | 'code' | 'message'> =>
  problem ? { status, code: problem.code, message: sentence(problem) } : { status };

const extent = 100;
const least = 0.8; // of the extent: what is closer is one point, what is smaller is left out

/** The pattern as it lies, for a list; where there is none, the solid. */
export const pictureOf = (shape: Shape): Picture | undefined => patternPicture(shape) ?? solidPicture(shape);

function solidPicture(shape: Shape): Picture | undefined {
  const image = shape.space_faces.length ? solidImage(shape) : null;
  if (!image) return undefined;
  const { width, height, url } = image;
  return { width: width * extent, height: height * extent, image: url, sheet: '', up: '', down: '' };
}

function patternPicture(shape: Shape): Picture | undefined {
  const { contour_points: p, contour_starts, contour_part, bend_lines, bend_line_part, parts } = shape;
  const rings = [...contour_part.keys()].filter((c) => contour_part[c] === -1);
  let [left, bottom, right, top] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const c of rings)
    for (let i = contour_starts[c]!; i < contour_starts[c + 1]!; ++i) {
      [left, right] = [Math.min(left, p[2 * i]!), Math.max(right, p[2 * i]!)];
      [bottom, top] = [Math.min(bottom, p[2 * i + 1]!), Math.max(top, p[2 * i + 1]!)];
    }
  const largest = Math.max(right - left, top - bottom);
  if (!(largest > 0)) return undefined;
  const scale = extent / largest,
    at = (x: number, y: number): Vec2 => [(x - left) * scale, (top - y) * scale],
    text = ([x, y]: Vec2) => `${+x.toFixed(1)} ${+y.toFixed(1)}`;
  const ring = (c: number) => {
    const kept: Vec2[] = [];
    for (let i = contour_starts[c]!; i < contour_starts[c + 1]!; ++i) {
      const next = at(p[2 * i]!, p[2 * i + 1]!),
        last = kept.at(-1);
      if (!last || Math.hypot(next[0] - last[0], next[1] - last[1]) >= least) kept.push(next);
    }
    return kept.length > 2 ? `M${kept.map(text).join('L')}Z` : '';
  };
  const lines = (direction: string) =>
    [...bend_line_part.keys()]
      .filter((b) => parts[bend_line_part[b]!]?.direction === direction)
      .map((b) => {
        const [x0, y0, x1, y1] = bend_lines.subarray(4 * b, 4 * b + 4) as unknown as [number, number, number, number];
        return `M${text(at(x0, y0))}L${text(at(x1, y1))}`;
      })
      .join('');
  return {
    width: (right - left) * scale,
    height: (top - bottom) * scale,
    sheet: rings.map(ring).join(''),
    up: lines('up'),
    down: lines('down'),
  };
}
