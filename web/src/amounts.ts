import type { LengthUnit } from './types.ts';
import { clean, millimetres, type DisplayUnit } from './units.ts';

/** An area with its unit: square metres or feet from where square millimetres or inches are hard to read. */
export function areaText(value: number | null | undefined, from: LengthUnit | undefined, to: DisplayUnit): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  const mm2 = value * millimetres(from) ** 2;
  if (to === 'inch') {
    const in2 = mm2 / 25.4 ** 2;
    return in2 < 1440 ? `${digits(in2)} in²` : `${digits(in2 / 144)} ft²`;
  }
  return mm2 < 1e5 ? `${digits(mm2)} mm²` : `${digits(mm2 / 1e6)} m²`;
}

const pound = 0.45359237; // kg

export function massText(kg: number | null | undefined, to: DisplayUnit): string {
  if (kg === null || kg === undefined || !Number.isFinite(kg)) return '–';
  if (to === 'inch') return kg < pound ? `${digits((16 * kg) / pound)} oz` : `${digits(kg / pound)} lb`;
  return kg < 1 ? `${digits(1000 * kg)} g` : `${digits(kg)} kg`;
}

/** Four digits, or all those before the point. */
export const digits = (value: number) =>
  value >= 1000 ? value.toFixed(0) : clean(value, Math.max(0, 3 - Math.floor(Math.log10(Math.max(value, 1e-3)))));
