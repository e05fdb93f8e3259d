import { changesBefore } from './panels/bend-order.ts';
import { bendText, pickedEdgeText, pickedRow } from './picked.ts';
import { knownPiece, pieceOf } from './report.ts';
import { refusedPlaces } from './refused-solid.ts';
import { byPlates, sentence } from './said.ts';
import { isStopped, turnAt } from './stage.ts';
import { isInMachine, type State } from './state.ts';
import { clean, lengthText, unitName } from './units.ts';

/** The views in words, for those who do not see them. */
export const foldedText = (state: State): string => partText(state) + measuringText(state);
export const flatText = (state: State): string => patternText(state) + measuringText(state);

const measuringText = ({ measure }: State) =>
  measure.on
    ? '. Arrow keys go from one thing to the next, Enter picks it, V goes to the other view, Escape ends measuring.'
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
  const text = (length: number | null) => lengthText(length, report?.units, units);
  return `Flat pattern of ${d.name}, ${text(flat.size[0])} by ${text(flat.size[1])} ${unitName(units)}, ${count(
    flat.bends.length,
    'bend',
  )}, ${count(flat.openings ?? 0, 'opening')}`;
}

/** What the picture of the folded part shows besides: the stroke in the machine, or what is marked and cut. */
export function foldedDetail(state: State): string {
  if (!state.document) return '';
  if (isInMachine(state)) return strokeText(state);
  const { section, seeThrough } = state.view,
    { problem } = state;
  if (refusedPlaces(state).faces.length + refusedPlaces(state).edges.length) return sentence(problem!);
  return sentences([
    pickedText(state),
    section.on ? `Cut by a plane across ${section.axis === 'view' ? 'the view' : section.axis}` : '',
    seeThrough ? 'Seen through as glass' : '',
  ]);
}

/** What the picture of the pattern shows besides: its bends and their directions, and what is picked. */
export function flatDetail(state: State): string {
  const bends = (pieceOf(state)?.flat ?? knownPiece(state)?.flat)?.bends ?? [],
    named = bends.slice(0, mostNamed).map((b) => `${b.id} ${b.direction} ${clean(b.angle, 1)}°`),
    more = bends.length - named.length;
  return sentences([
    named.length ? `Bends: ${named.join(', ')}${more > 0 ? ` and ${more} more` : ''}` : '',
    pickedText(state),
  ]);
}

const mostNamed = 20; // bends; the table has them all

/** "Stroke 2 of 5: bend B3 to 90°, bent by 35° now. …" */
function strokeText(state: State): string {
  const { order } = state,
    strokes = order.answer!.strokes,
    at = Math.min(Math.floor(order.time), strokes.length - 1),
    row = strokes[at]!,
    share = order.time - at,
    now = order.playing ? '' : `, bent by ${clean(turnAt(row, share), 0)}° now`,
    changes = changesBefore(order.answer!, at),
    bends = `${row.bends.length > 1 ? 'bends' : 'bend'} ${row.bends.join(', ')}`,
    stopped = isStopped(row, share) ? 'It collides' : 'It cannot be made',
    { blocked } = row;
  const whole = row.flattening ? 'closed flat' : `to ${clean(row.angle, 1)}°`;
  return sentences([
    `Stroke ${at + 1} of ${strokes.length}: ${bends} ${whole}${now}`,
    changes.length ? `Before it: ${changes.join(', ')}` : '',
    blocked ? `${stopped}: ${byPlates(state, blocked)}` : '',
  ]);
}

function pickedText(state: State): string {
  const row = pickedRow(state),
    bend = row === null ? null : bendText(state, row),
    text =
      pickedEdgeText(state) ??
      bend ??
      (row === null ? null : (state.shape!.parts[row]!.plate ?? state.shape!.parts[row]!.name));
  return text ? `Picked: ${text}` : '';
}

const sentences = (all: string[]) =>
  all
    .filter(Boolean)
    .map((s) => (/[.!?]$/.test(s) ? s : `${s}.`))
    .join(' ');

const count = (n: number, what: string) => `${n} ${what}${n === 1 ? '' : 's'}`;
