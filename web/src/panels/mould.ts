import { html, nothing } from 'lit-html';
import { setMould } from '../edits/panels.ts';
import type { MouldSpec, SlitSpec } from '../edits/slit-types.ts';
import type { Vec3 } from '../types.ts';
import { lengthText } from '../units.ts';
import type { Ui } from '../ui.ts';
import { choice, lengthField, numberField, toggle } from './fields.ts';

type Form = NonNullable<MouldSpec['form']>;
type Side = NonNullable<MouldSpec['side']>;

/** How the mould is made that the downloads offer. */
export function mouldFields(ui: Ui, spec: SlitSpec) {
  const mould = spec.mould ?? {},
    set = (patch: Partial<MouldSpec>) => ui.edit<SlitSpec>((s) => setMould(s, patch));
  const length = (label: string, key: 'base' | 'inset', min: number, placeholder: string) =>
    lengthField(ui, {
      label,
      testid: `mould-${key}`,
      value: mould[key],
      from: spec.units,
      min,
      placeholder,
      on: (v) => set({ [key]: v ?? undefined }),
    });
  const standard = <T extends string>(value: T, usual: T) => (value === usual ? undefined : value);
  return html`${choice<Form>(
    'Form',
    'mould-form',
    mould.form ?? 'ribs',
    [
      ['ribs', 'ribs under the strips'],
      ['body', 'body with side panels'],
    ],
    (v) => set({ form: standard(v, 'ribs') }),
  )}
  ${choice<Side>(
    'Sheet lies with',
    'mould-side',
    mould.side ?? 'ground',
    [
      ['ground', 'its ground side'],
      ['back', 'its back'],
      ['front', 'its front'],
    ],
    (v) => set({ side: standard(v, 'ground') }),
  )}
  ${length('Base depth', 'base', 1e-6, lengthText(20, 'mm', ui.state.units))}
  ${length('Inset of ribs', 'inset', 0, 'chosen')}
  ${numberField({
    label: 'Least draft',
    testid: 'mould-draft',
    value: mould.draft,
    min: 1e-3,
    max: 85,
    unit: '°',
    placeholder: '5',
    on: (v) => set({ draft: v ?? undefined }),
  })}
  ${toggle('Lift-off direction is set', 'mould-up', mould.up !== undefined, (on) =>
    set({ up: on ? [0, 1, 0] : undefined }),
  )}
  ${mould.up ? upFields(mould.up, (up) => set({ up })) : nothing}`;
}

const upFields = (up: Vec3, on: (up: Vec3) => void) =>
  html`<div class="triple">
    ${(['x', 'y', 'z'] as const).map((axis, k) =>
      numberField({
        label: axis,
        testid: `mould-up-${axis}`,
        value: up[k]!,
        on: (v) => v !== null && on(up.map((x, j) => (j === k ? v : x)) as Vec3),
      }),
    )}
  </div>`;
