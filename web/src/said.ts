import type { State } from './state.ts';
import type { ApiProblem, Wording } from './types.ts';

/** A message with the options that it names in words. */
export const sentence = ({
  message,
  wording,
}: Pick<ApiProblem, 'message'> & Partial<Pick<ApiProblem, 'wording'>>): string =>
  wording?.map(({ text, option }) => (option ? `“${option.replaceAll('_', ' ')}”` : text)).join('') ?? message;

/** The plate that a flange was made of, by the flange's name; that name where it was made of none. */
export const plateOf = ({ shape }: Pick<State, 'shape'>, name: string): string =>
  shape?.parts.find((p) => p.name === name)?.plate ?? name;

/** A sentence with the flanges of plates by the names of their plates. */
export const byPlates = (
  state: Pick<State, 'shape'>,
  { sentence, wording = [] }: { sentence: string | null; wording?: Wording },
): string => {
  const said = wording.map(({ text, place }) => {
    if (place?.kind !== 'flange') return text;
    const name = `F${place.id}`,
      plate = plateOf(state, name);
    return plate === name ? text : plate;
  });
  return said.length ? said.join('') : (sentence ?? '');
};
