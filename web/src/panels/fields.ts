import { html, nothing, type TemplateResult } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import type { LengthUnit } from '../types.ts';
import { clean, convert, round, unitName } from '../units.ts';
import type { Ui } from '../ui.ts';

export interface NumberOptions {
  label: string;
  name?: string; // in sentences, if not the label
  whole?: boolean;
  value: number | null | undefined;
  testid: string;
  on: (value: number | null) => void;
  unit?: string;
  digits?: number;
  min?: number;
  max?: number;
  momentary?: boolean; // an action, not a lasting value
  placeholder?: string; // with a placeholder the field may be empty: the program chooses
}

// larger than any length in a workshop, in any unit; beyond it squares could not be computed accurately
const largest = 1e8;

const isSound = (value: number) => Number.isFinite(value) && Math.abs(value) <= largest;

/** Says why an entry is not taken, after which the field goes back to what it was. */
export const refuse = (input: HTMLElement, sentence: string) =>
  input.dispatchEvent(new CustomEvent('refused', { bubbles: true, detail: sentence }));

interface Limits {
  label: string;
  name?: string;
  whole?: boolean;
  unit?: string;
  digits?: number;
  min?: number;
  max?: number;
}

/** Why an entry cannot be a field's value; null if it can. */
export function whyNot(entered: string, limits: Limits): string | null {
  const { name: label = limits.label, whole, unit, digits = 4, min, max } = limits,
    value = Number(entered),
    size = (v: number) => `${clean(v, digits)}${unit === '°' ? unit : unit ? ` ${unit}` : ''}`,
    nearZero = min !== undefined && min > 0 && Number(clean(min, digits)) === 0;
  if (entered === '') return `${label} needs a number.`;
  if (!Number.isFinite(value)) return `“${entered}” is not a number; ${label} needs one.`;
  if (!isSound(value)) return `${label} cannot be ${entered}: that is larger than anything in a workshop.`;
  if (whole && !Number.isInteger(value)) return `${label} cannot be ${entered}; it must be a whole number.`;
  if (nearZero && value < min) return `${label} cannot be ${entered}; it must be above 0.`;
  if (min !== undefined && max !== undefined && (value < min || value > max))
    return `${label} cannot be ${entered}; it must be from ${size(min)} to ${size(max)}.`;
  if (min !== undefined && value < min) return `${label} cannot be ${entered}; it must be at least ${size(min)}.`;
  if (max !== undefined && value > max) return `${label} cannot be ${entered}; it must be at most ${size(max)}.`;
  return null;
}

/** A number, applied when entered; entries that cannot be are refused with a sentence. */
export function numberField(o: NumberOptions): TemplateResult {
  const text = o.value === null || o.value === undefined ? '' : clean(o.value, o.digits ?? 4);
  const change = (e: Event) => {
    const input = e.target as HTMLInputElement,
      entered = input.value.trim().replace(',', '.');
    const no = whyNot(entered, o);
    if (entered === '' && o.placeholder !== undefined) o.on(null);
    else if (no !== null) {
      input.value = text;
      refuse(input, no);
    } else if (entered !== text) o.on(Number(entered));
    if (o.momentary) input.value = text;
  };
  return html`<label class="field"
    ><span>${o.label}</span>
    <input
      type="text"
      inputmode="decimal"
      data-testid=${o.testid}
      .value=${text}
      placeholder=${o.placeholder ?? ''}
      @change=${change}
    />
    ${o.unit ? html`<em>${o.unit}</em>` : html`<em></em>`}</label
  >`;
}

export interface LengthOptions extends Omit<NumberOptions, 'unit'> {
  from: LengthUnit | undefined;
}

/** A length: kept in the file's unit, shown and entered in the page's. */
export function lengthField(ui: Ui, o: LengthOptions): TemplateResult {
  const to = ui.state.units,
    own = o.from ?? 'mm';
  const there = (v: number | undefined) => (v === undefined ? undefined : convert(v, own, to));
  return numberField({
    ...o,
    unit: unitName(to),
    digits: to === 'mm' ? 3 : 4,
    value: o.value === null || o.value === undefined ? o.value : convert(o.value, own, to),
    min: there(o.min),
    max: there(o.max),
    on: (v) => o.on(v === null ? null : round(convert(v, to, own))),
  });
}

export interface SliderOptions {
  label: string;
  whole?: boolean;
  value: number;
  min: number;
  max: number;
  least?: number; // smallest value that may be entered; otherwise entries may exceed the slider's range
  most?: number; // largest one
  step: number;
  testid: string;
  unit?: string;
  digits?: number;
  on: (value: number, live: boolean) => void;
  commit: () => void;
}

/** A slider with its number: dragging edits live, letting go ends the step. */
export function slider(o: SliderOptions): TemplateResult {
  const text = clean(o.value, o.digits ?? 3);
  const enter = (e: Event) => {
    const input = e.target as HTMLInputElement,
      entered = input.value.trim().replace(',', '.'),
      no = whyNot(entered, { ...o, min: o.least, max: o.most });
    if (no !== null) {
      input.value = text;
      refuse(input, no);
    } else if (entered !== text) o.on(Number(entered), false);
  };
  return html`<label class="slider"
    ><span>${o.label}</span>
    <input
      type="range"
      data-testid=${o.testid}
      min=${o.min}
      max=${o.max}
      step=${o.step}
      .value=${String(o.value)}
      @input=${(e: Event) => o.on(Number((e.target as HTMLInputElement).value), true)}
      @change=${(e: Event) => {
        o.commit();
        (e.target as HTMLInputElement).value = String(o.value); // of a drag that was given up
      }}
    />
    <input type="text" inputmode="decimal" data-testid="${o.testid}-number" .value=${text} @change=${enter} />
    <em>${o.unit ?? ''}</em></label
  >`;
}

/** A slider of a length, kept in the file's unit. */
export function lengthSlider(
  ui: Ui,
  from: LengthUnit | undefined,
  o: Omit<SliderOptions, 'unit' | 'digits'>,
): TemplateResult {
  const to = ui.state.units,
    own = from ?? 'mm',
    there = (v: number) => convert(v, own, to);
  return slider({
    ...o,
    least: o.least === undefined ? undefined : there(o.least),
    most: o.most === undefined ? undefined : there(o.most),
    value: there(o.value),
    min: there(o.min),
    max: there(o.max),
    step: to === 'mm' ? there(o.step) : 0.001,
    unit: unitName(to),
    digits: to === 'mm' ? 2 : 3,
    on: (v, live) => o.on(round(convert(v, to, own)), live),
  });
}

/** One of several; drawn anew it shows what is chosen in the state, not what was just chosen in it. */
export function choice<T extends string>(
  label: string,
  testid: string,
  value: T,
  options: readonly (readonly [T, string])[],
  on: (value: T) => void,
): TemplateResult {
  return html`<label class="field choice"
    ><span>${label}</span>
    <select
      data-testid=${testid}
      aria-label=${label}
      @change=${(e: Event) => on((e.target as HTMLSelectElement).value as T)}
    >
      ${options.map(
        ([v, text]) =>
          html`<option value=${v} ?selected=${v === value} .selected=${live(v === value)}>${text}</option>`,
      )}</select
    ><em></em
  ></label>`;
}

export const toggle = (label: string, testid: string, value: boolean, on: (value: boolean) => void) =>
  html`<label class="field check"
    ><span>${label}</span>
    <input
      type="checkbox"
      data-testid=${testid}
      .checked=${value}
      @change=${(e: Event) => on((e.target as HTMLInputElement).checked)} /><em></em
  ></label>`;

export const section = (title: string, content: unknown, extra: unknown = nothing) =>
  html`<section>
    <h2>${title}${extra}</h2>
    ${content}
  </section>`;

/** The least of 1, 2, 5, 10 … that is not less than `value`. */
export function niceAbove(value: number): number {
  const e = 10 ** Math.floor(Math.log10(Math.max(value, 1e-9)));
  return [1, 2, 5, 10].map((f) => f * e).find((v) => v >= value * (1 - 1e-9)) ?? 10 * e;
}
