import { convert } from './units.ts';
import type { Report } from './types.ts';

// What `planish unfold --all` writes: the names of its files and its summary.csv.

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
  'bends',
  'mass',
  'volume_ratio',
  'length_error',
  'refold_deviation',
  'warnings',
  'files',
];

export function summaryCsv(rows: { report: Report; files: string[] }[]): string {
  const cells = rows.map(({ report: r, files }) =>
    [
      r.body_number,
      r.body,
      r.quantity,
      r.status,
      r.reason?.code,
      r.reason?.message,
      r.units,
      r.sheet?.thickness,
      r.flat?.size[0],
      r.flat?.size[1],
      r.flat?.area,
      r.flat?.cutting?.outer,
      r.flat?.cutting?.inner,
      r.flat?.openings,
      r.sheet?.bends,
      r.sheet?.mass,
      r.verification?.volume_ratio,
      r.verification?.length_error,
      r.verification?.refold_deviation,
      r.checks.filter((c) => c.severity !== 'info').length,
      files.join(';'),
    ].map(cell),
  );
  return [columns, ...cells].map((row) => row.join(',') + '\n').join('');
}

function cell(value: string | number | null | undefined): string {
  const text = typeof value === 'number' ? numberText(value) : (value ?? '');
  return /[,;"\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** 1e-05, as C++ writes it: below 1e-4 with an exponent of two digits. */
function numberText(value: number): string {
  if (value === 0 || Math.abs(value) >= 1e-4) return String(value);
  return value.toExponential().replace(/e([+-])(\d)$/, 'e$10$2');
}
