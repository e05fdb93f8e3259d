import type { LabelWriter } from './flat-labels.ts';
import type { Palette } from './theme.ts';
import type { Vec2 } from './types.ts';

/** Length and width of the blank along two sides of its smallest rectangle; `box` is that on the screen. */
export function drawDimensions(
  c: CanvasRenderingContext2D,
  box: [Vec2, Vec2, Vec2, Vec2],
  text: [string, string],
  palette: Palette,
  writer: LabelWriter,
  turned: boolean,
) {
  c.strokeStyle = palette.dimension;
  c.lineWidth = 1;
  if (turned) {
    c.setLineDash([2, 4]);
    c.beginPath();
    box.forEach((p, i) => (i ? c.lineTo(...p) : c.moveTo(...p)));
    c.closePath();
    c.stroke();
  }
  c.setLineDash([]);
  dimension(c, box[0], box[1], box[2], text[0], palette, writer);
  dimension(c, box[0], box[3], box[1], text[1], palette, writer);
}

/** What a view must have room for: places of the pattern, and how far from them in pixels, x to the right and y up. */
export function dimensionReach(box: [Vec2, Vec2, Vec2, Vec2]): { at: Vec2; by: Vec2 }[] {
  return (
    [
      [box[0], box[1], box[2]],
      [box[0], box[3], box[1]],
    ] as const
  ).flatMap(([a, b, inner]) => {
    const {
        along: [ux, uy],
        out: [nx, ny],
      } = sides(a, b, inner),
      middle: Vec2 = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
    const ends = [a, b].map((at) => ({ at, by: [reach * nx, reach * ny] as Vec2 }));
    return [
      ...ends,
      ...[-halfText, halfText].map((t) => ({ at: middle, by: [reach * nx + t * ux, reach * ny + t * uy] as Vec2 })),
    ];
  });
}

const reach = 29,
  halfText = 24; // pixels: how far out the text reaches, and how far along

/** Along a side, and away from `inner`. */
function sides(a: Vec2, b: Vec2, inner: Vec2): { along: Vec2; out: Vec2 } {
  const l = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1,
    along: Vec2 = [(b[0] - a[0]) / l, (b[1] - a[1]) / l],
    out: Vec2 = [-along[1], along[0]];
  return { along, out: out[0] * (inner[0] - a[0]) + out[1] * (inner[1] - a[1]) > 0 ? [-out[0], -out[1]] : out };
}

/** From `a` to `b`, on the side away from `inner`. */
function dimension(
  c: CanvasRenderingContext2D,
  a: Vec2,
  b: Vec2,
  inner: Vec2,
  text: string,
  palette: Palette,
  writer: LabelWriter,
) {
  const [nx, ny] = sides(a, b, inner).out;
  const out = (p: Vec2, d: number): Vec2 => [p[0] + d * nx, p[1] + d * ny];
  line(c, out(a, 6), out(a, 27));
  line(c, out(b, 6), out(b, 27));
  arrow(c, out(a, 22), out(b, 22));
  const [p, q] = [out(a, 22), out(b, 22)];
  writer.write({
    text,
    at: [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2],
    angle: Math.atan2(q[1] - p[1], q[0] - p[0]),
    room: 1000,
    color: palette.dimension,
  });
}

function line(c: CanvasRenderingContext2D, a: Vec2, b: Vec2) {
  c.beginPath();
  c.moveTo(...a);
  c.lineTo(...b);
  c.stroke();
}

function arrow(c: CanvasRenderingContext2D, a: Vec2, b: Vec2) {
  line(c, a, b);
  const l = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1,
    ux = (b[0] - a[0]) / l,
    uy = (b[1] - a[1]) / l;
  for (const [p, s] of [
    [a, 1],
    [b, -1],
  ] as const) {
    c.beginPath();
    c.moveTo(...p);
    c.lineTo(p[0] + s * 8 * ux + 3 * uy, p[1] + s * 8 * uy - 3 * ux);
    c.lineTo(p[0] + s * 8 * ux - 3 * uy, p[1] + s * 8 * uy + 3 * ux);
    c.closePath();
    c.fillStyle = c.strokeStyle;
    c.fill();
  }
}
