import { html, nothing, svg, type TemplateResult } from 'lit-html';
import { bezierPoints, lengthOf, lowered, raised, removePoint } from '../edits/slit.ts';
import type { CurveName, SlitSpec } from '../edits/slit-types.ts';
import type { LengthUnit, Vec2 } from '../types.ts';
import { fileDigits, lengthText, round } from '../units.ts';
import type { Ui } from '../ui.ts';
import { lengthField } from './fields.ts';

export interface CurveOptions {
  name: CurveName;
  axes: [string, string];
  control: Vec2[];
  resting: Vec2[]; // as it was before the drag: the picture stands still meanwhile
  units: LengthUnit | undefined;
  note?: unknown;
  on: (control: Vec2[], live: boolean) => void;
  enter: (control: Vec2[]) => void; // a point as it was typed
}

const [width, height, margin] = [312, 190, 22];

/** As drawn last: a field may have changed a curve between the press and the first movement. */
const drawn = new Map<CurveName, CurveOptions>();

/** A Bézier curve whose control points are dragged. */
export function curveEditor(ui: Ui, o: CurveOptions): TemplateResult {
  drawn.set(o.name, o);
  const { at } = picture(o);
  const digits = fileDigits(o.units) - 1,
    { selection, units } = ui.state,
    chosen = selection.point?.curve === o.name ? selection.point.index : null;
  const choose = (i: number) => ui.dispatch({ type: 'select', selection: { point: { curve: o.name, index: i } } });
  const press = (i: number) => (e: KeyboardEvent) => {
    if (e.key !== 'Enter' && e.key !== ' ') return;
    choose(i);
    e.preventDefault();
    e.stopPropagation(); // space would fold
  };
  const drag = (i: number) => (e: PointerEvent) => {
    const circle = e.target as SVGCircleElement,
      r = circle.ownerSVGElement!.getBoundingClientRect(),
      zoom = width / r.width,
      [x0, y0] = at(o.control[i]!),
      held: Vec2 = [(e.clientX - r.left) * zoom - x0, (e.clientY - r.top) * zoom - y0]; // beside the point
    circle.setPointerCapture(e.pointerId);
    choose(i);
    const move = (m: PointerEvent) => {
      const now = drawn.get(o.name)!,
        x = (m.clientX - r.left) * zoom - held[0],
        y = (m.clientY - r.top) * zoom - held[1],
        p = picture(now)
          .from([x, y])
          .map((v) => round(v, digits)) as Vec2;
      now.on(
        now.control.map((q, j) => (j === i ? p : q)),
        true,
      );
    };
    const end = () => {
      circle.removeEventListener('pointermove', move);
      ui.commit();
    };
    circle.addEventListener('pointermove', move);
    circle.addEventListener('pointerup', end, { once: true });
    circle.addEventListener('pointercancel', end, { once: true });
  };
  const path = (points: Vec2[]) =>
    points
      .map(at)
      .map(([x, y]) => `${x.toFixed(1)},${y.toFixed(1)}`)
      .join(' ');
  return html`<svg class="curve" viewBox="0 0 ${width} ${height}" data-testid="curve-${o.name}">
      <text x="6" y="14" class="axis">${o.axes[1]} ↑</text>
      <text x=${width - 6} y=${height - 6} text-anchor="end" class="axis">${o.axes[0]} →</text>
      <polyline points=${path(o.control)} class="control" />
      <polyline points=${path(bezierPoints(o.control))} class="line" />
      ${o.control.map((p, i) => {
        const [x, y] = at(p);
        const place = p.map((v, k) => `${o.axes[k]} ${lengthText(v, o.units, units)}`).join(', ');
        return svg`<g><circle class=${i === chosen ? 'on' : ''} cx=${x} cy=${y} r="6"
          role="button" tabindex="0" aria-label="Point ${i + 1}: ${place}" aria-pressed=${String(i === chosen)}
          data-testid="curve-${o.name}-${i}" @pointerdown=${drag(i)} @keydown=${press(i)}><title>${place}</title>
          </circle></g>`;
      })}
    </svg>
    <p class="row curve-note">
      <span class="hint">${lengthText(lengthOf(o.control), o.units, units)} long${o.note ?? nothing}</span>
      <button
        class="link"
        title="Add a control point"
        data-testid="curve-${o.name}-raise"
        @click=${() => o.on(raised(o.control), false)}
      >
        + point
      </button>
    </p>
    ${pointFields(ui, o, chosen)}`;
}

/** The chosen point, in numbers; the row is present without one too, so that nothing moves during a drag. */
function pointFields(ui: Ui, o: CurveOptions, chosen: number | null) {
  const p = chosen === null ? undefined : o.control[chosen];
  if (chosen === null || !p)
    return html`<p class="hint point">Drag a point, or choose it to enter its coordinates.</p>`;
  const remove = () => {
    ui.edit<SlitSpec>((s) => removePoint(s, o.name, chosen));
    ui.dispatch({ type: 'select', selection: {} });
  };
  return html`<div class="point">
    ${o.axes.map((axis, k) =>
      lengthField(ui, {
        label: axis,
        testid: `curve-${o.name}-${axis}`,
        value: p[k]!,
        from: o.units,
        on: (v) =>
          v !== null && o.enter(o.control.map((q, i) => (i === chosen ? (k === 0 ? [v, q[1]] : [q[0], v]) : q))),
      }),
    )}
    <button
      class="link"
      title="Remove this point; the ends of the curve stay"
      data-testid="curve-${o.name}-remove"
      ?disabled=${lowered(o.control, chosen) === o.control}
      @click=${remove}
    >
      Remove
    </button>
  </div>`;
}

/** Where a curve lies in its picture. */
function picture({ resting }: CurveOptions) {
  const box = bounds(resting),
    scale = Math.min((width - 2 * margin) / box.w, (height - 2 * margin) / box.h);
  return {
    at: ([x, y]: Vec2): Vec2 => [width / 2 + (x - box.x) * scale, height / 2 - (y - box.y) * scale],
    from: ([x, y]: Vec2): Vec2 => [box.x + (x - width / 2) / scale, box.y - (y - height / 2) / scale],
  };
}

function bounds(control: Vec2[]) {
  const xs = control.map((p) => p[0]),
    ys = control.map((p) => p[1]);
  const [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)],
    room = 0.35 * (Math.max(x1 - x0, y1 - y0) || 1);
  return { x: (x0 + x1) / 2, y: (y0 + y1) / 2, w: x1 - x0 + room, h: y1 - y0 + room };
}
