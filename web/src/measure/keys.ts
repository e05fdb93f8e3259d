import { escapeMeasuring } from '../panels/measures.ts';
import type { State } from '../state.ts';
import type { Vec2, Vec3 } from '../types.ts';
import type { Ui } from '../ui.ts';
import { answerOf, measuredOf, type Measuring } from './measuring.ts';
import { isSame } from './state.ts';
import { apart, arrows, nearestTo, stopsOf, towards, type Stop } from './stops.ts';
import { labelText, nameOfRef, wholeText } from './text.ts';
import type { Measured, MeasuredView, Ref } from './things.ts';

/** A view in which keys measure. */
export interface KeyedView {
  box: HTMLElement; // takes the focus
  toClient(at: Vec3): { x: number; y: number };
  isSeen(at: Vec3): boolean;
  light(part: number | null): void;
}

const views: MeasuredView[] = ['folded', 'flat'];

/**
 * Measuring by keys: arrow keys go from one thing to the next in their direction, the first being that nearest to the
 * middle of the view; Enter picks, V goes to the other view. What is marked is said.
 */
export class MeasureKeys {
  private at: Partial<Record<MeasuredView, Ref>> = {};
  private readonly said = document.createElement('p');

  private readonly ui: Ui;
  private readonly measuring: Measuring;
  private readonly keyed: Record<MeasuredView, KeyedView>;
  constructor(ui: Ui, measuring: Measuring, keyed: Record<MeasuredView, KeyedView>) {
    this.ui = ui;
    this.measuring = measuring;
    this.keyed = keyed;
    this.said.className = 'away';
    this.said.role = 'status';
    this.said.dataset.testid = 'measure-said';
    keyed.folded.box.parentElement!.append(this.said);
    for (const view of views) keyed[view].box.addEventListener('keydown', (e) => this.pressed(view, e));
  }

  /** Views take the focus while one measures in them. */
  changed(state: State, before: State) {
    if (state.shape !== before.shape) this.at = {};
    if (state.measure.on === before.measure.on) return;
    this.at = {};
    this.said.textContent = '';
    for (const view of views) {
      const { box } = this.keyed[view];
      box.role = state.measure.on ? 'application' : 'img';
      if (state.measure.on) box.tabIndex = 0;
      else {
        box.removeAttribute('tabindex');
        box.blur();
        this.keyed[view].light(null);
      }
    }
  }

  /** Begins in the flat pattern. */
  focus() {
    if (this.ui.state.measure.on) this.keyed.flat.box.focus();
  }

  /** All things that can be picked in a view, whether they are seen or not. */
  stops(view: MeasuredView): Stop[] {
    const of = this.measuring.in(view);
    return of ? stopsOf(of, view) : [];
  }

  private pressed(view: MeasuredView, e: KeyboardEvent) {
    const { measure } = this.ui.state,
      way = arrows[e.key];
    if (!measure.on || e.ctrlKey || e.metaKey || e.altKey) return;
    if (way) this.step(view, way);
    else if (e.key === 'Enter') this.pick(view);
    else if (e.key === 'Escape') escapeMeasuring(this.ui);
    else if (e.key.toLowerCase() === 'v') this.keyed[view === 'flat' ? 'folded' : 'flat'].box.focus();
    else return;
    e.preventDefault();
    e.stopPropagation();
  }

  private step(view: MeasuredView, way: Vec2) {
    const of = this.measuring.in(view);
    if (!of) return this.measuring.pick(view, null); // which says why not
    const { box, toClient, isSeen } = this.keyed[view],
      stops = stopsOf(of, view),
      places = apart(stops.map(({ at }) => [toClient(at).x, toClient(at).y])),
      last = this.at[view],
      now = last ? stops.findIndex(({ ref }) => JSON.stringify(ref) === JSON.stringify(last)) : -1,
      r = box.getBoundingClientRect();
    const order =
        now < 0 ? nearestTo(places, [r.left + r.width / 2, r.top + r.height / 2]) : towards(places, places[now]!, way),
      next = order.find((i) => !stops[i]!.onSheet || isSeen(stops[i]!.at));
    const ref = next === undefined ? last : stops[next]!.ref;
    if (!ref) return;
    this.at[view] = ref;
    this.mark(view, ref);
    this.say(next === undefined ? `nothing further; ${this.text(of, view, ref)}` : this.text(of, view, ref));
  }

  private pick(view: MeasuredView) {
    const ref = this.at[view];
    if (!ref) return;
    const { kept } = this.ui.state.measure;
    this.measuring.pick(view, ref);
    const { measure, units } = this.ui.state,
      made = measure.kept.length > kept.length ? measure.kept.at(-1)! : null,
      of = measuredOf(this.ui.state),
      answer = made && of && answerOf(of, made);
    if (answer) this.say(wholeText(answer, units));
    this.mark(view, ref); // as before
  }

  /** "edge of F1, 40 mm", and what is measured from what was picked first. */
  private text(of: Measured, view: MeasuredView, ref: Ref): string {
    const { measure, units } = this.ui.state,
      first = measure.first?.view === view && !isSame(measure.first.ref, ref) ? measure.first.ref : null,
      own = ref.kind === 'flange' ? null : answerOf(of, { view, a: ref, b: null }),
      from = first && answerOf(of, { view, a: first, b: ref });
    return [
      nameOfRef(of.shape, ref),
      own && labelText(own, units).replace('Ø', 'diameter').replace(/^R /, 'radius '),
      from && `${labelText(from, units)} from ${nameOfRef(of.shape, first!)}`,
    ]
      .filter(Boolean)
      .join(', ');
  }

  /** Of a flange all of it. */
  private mark(view: MeasuredView, ref: Ref) {
    this.measuring.hover(view, ref);
    this.keyed[view].light(ref.kind === 'flange' || ref.kind === 'bend' ? ref.part : null);
  }

  private say(text: string) {
    this.said.textContent = text;
  }
}
