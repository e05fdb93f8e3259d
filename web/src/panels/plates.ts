import { html, nothing } from 'lit-html';
import {
  addBend,
  addPlate,
  copyId,
  copyPlate,
  middleOf,
  movePlate,
  newPlateId,
  notJoined,
  removePlate,
  renamePlate,
  turned,
} from '../edits/connect.ts';
import {
  addCorner,
  addHole,
  along,
  directionsOf,
  moveCorner,
  removeCorner,
  removeHole,
  ringsOf,
} from '../edits/outline.ts';
import type { BendRow, Vec2, Vec3 } from '../types.ts';
import type { PlateSpec, PlatesSpec } from '../edits/plates-types.ts';
import { convert } from '../units.ts';
import type { GizmoMode } from '../state.ts';
import type { Ui } from '../ui.ts';
import { segment } from './blocks.ts';
import { lengthField, numberField, refuse } from './fields.ts';

/** Plates to choose from, actions on the chosen one, and new plates. */
export function platesPart(ui: Ui, spec: PlatesSpec, rows: BendRow[]) {
  const plate = spec.plates.find((p) => p.id === ui.state.selection.plate);
  return html`<div class="chips">
      ${spec.plates.map(
        (p) =>
          html`<button
            data-testid="plate-${p.id}"
            class=${p === plate ? 'on' : ''}
            @click=${() => choose(ui, p === plate ? null : p.id)}
          >
            ${p.id}
          </button>`,
      )}
    </div>
    ${plate
      ? html`${nameFields(ui, spec, plate)}${placeFields(ui, spec, plate)}${cornerFields(ui, spec, plate)}${bendChoice(
          ui,
          spec,
          rows,
          plate,
        )}`
      : html`<p class="hint">Choose a plate here or click it, then drag its handle.</p>`}
    ${newPlate(ui, spec, plate?.id ?? null)}`;
}

const choose = (ui: Ui, plate: string | null) => ui.dispatch({ type: 'select', selection: { plate } });

function nameFields(ui: Ui, spec: PlatesSpec, plate: PlateSpec) {
  const rename = (e: Event) => {
    const input = e.target as HTMLInputElement,
      to = input.value.trim(),
      renamed = renamePlate(spec, plate.id, to);
    input.value = plate.id;
    if (!renamed && to !== plate.id)
      refuse(input, to === '' ? 'A plate needs a name.' : `Another plate is already called ${to}.`);
    if (!renamed) return;
    ui.edit<PlatesSpec>(() => renamed);
    choose(ui, to);
  };
  const copy = () => {
    ui.edit<PlatesSpec>((s) => copyPlate(s, plate.id));
    choose(ui, copyId(spec, plate.id));
  };
  const remove = () => {
    ui.edit<PlatesSpec>((s) => removePlate(s, plate.id));
    choose(ui, null);
  };
  return html`<div class="named">
    <label class="field"
      ><span>Name</span><input type="text" data-testid="plate-name" .value=${plate.id} @change=${rename}
    /></label>
    <button data-testid="plate-copy" @click=${copy}>Copy</button
    ><button data-testid="plate-remove" ?disabled=${spec.plates.length < 2} @click=${remove}>Remove</button>
  </div>`;
}

function placeFields(ui: Ui, spec: PlatesSpec, plate: PlateSpec) {
  const middle = middleOf(plate),
    mode = ui.state.gizmo;
  const move = (k: number, v: number | null) =>
    v !== null &&
    ui.edit<PlatesSpec>((s) =>
      movePlate(s, plate.id, (p) => p.map((x, i) => (i === k ? x + v - middle[k]! : x)) as Vec3),
    );
  const turn = (axis: 0 | 1 | 2, v: number | null) =>
    v && ui.edit<PlatesSpec>((s) => movePlate(s, plate.id, (p) => turned(p, middle, axis, v)));
  const chooses = (text: string, gizmo: GizmoMode) =>
    segment(text, `gizmo-${gizmo}`, mode === gizmo, () => ui.dispatch({ type: 'gizmo', gizmo }));
  return html`<div class="segments">${chooses('Move', 'translate')}${chooses('Turn', 'rotate')}</div>
    <div class="triple">
      ${(['x', 'y', 'z'] as const).map((axis, k) =>
        mode === 'translate'
          ? lengthField(ui, {
              label: axis,
              testid: `plate-${axis}`,
              value: middle[k]!,
              from: spec.units,
              on: (v) => move(k, v),
            })
          : numberField({
              label: `by ${axis}`,
              testid: `plate-turn-${axis}`,
              value: 0,
              unit: '°',
              momentary: true,
              on: (v) => turn(k as 0 | 1 | 2, v),
            }),
      )}
    </div>`;
}

function cornerFields(ui: Ui, spec: PlatesSpec, plate: PlateSpec) {
  const d = directionsOf(plate.outline),
    holes = plate.holes?.length ?? 0;
  return html`<details class="corners">
    <summary data-testid="plate-corners">
      ${plate.outline.length} corners${holes ? `, ${holes} hole${holes > 1 ? 's' : ''}` : ''}
    </summary>
    <p class="hint">
      u and v lie in the plate: ${d.v[2] === 0 ? 'x and y' : 'u is level, v goes up'}. Edge i begins at corner i.
    </p>
    ${ringsOf(plate).map(
      (corners, ring) =>
        html`${ring
          ? html`<h3 class="with-button">
              Hole ${ring}<button
                class="link"
                data-testid="hole-remove-${ring - 1}"
                @click=${() => ui.edit<PlatesSpec>((s) => removeHole(s, plate.id, ring - 1))}
              >
                Remove
              </button>
            </h3>`
          : nothing}
        ${corners.map((p, i) => cornerRow(ui, spec, plate.id, ring, i, along(d, p), corners.length))}`,
    )}
    <button class="link" data-testid="hole-add" @click=${() => ui.edit<PlatesSpec>((s) => addHole(s, plate.id))}>
      Add a hole
    </button>
  </details>`;
}

function cornerRow(ui: Ui, spec: PlatesSpec, id: string, ring: number, corner: number, at: Vec2, count: number) {
  const field = (name: string, axis: 0 | 1) =>
    lengthField(ui, {
      label: `${corner} ${name}`,
      testid: `corner-${ring}-${corner}-${name}`,
      value: at[axis],
      from: spec.units,
      on: (v) => v !== null && ui.edit<PlatesSpec>((s) => moveCorner(s, id, ring, corner, axis, v)),
    });
  return html`<div class="double corner">
    ${field('u', 0)}${field('v', 1)}
    <button
      class="link"
      title="Add a corner after it"
      aria-label="Add a corner after corner ${corner}"
      data-testid="corner-${ring}-${corner}-add"
      @click=${() => ui.edit<PlatesSpec>((s) => addCorner(s, id, ring, corner))}
    >
      +
    </button>
    <button
      class="link"
      title="Remove"
      aria-label="Remove corner ${corner}"
      data-testid="corner-${ring}-${corner}-remove"
      ?disabled=${count <= 3}
      @click=${() => ui.edit<PlatesSpec>((s) => removeCorner(s, id, ring, corner))}
    >
      ×
    </button>
  </div>`;
}

function bendChoice(ui: Ui, spec: PlatesSpec, rows: BendRow[], plate: PlateSpec) {
  const others = notJoined(spec, rows, plate.id);
  if (!others.length) return nothing;
  return html`<div class="chips bend-to">
    <span>Bend it to</span>${others.map(
      (id) =>
        html`<button
          data-testid="bend-add-${id}"
          @click=${() => ui.edit<PlatesSpec>((s) => addBend(s, rows, plate.id, id))}
        >
          ${id}
        </button>`,
    )}
  </div>`;
}

function newPlate(ui: Ui, spec: PlatesSpec, beside: string | null) {
  const { plateSize } = ui.state,
    own = plateSize.map((v) => convert(v, 'mm', spec.units ?? 'mm')) as Vec2;
  const size = (k: 0 | 1) =>
    lengthField(ui, {
      label: k ? '×' : '',
      name: `The new plate’s ${k ? 'height' : 'width'}`,
      testid: `plate-size-${k}`,
      value: plateSize[k],
      from: 'mm',
      min: 1e-3,
      on: (v) => v && ui.dispatch({ type: 'plate-size', size: plateSize.map((x, i) => (i === k ? v : x)) as Vec2 }),
    });
  const add = () => {
    ui.edit<PlatesSpec>((s) => addPlate(s, beside, own));
    choose(ui, newPlateId(spec));
  };
  return html`<div class="new-plate">
    <span>New</span>${size(0)}${size(1)}
    <button
      data-testid="plate-add"
      title=${beside ? `In the plane of ${beside}, beside it` : 'In the plane of x and y'}
      @click=${add}
    >
      Add
    </button>
  </div>`;
}
