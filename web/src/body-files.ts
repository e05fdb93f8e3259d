import { digits } from './amounts.ts';
import { clean, convert, sizeText } from './units.ts';
import type { LengthUnit, Report } from './types.ts';

// The names of the files that `planish unfold --all` writes, and its summary.csv with figures as the page shows them.

const longest = 100; // bytes of a name

/** A name that any system takes: letters, digits, "-", "_" and "."; other signs become "_". */
export function safeName(name: string): string {
  let safe = '',
    size = 0;
  for (const sign of name) {
    const next = /^[\p{L}\p{N}\p{M}._-]$/u.test(sign) ? sign : '_';
    if (next === '_' && sign !== '_' && safe.endsWith('_')) continue;
    size += new TextEncoder().encode(next).length;
    if (size > longest) break;
    safe += next;
  }
  safe = safe.replace(/^[.-]+/, '').replace(/[._]+$/, '');
  return safe || 'body';
}

/** The stem of each body's files; those of bodies without a pattern are empty. */
export function stems(reports: Report[]): string[] {
  const taken = new Set<string>();
  return reports.map((report) => {
    if (!hasPattern(report)) return '';
    const thickness = convert(report.sheet?.thickness ?? 0, report.units, 'mm'),
      wanted = `${safeName(report.body ?? '')}_t${Number(thickness.toFixed(3))}`;
    let stem = wanted;
    for (let n = 2; taken.has(stem.toLowerCase()); ++n) stem = `${wanted}-${n}`;
    taken.add(stem.toLowerCase());
    return stem;
  });
}

export const hasPattern = (report: Report) => report.status !== 'refused' && report.flat !== null;

const columns = [
  'number',
  'body',
  'quantity',
  'status',
  'reason',
  'message',
  'units',
  'thickness',
  'length',
  'width',
  'area',
  'outer_cutting',
  'inner_cutting',
  'openings',
  'pierces',
  'bends',
  'mass',
  'volume_ratio',
  'length_error',
  'refold_deviation',
  'warnings',
  'files',
];

/** Hundredths of a millimetre, and about as much. */
const lengthDigits: Record<LengthUnit, number> = { mm: 2, inch: 3, m: 5 };

/** What a row of the summary is made of; `pierces`: contours and slits that are cut, which the report leaves out. */
export interface SummaryRow {
  report: Report;
  pierces: number | null;
  files: string[];
}

export function summaryCsv(rows: SummaryRow[]): string {
  const cells = rows.map(({ report: r, pierces, files }) => {
    const length = (v: number | null | undefined, more = 0) => known(v, (x) => clean(x, lengthDigits[r.units] + more)),
      v = r.verification;
    return [
      r.body_number,
      r.body,
      r.quantity,
      r.status,
      r.reason?.code,
      r.reason?.message,
      r.units,
      length(r.sheet?.thickness, 1),
      length(r.flat?.size[0]),
      length(r.flat?.size[1]),
      known(r.flat?.area, digits),
      length(r.flat?.cutting?.outer),
      length(r.flat?.cutting?.inner),
      r.flat?.openings,
      pierces,
      r.sheet?.bends,
      known(r.sheet?.mass, (kg) => (kg < 1 ? clean(Number(kg.toPrecision(4)), 9) : digits(kg))),
      known(v?.volume_ratio, (ratio) => clean(ratio, 6)),
      known(v?.length_error, sizeText),
      known(v?.refold_deviation, sizeText),
      r.checks.filter((c) => c.severity !== 'info').length,
      files.join(';'),
    ].map(cell);
  });
  return [columns, ...cells].map((row) => row.join(',') + '\n').join('');
}

const known = (value: number | null | undefined, text: (value: number) => string) =>
  typeof value === 'number' ? text(value) : undefined;

function cell(value: string | number | null | undefined): string {
  const text = String(value ?? '');
  return /[,;"\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
