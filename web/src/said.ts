/** What a message states, by name. */
export type Numbers = Record<string, { value: number | null; unit: string }>;

/** What a message names, as data: docs/formats.md#places. */
export interface Place {
  kind:
    | 'face'
    | 'edge'
    | 'body'
    | 'flange'
    | 'bend'
    | 'plate'
    | 'strip'
    | 'ridge'
    | 'stroke'
    | 'point'
    | 'pointer'
    | 'line';
  id?: number | string;
  faces?: number[]; // that meet at an edge
  at?: number[];
}

/** A piece of a message: plain text, or what it names, which the page may say its own way. */
export interface Piece {
  text: string;
  option?: string; // as in requests: "rip_edges"
  place?: Place;
}

/** An option that does away with a finding or a refusal, and what it does; or what to change in the input. */
export interface Remedy {
  option?: string; // as on the command line: "--rip-edges"
  value?: string;
  change?: string;
}

/** A message with the options that it names in words. */
export const sentence = ({ message, wording }: { message: string; wording?: Piece[] }): string =>
  wording?.map(({ text, option }) => (option ? `“${option.replaceAll('_', ' ')}”` : text)).join('') ?? message;
