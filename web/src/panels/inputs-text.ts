import type { MakerRow } from '../types.ts';

/** "A STEP part to unfold, or a plates or transition file (JSON)." */
export function inputsText(makers: MakerRow[]): string {
  const kind = ({ input }: MakerRow) => input.replace(/ file$/, ''), // of "plates file"
    read = makers.filter((m) => !m.editable).map((m) => `a ${kind(m)} part to ${m.name}`),
    edited = makers.filter((m) => m.editable).map(kind),
    all = [...read, ...(edited.length ? [`a ${either(edited)} file (JSON)`] : [])].join(', or ');
  return all ? `${all[0]!.toUpperCase()}${all.slice(1)}.` : '\u00a0'; // the server says what there is
}

const either = (words: string[]) => [words.slice(0, -1).join(', '), ...words.slice(-1)].filter(Boolean).join(' or ');
