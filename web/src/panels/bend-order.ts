import { html, nothing, type TemplateResult } from 'lit-html';
import { repeat } from 'lit-html/directives/repeat.js';
import { moved, nameOf, orderOf } from '../order-state.ts';
import { byPlates, plateOf, sentence } from '../said.ts';
import type { OrderAnswer, OrderedStroke, StrokeRow } from '../types.ts';
import type { Ui } from '../ui.ts';
import { clean, lengthText, unitName } from '../units.ts';
import { brakeSection } from './brake-options.ts';

/** Planning how the part is bent on a press brake, and trying other orders. */
export function bendOrder(ui: Ui): TemplateResult {
  const { order, input, result } = ui.state,
    { answer } = order,
    old = answer !== null && (order.of !== input || order.ofBrake !== order.brake);
  return html`${brakeSection(ui)}
    <p class="row plan">
      <button
        class="primary"
        data-testid="plan"
        ?disabled=${!result?.facet_parent.length}
        @click=${() => ui.askOrder(null)}
      >
        ${answer ? 'Plan again' : 'Plan the bending'}
      </button>
      ${order.computing
        ? html`<span data-testid="ordering">${order.asked ? 'Checking …' : 'Ordering the bends …'}</span
            ><button data-testid="order-cancel" @click=${ui.cancelOrder}>Cancel</button>`
        : nothing}
    </p>
    ${order.problem
      ? html`<p class="hint bad" role="alert" data-testid="order-problem">${sentence(order.problem)}</p>`
      : nothing}
    ${old
      ? html`<p class="hint bad" data-testid="order-old">
          ${order.of === input ? 'The options have changed' : 'The part has changed since'}: plan again.
        </p>`
      : nothing}
    ${answer ? outcome(ui, answer, old) : html`<p class="hint">${whatItDoes}</p>`}`;
}

const whatItDoes =
  'Finds the cheapest order in which a press brake can bend the part, and shows each stroke in the machine. ' +
  'Then drag strokes to try another order; each one is checked at once.';

function outcome(ui: Ui, answer: OrderAnswer, old: boolean) {
  const { order } = ui.state,
    shown = order.asked ?? orderOf(answer),
    rows = new Map(answer.strokes.map((row) => [nameOf(row), row])),
    blocked = answer.strokes.some((s) => s.blocked);
  return html`<p class="order-status ${blocked ? 'bad' : 'good'}" role="status" data-testid="order-status">
      ${statusText(answer)}
      ${order.given && !order.computing
        ? html`<button class="link" data-testid="order-reset" @click=${() => ui.askOrder(null)}>Cheapest order</button>`
        : nothing}
    </p>
    ${answer.sentence
      ? html`<p class="hint bad" data-testid="order-sentence">${byPlates(ui.state, answer)}</p>`
      : nothing}
    <ol
      class="strokes ${old ? 'old' : ''} ${order.asked ? 'pending' : ''}"
      data-testid="strokes"
      aria-label="Strokes in order"
    >
      ${repeat(shown, nameOf, (stroke, i) => strokeItem(ui, shown, rows.get(nameOf(stroke)), stroke, i, answer))}
    </ol>
    ${answer.strokes.length > 1
      ? html`<p class="hint">Drag a stroke to another place, or press Alt with ↑ or ↓.</p>`
      : nothing}
    ${answer.notes.map((n) => html`<p class="hint">${n}</p>`)}`;
}

function statusText({ status, cost, strokes, turn_overs, rotations, tool_changes }: OrderAnswer): string {
  const many = (n: number, what: string) => `${n} ${what}${n === 1 ? '' : 's'}`,
    stuck = strokes.filter((s) => s.blocked).length;
  if (!strokes.length) return status === 'infeasible' ? 'No order is possible.' : 'There is nothing to bend.';
  if (stuck) {
    const what = `${stuck} of ${many(strokes.length, 'stroke')} cannot be made`;
    if (status === 'infeasible') return `No order is possible. In this one ${what}.`;
    return status === 'gave_up' ? `No order was found. In this one ${what}.` : `In this order ${what}.`;
  }
  const which =
    status === 'optimal'
      ? 'The cheapest order'
      : status === 'feasible'
        ? 'Perhaps not the cheapest order'
        : 'This order is possible';
  const said = [many(turn_overs, 'turn-over'), many(rotations, 'rotation'), many(tool_changes, 'tool change')];
  return `${which}: cost ${clean(cost ?? 0, 2)}, ${said.join(', ')}.`;
}

function strokeItem(
  ui: Ui,
  shown: OrderedStroke[],
  row: StrokeRow | undefined,
  stroke: OrderedStroke,
  i: number,
  answer: OrderAnswer,
) {
  const { order } = ui.state,
    current = !order.asked && Math.min(Math.floor(order.time), answer.strokes.length - 1) === i;
  const move = (to: number) => to >= 0 && to < shown.length && to !== i && ui.askOrder(moved(shown, i, to));
  return html`<li
    class="${row?.blocked ? 'blocked' : ''} ${current ? 'selected' : ''}"
    data-testid="stroke-${i + 1}"
    data-stroke=${nameOf(stroke)}
    draggable="true"
    tabindex="0"
    aria-current=${current ? 'step' : nothing}
    aria-keyshortcuts="Alt+ArrowUp Alt+ArrowDown"
    @click=${() => ui.showStroke(i)}
    @keydown=${(e: KeyboardEvent) => pressed(e, i, move, ui)}
    @dragstart=${(e: DragEvent) => e.dataTransfer?.setData('application/x-stroke', String(i))}
    @dragover=${(e: DragEvent) => over(e)}
    @dragleave=${(e: DragEvent) => (e.currentTarget as HTMLElement).classList.remove('before', 'after')}
    @drop=${(e: DragEvent) => dropped(e, i, shown, ui)}
  >
    <b>${i + 1}</b>
    <span
      >${order.asked || !row ? nothing : changes(answer, i)}<strong>${nameOf(stroke)}</strong> ${row
        ? strokeText(ui, row, answer)
        : nothing}</span
    >
    <span class="moves">
      <button
        aria-label="Earlier"
        data-testid="earlier-${i + 1}"
        ?disabled=${i === 0}
        @click=${stop(() => move(i - 1))}
      >
        ↑
      </button>
      <button
        aria-label="Later"
        data-testid="later-${i + 1}"
        ?disabled=${i === shown.length - 1}
        @click=${stop(() => move(i + 1))}
      >
        ↓
      </button>
    </span>
  </li>`;
}

/** Where the nose of the gauge touches. */
export const inOpening = ({ gauge }: Pick<StrokeRow, 'gauge'>) => (gauge?.opening ? ' in the opening' : '');

function strokeText(ui: Ui, row: StrokeRow, answer: OrderAnswer) {
  const { units } = ui.state,
    length = (v: number | null) => `${lengthText(v, answer.units, units)} ${unitName(units)}`;
  const gauge = row.gauge
    ? `${plateOf(ui.state, row.to_gauge ?? 'edge')} to gauge ${length(row.gauge.distance)}${inOpening(row)}`
    : row.flattening
      ? ''
      : 'no gauge';
  const check = row.check_dimension;
  const small = [
    `${row.punch} / ${row.die}`,
    `${row.scene.pattern_up ? 'front' : 'back'} side up`,
    gauge,
    row.open_hem ? `stop ${length(row.open_hem.height)} above the die` : '',
    check ? `check ${plateOf(ui.state, check.flange)} ${length(check.length)}` : '',
    row.on_ears ? 'lips over ears: push them in to take it off' : '',
  ]
    .filter(Boolean)
    .join(' · ');
  return html`${clean(row.angle, 1)}° <em>${clean(row.force, 0)} kN</em><small>${small}</small>${row.blocked
      ? html`<small class="bad" data-testid="why-blocked">${byPlates(ui.state, row.blocked)}</small>`
      : nothing}`;
}

/** "A", "B" … as on the pages for the machine. */
const stationName = (i: number) => String.fromCharCode(65 + (i % 26)) + (i < 26 ? '' : String(Math.floor(i / 26)));

/** What is done before stroke i. */
export function changesBefore({ strokes, stations }: Pick<OrderAnswer, 'strokes' | 'stations'>, i: number): string[] {
  const before = strokes[i - 1],
    row = strokes[i];
  if (!before || !row) return [];
  const turned = Math.hypot(...row.gauge_direction.map((v, k) => (v ?? 0) - (before.gauge_direction[k] ?? 0)));
  const stationOf = (stroke: number) => stations.findIndex((s) => s.strokes.includes(stroke + 1)),
    now = stationOf(i),
    last = stationOf(i - 1),
    again = stations[now]?.set_up !== stations[last]?.set_up;
  return [
    ...(row.side_up !== before.side_up ? ['turn over'] : []),
    ...(turned > 1e-3 ? ['rotate'] : []),
    ...(now >= 0 && last >= 0 && now !== last ? [again ? 'new set-up' : `go to ${stationName(now)}`] : []),
  ];
}

const changes = (answer: OrderAnswer, i: number) =>
  changesBefore(answer, i).map((c) => html`<i class="change">${c}</i>`);

const stop = (then: () => void) => (e: Event) => {
  e.stopPropagation();
  then();
};

function pressed(e: KeyboardEvent, i: number, move: (to: number) => void, ui: Ui) {
  const item = e.currentTarget as HTMLElement,
    step = e.key === 'ArrowUp' ? -1 : e.key === 'ArrowDown' ? 1 : 0;
  if (e.target !== item && !(step && e.altKey)) return;
  if (step && e.altKey) {
    const name = item.dataset.stroke!,
      own = [...item.querySelectorAll('button')].indexOf(e.target as HTMLButtonElement);
    move(i + step);
    requestAnimationFrame(() => requestAnimationFrame(() => focus(item, name, own)));
  } else if (step) ((step < 0 ? item.previousElementSibling : item.nextElementSibling) as HTMLElement | null)?.focus();
  else if (e.key === 'Enter') ui.showStroke(i);
  else return;
  e.preventDefault();
  e.stopPropagation();
}

/** A row that was moved keeps the focus, or its button does, unless that goes no further. */
function focus(item: HTMLElement, name: string, button: number) {
  const list = item.closest('ol') ?? document.querySelector('ol.strokes'),
    row = list?.querySelector<HTMLElement>(`[data-stroke="${CSS.escape(name)}"]`),
    own = row?.querySelectorAll('button')[button];
  (own && !own.disabled ? own : row)?.focus();
}

const isBelow = (e: DragEvent) => {
  const r = (e.currentTarget as HTMLElement).getBoundingClientRect();
  return e.clientY > r.top + r.height / 2;
};

function over(e: DragEvent) {
  if (!e.dataTransfer?.types.includes('application/x-stroke')) return;
  e.preventDefault();
  e.stopPropagation();
  const { classList } = e.currentTarget as HTMLElement,
    below = isBelow(e);
  classList.toggle('before', !below);
  classList.toggle('after', below);
}

function dropped(e: DragEvent, i: number, shown: OrderedStroke[], ui: Ui) {
  const text = e.dataTransfer?.getData('application/x-stroke');
  (e.currentTarget as HTMLElement).classList.remove('before', 'after');
  if (!text) return;
  e.preventDefault();
  e.stopPropagation();
  const from = Number(text),
    slot = i + (isBelow(e) ? 1 : 0),
    to = slot > from ? slot - 1 : slot;
  if (to !== from && shown[from]) ui.askOrder(moved(shown, from, to));
}
