import { knownPiece, pieceOf } from './report.ts';
import { refusedPlaces } from './refused-solid.ts';
import { isInMachine, type State } from './state.ts';
import { clean, lengthText, unitName } from './units.ts';

/** The views in words, for those who do not see them. */
export const foldedText = (state: State): string => partText(state) + measuringText(state);
export const flatText = (state: State): string => patternText(state) + measuringText(state);

const measuringText = ({ measure }: State) =>
  measure.on
    ? '. Arrow keys go from one thing to the next, Enter picks it, V goes to the other view, Escape ends.'
    : '';

function partText(state: State): string {
  const { document: d, fold } = state;
  if (!d) return 'Folded part: nothing is open';
  if (isInMachine(state)) return `${d.name} in the press brake`;
  const { faces, edges } = refusedPlaces(state),
    marked = [...faces, ...edges].map((named) => named.name).join(', ');
  if (state.problem && marked) return `Part ${d.name}, without a flat pattern; marked: ${marked}`;
  const { bends, flanges } = pieceOf(state)?.sheet ?? knownPiece(state)?.sheet ?? {};
  const parts = flanges === undefined ? '' : `: ${count(flanges, 'flange')}, ${count(bends ?? 0, 'bend')}`;
  return `Folded part ${d.name}${parts}; folded by ${clean(100 * fold, 0)} %`;
}

function patternText(state: State): string {
  const { document: d, units } = state;
  const report = pieceOf(state)?.flat ? pieceOf(state) : knownPiece(state),
    flat = report?.flat;
  if (!d || !flat) return 'Flat pattern: there is none';
  const text = (length: number) => lengthText(length, report?.units, units);
  return `Flat pattern of ${d.name}, ${text(flat.size[0])} by ${text(flat.size[1])} ${unitName(units)}, ${count(
    flat.bends.length,
    'bend',
  )}, ${count(flat.openings ?? 0, 'opening')}`;
}

const count = (n: number, what: string) => `${n} ${what}${n === 1 ? '' : 's'}`;
