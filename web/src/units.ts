import type { LengthUnit } from './types.ts';

export type DisplayUnit = 'mm' | 'inch';
const inMm: Record<LengthUnit, number> = { mm: 1, inch: 25.4, m: 1000 };

export const millimetres = (unit: LengthUnit | undefined) => inMm[unit ?? 'mm'];

/**
 * Decimals of a length that is placed by hand, in a file of this unit: thousandths of a millimetre and about as much.
 */
export const fileDigits = (unit: LengthUnit | undefined) => ({ mm: 3, inch: 4, m: 6 })[unit ?? 'mm'];

/** `value` given in `from`, in `to`. */
export const convert = (value: number, from: LengthUnit | undefined, to: LengthUnit) =>
  (value * millimetres(from)) / inMm[to];

/** A length for display: hundredths of a millimetre, thousandths of an inch. */
export function lengthText(value: number | null | undefined, from: LengthUnit | undefined, to: DisplayUnit): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  return clean(convert(value, from, to), to === 'inch' ? 3 : 2);
}

/** The thickness of a sheet, in thousandths of a millimetre, ten-thousandths of an inch. */
export const gaugeText = (value: number | null | undefined, from: LengthUnit | undefined, to: DisplayUnit) =>
  typeof value === 'number' ? clean(convert(value, from, to), to === 'inch' ? 4 : 3) : '–';

/** A residual length, of which only the size matters, with its unit. */
export const residualText = (value: number, from: LengthUnit | undefined, to: DisplayUnit) =>
  `${sizeText(convert(value, from, to))} ${unitName(to)}`;

export const unitName = (unit: DisplayUnit) => (unit === 'mm' ? 'mm' : 'in');

const tie = 1e-3; // of the last digit: values come by way of other units and of arrays of seven digits

/** `value` with at most `digits` decimals, without trailing zeros, never −0; of two that are as near the larger one. */
export function clean(value: number | null, digits: number): string {
  if (value === null) return '–';
  const scale = 10 ** digits,
    size = Math.round(Math.abs(value) * scale + tie) / scale,
    text = (value < 0 ? -size : size).toFixed(digits);
  const short = text.includes('.') ? text.replace(/\.?0+$/, '') : text;
  return short === '-0' ? '0' : short;
}

export const round = (value: number, digits = 6) => Number(value.toFixed(digits)) + 0;

/** 3e-9 rather than 3.141e-9: only the size of residuals matters. */
export function sizeText(value: number): string {
  if (value === 0) return '0';
  const e = Math.floor(Math.log10(Math.abs(value)));
  return e >= -3 ? clean(value, 4) : `${Math.round(Math.abs(value) / 10 ** e)}e${e}`;
}
