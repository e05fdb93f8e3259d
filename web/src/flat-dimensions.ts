import type { LabelWriter } from './flat-labels.ts';
import type { Palette } from './theme.ts';
import type { Vec2 } from './types.ts';

/** Width and height of the blank, below and to the left of it. `low` and `high` are its corners on the screen. */
export function drawDimensions(c: CanvasRenderingContext2D, low: Vec2, high: Vec2, text: [string, string], palette: Palette, writer: LabelWriter) {
  const below = low[1] + 22, left = low[0] - 22;
  c.strokeStyle = palette.dimension;
  c.lineWidth = 1;
  c.setLineDash([]);
  line(c, [low[0], low[1] + 6], [low[0], below + 5]);
  line(c, [high[0], low[1] + 6], [high[0], below + 5]);
  line(c, [low[0] - 6, low[1]], [left - 5, low[1]]);
  line(c, [low[0] - 6, high[1]], [left - 5, high[1]]);
  arrow(c, [low[0], below], [high[0], below]);
  arrow(c, [left, low[1]], [left, high[1]]);
  writer.write({ text: text[0], at: [(low[0] + high[0]) / 2, below], angle: 0, room: 1000, color: palette.dimension });
  writer.write({ text: text[1], at: [left, (low[1] + high[1]) / 2], angle: -Math.PI / 2, room: 1000, color: palette.dimension });
}

function line(c: CanvasRenderingContext2D, a: Vec2, b: Vec2) {
  c.beginPath();
  c.moveTo(...a);
  c.lineTo(...b);
  c.stroke();
}

function arrow(c: CanvasRenderingContext2D, a: Vec2, b: Vec2) {
  line(c, a, b);
  const l = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1, ux = (b[0] - a[0]) / l, uy = (b[1] - a[1]) / l;
  for (const [p, s] of [[a, 1], [b, -1]] as const) {
    c.beginPath();
    c.moveTo(...p);
    c.lineTo(p[0] + s * 8 * ux + 3 * uy, p[1] + s * 8 * uy - 3 * ux);
    c.lineTo(p[0] + s * 8 * ux - 3 * uy, p[1] + s * 8 * uy + 3 * ux);
    c.closePath();
    c.fillStyle = c.strokeStyle;
    c.fill();
  }
}
