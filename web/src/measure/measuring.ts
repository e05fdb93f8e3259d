import { knownPiece, pieceOf } from '../report.ts';
import { isInMachine, type State } from '../state.ts';
import type { Palette } from '../theme.ts';
import { millimetres } from '../units.ts';
import type { Ui } from '../ui.ts';
import { alone, between, type Answer } from './answer.ts';
import { drawAnswer, drawThing, type Project } from './draw.ts';
import { isSame, type Measure } from './state.ts';
import { labelText } from './text.ts';
import type { Taken } from './text-place.ts';
import { thingOf, type Measured, type MeasuredView, type Ref } from './things.ts';

let last: { state: Pick<State, 'shape' | 'known' | 'result'>; of: Measured } | null = null;

/** What is measured; null where there is no pattern. */
export function measuredOf(state: State): Measured | null {
  const { shape, known, result } = state;
  if (!shape?.facet_parent.length) return null;
  if (last?.state.shape === shape && last.state.known === known && last.state.result === result) return last.of;
  const report = pieceOf(state)?.flat ? pieceOf(state) : knownPiece(state),
    thickness = report?.sheet?.thickness;
  if (!report || typeof thickness !== 'number') return null;
  const of = {
    shape,
    thickness: thickness * millimetres(report.units),
    bends: report.flat?.bends ?? [],
    units: report.units,
  };
  last = { state: { shape, known, result }, of };
  return of;
}

/** Only of the part as it is folded is it known exactly where everything is. */
export const isMeasurable = (state: State, view: MeasuredView): boolean =>
  measuredOf(state) !== null && (view === 'flat' || (state.fold > 0.999 && !isInMachine(state) && !state.stale));

export function answerOf(of: Measured, { view, a, b }: Pick<Measure, 'view' | 'a' | 'b'>): Answer | null {
  const from = thingOf(of, view, a),
    to = b && thingOf(of, view, b);
  if (!from || (b && !to)) return null;
  return to ? between(from, to, view === 'flat') : alone(from);
}

/** What is picked to be measured, and how it is drawn in both views. */
export class Measuring {
  private hovered: { view: MeasuredView; ref: Ref } | null = null;

  private readonly ui: Ui;
  private readonly redraw: (view: MeasuredView) => void;
  constructor(ui: Ui, redraw: (view: MeasuredView) => void) {
    this.ui = ui;
    this.redraw = redraw;
  }

  /** What can be picked in a view now; null: nothing. */
  in(view: MeasuredView): Measured | null {
    const { state } = this.ui;
    return state.measure.on && isMeasurable(state, view) ? measuredOf(state) : null;
  }

  hover(view: MeasuredView, ref: Ref | null) {
    const same = ref && this.hovered?.view === view && JSON.stringify(this.hovered.ref) === JSON.stringify(ref);
    if (same || (!ref && !this.hovered)) return;
    if (!ref && this.hovered?.view !== view) return; // the pointer is in the other view already
    this.hovered = ref && { view, ref };
    this.redraw('flat');
    this.redraw('folded');
  }

  pick(view: MeasuredView, ref: Ref | null) {
    const { state } = this.ui,
      of = this.in(view),
      { first } = state.measure,
      say = (note: string) => this.ui.dispatch({ type: 'note', note });
    if (!of) return say('Fold the part completely to measure it here.');
    if (!ref) return;
    if (!thingOf(of, view, ref)) return say('That has no single place: pick a flange or an edge beside it.');
    if (first?.view === view && !answerOf(of, { view, a: first.ref, b: isSame(first.ref, ref) ? null : ref }))
      return say('Those two have no distance and no angle: pick something else.');
    this.ui.dispatch({ type: 'note', note: null });
    this.ui.dispatch({ type: 'measure-pick', view, ref });
  }

  /** What is measured in a view, above it. */
  paint(view: MeasuredView, c: CanvasRenderingContext2D, project: Project, palette: Palette): boolean {
    const { state } = this.ui,
      { first, kept, on } = state.measure,
      of = isMeasurable(state, view) ? measuredOf(state) : null;
    if (!of) return false;
    const hovered = on && this.hovered?.view === view ? this.hovered.ref : null,
      start = first?.view === view ? first.ref : null,
      own = kept.filter((m) => m.view === view);
    const taken: Taken = [],
      texts = own.map((measure) => this.draw(c, project, of, measure, palette, taken));
    if (start && hovered && !isSame(start, hovered))
      texts.push(this.draw(c, project, of, { view, a: start, b: hovered }, palette, taken, true));
    for (const write of texts) write?.();
    for (const ref of [start, hovered]) {
      const thing = ref && thingOf(of, view, ref);
      if (thing) drawThing(c, project, ref.kind, thing, palette);
    }
    return own.length > 0 || start !== null || hovered !== null;
  }

  private draw(
    c: CanvasRenderingContext2D,
    project: Project,
    of: Measured,
    measure: Pick<Measure, 'view' | 'a' | 'b'>,
    palette: Palette,
    taken: Taken,
    faint = false,
  ) {
    const answer = answerOf(of, measure);
    return answer && drawAnswer(c, project, answer, labelText(answer, this.ui.state.units), palette, faint, taken);
  }
}
