import type { LengthUnit, MakerRow, Options } from './types.ts';
import type { DisplayUnit } from './units.ts';

/** How a DXF is written, as last chosen on this machine; what is left out is as the program has it. */
export type DxfChoices = Pick<
  Options,
  | 'units'
  | 'r12'
  | 'profile'
  | 'bend_marks'
  | 'tick_length'
  | 'tangent_lines'
  | 'splines'
  | 'arc_tolerance'
  | 'bend_text'
  | 'turn_to_blank'
>;

const kinds: Record<keyof DxfChoices, 'word' | 'flag' | 'number'> = {
  units: 'word',
  r12: 'flag',
  profile: 'word',
  bend_marks: 'word',
  tick_length: 'number',
  tangent_lines: 'flag',
  splines: 'word',
  arc_tolerance: 'number',
  bend_text: 'flag',
  turn_to_blank: 'flag',
};
const names = Object.keys(kinds) as (keyof DxfChoices)[];

/** Choices from what was kept, which an older or a newer page may have written: only what can be meant. */
export function soundChoices(kept: unknown): DxfChoices {
  if (typeof kept !== 'object' || kept === null) return {};
  const rows = kept as Record<string, unknown>,
    is = { word: 'string', flag: 'boolean', number: 'number' };
  return Object.fromEntries(names.flatMap((n) => (typeof rows[n] === is[kinds[n]] ? [[n, rows[n]]] : [])));
}

/** The unit of the DXF: that of the page until another is chosen. */
export const dxfUnit = (choices: DxfChoices, page: DisplayUnit): LengthUnit => choices.units ?? page;

/** The options of a request for a DXF: what the maker takes, and nothing that contradicts something else. */
export function dxfOptions(choices: DxfChoices, maker: MakerRow, page: DisplayUnit): DxfChoices {
  const all: DxfChoices = { ...choices, units: dxfUnit(choices, page) };
  if (all.bend_marks !== 'ticks') delete all.tick_length;
  if (all.r12 && all.splines === 'keep') delete all.splines;
  if (all.splines === 'keep') delete all.arc_tolerance;
  return Object.fromEntries(
    names.flatMap((name) => {
      const row = maker.options.find((o) => o.name === name),
        value = all[name];
      const possible = row && value !== undefined && (kinds[name] !== 'word' || row.words.includes(String(value)));
      return possible ? [[name, value]] : [];
    }),
  );
}
