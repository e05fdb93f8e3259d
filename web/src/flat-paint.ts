import { isUp, lengthOfLine, type FlatScene, type Lie } from './flat-scene.ts';
import { featureOfEdge, markedWith } from './lines.ts';
import type { Shape, Vec2 } from './types.ts';

const outlineWidth = 1.3; // px

/** The sheet, its bends, what is picked, overlaps and lines. */
export function paintSheet(c: CanvasRenderingContext2D, lie: Lie, scene: FlatScene, shape: Shape) {
  const { palette, selected } = scene;
  fill(c, lie, shape, isWhole, palette.fill);
  fill(c, lie, shape, (part) => shape.parts[part]?.kind === 'bend', palette.bend, 0.28);
  if (selected !== null) fill(c, lie, shape, (part) => part === selected, palette.selected);
  fillOverlaps(c, lie, scene, shape);
  strokeBendLines(c, lie, scene, shape);
  strokeOutline(c, lie, scene, shape);
  paintReliefs(c, lie, scene, shape);
}

const isWhole = (part: number) => part === -1,
  isRelief = (part: number) => part === -2;

/** What was cut out of the pattern beyond the edges of its parts, which end there. */
function paintReliefs(c: CanvasRenderingContext2D, lie: Lie, { palette }: FlatScene, shape: Shape) {
  if (!shape.contour_part.some(isRelief)) return;
  const margin = 2; // px
  c.save();
  c.beginPath();
  for (let i = 0; i < shape.contour_part.length; ++i) {
    if (!isRelief(shape.contour_part[i]!)) continue;
    const { low, high } = boxOf(lie, shape, i);
    c.rect(low[0] - margin, low[1] - margin, high[0] - low[0] + 2 * margin, high[1] - low[1] + 2 * margin);
  }
  c.clip();
  fill(c, lie, shape, isRelief, palette.background);
  c.beginPath();
  for (let i = 0; i < shape.contour_part.length; ++i)
    if (isWhole(shape.contour_part[i]!)) {
      trace(c, lie, shape, i);
      c.closePath();
    }
  c.strokeStyle = palette.outline;
  c.lineWidth = outlineWidth;
  c.stroke();
  c.restore();
}

function boxOf({ scale, offset }: Lie, shape: Shape, contour: number) {
  const low: Vec2 = [Infinity, Infinity],
    high: Vec2 = [-Infinity, -Infinity];
  for (let i = shape.contour_starts[contour]!; i < shape.contour_starts[contour + 1]!; ++i) {
    const x = offset[0] + scale * shape.contour_points[2 * i]!,
      y = offset[1] - scale * shape.contour_points[2 * i + 1]!;
    [low[0], high[0]] = [Math.min(low[0], x), Math.max(high[0], x)];
    [low[1], high[1]] = [Math.min(low[1], y), Math.max(high[1], y)];
  }
  return { low, high };
}

/** Fills the contours of some parts. */
export function fill(
  c: CanvasRenderingContext2D,
  lie: Lie,
  shape: Shape,
  whose: (part: number) => boolean,
  color: string,
  alpha = 1,
) {
  c.beginPath();
  for (let i = 0; i < shape.contour_part.length; ++i) if (whose(shape.contour_part[i]!)) trace(c, lie, shape, i);
  c.globalAlpha = alpha;
  c.fillStyle = color;
  c.fill();
  c.globalAlpha = 1;
}

function trace(c: CanvasRenderingContext2D, { scale, offset }: Lie, shape: Shape, contour: number) {
  const p = shape.contour_points,
    first = shape.contour_starts[contour]!,
    end = shape.contour_starts[contour + 1]!;
  for (let i = first; i < end; ++i) {
    const x = offset[0] + scale * p[2 * i]!,
      y = offset[1] - scale * p[2 * i + 1]!;
    if (i === first) c.moveTo(x, y);
    else c.lineTo(x, y);
  }
}

function fillOverlaps(c: CanvasRenderingContext2D, { scale, offset }: Lie, scene: FlatScene, { overlaps: o }: Shape) {
  if (o.length === 0) return;
  c.beginPath();
  for (let i = 0; i + 1 < o.length; i += 2) {
    const x = offset[0] + scale * o[i]!,
      y = offset[1] - scale * o[i + 1]!;
    if (i % 6 === 0) c.moveTo(x, y);
    else c.lineTo(x, y);
    if (i % 6 === 4) c.closePath();
  }
  c.fillStyle = scene.palette.overlap;
  c.fill();
}

function strokeOutline(c: CanvasRenderingContext2D, lie: Lie, { palette, edge }: FlatScene, shape: Shape) {
  const isCut = (e: number) => featureOfEdge(shape, e) === null;
  if (shape.edge_feature.some((f) => f >= 0)) strokeEdges(c, lie, shape, (e) => !isCut(e), palette.form, 1);
  strokeEdges(c, lie, shape, isCut, palette.outline, outlineWidth);
  const marked = markedWith(shape, edge);
  if (marked.size) strokeEdges(c, lie, shape, (e) => marked.has(e), palette.selected, 4);
}

/** Draws some edges, which are given by their numbers. */
export function strokeEdges(
  c: CanvasRenderingContext2D,
  { scale, offset }: Lie,
  shape: Shape,
  whose: (edge: number) => boolean,
  color: string,
  width: number,
) {
  const e = shape.edges;
  let last = -2;
  c.beginPath();
  for (let i = 0; 4 * i + 3 < e.length; ++i) {
    if (!whose(shape.edge_number[i]!)) continue;
    const x = e[4 * i]!,
      y = e[4 * i + 1]!;
    // A segment that starts where the last one ends continues its line: ends cost more to draw than corners.
    if (last !== i - 1 || x !== e[4 * i - 2] || y !== e[4 * i - 1])
      c.moveTo(offset[0] + scale * x, offset[1] - scale * y);
    c.lineTo(offset[0] + scale * e[4 * i + 2]!, offset[1] - scale * e[4 * i + 3]!);
    last = i;
  }
  c.strokeStyle = color;
  c.lineWidth = width;
  c.lineCap = c.lineJoin = 'round';
  c.setLineDash([]);
  c.stroke();
}

/** Draws over the bend lines of a part. */
export function strokeBendLinesOf(
  c: CanvasRenderingContext2D,
  { scale, offset }: Lie,
  { bend_lines: l, bend_line_part }: Shape,
  part: number,
  color: string,
) {
  c.beginPath();
  bend_line_part.forEach((own, i) => {
    if (own !== part) return;
    c.moveTo(offset[0] + scale * l[4 * i]!, offset[1] - scale * l[4 * i + 1]!);
    c.lineTo(offset[0] + scale * l[4 * i + 2]!, offset[1] - scale * l[4 * i + 3]!);
  });
  c.strokeStyle = color;
  c.lineWidth = 2.5;
  c.stroke();
}

function strokeBendLines(
  c: CanvasRenderingContext2D,
  { scale, offset }: Lie,
  { palette, selected }: FlatScene,
  shape: Shape,
) {
  const l = shape.bend_lines;
  for (let i = 0; i < shape.bend_line_part.length; ++i) {
    const part = shape.bend_line_part[i]!,
      up = isUp(shape, part),
      short = scale * lengthOfLine(l, i) < 30;
    c.beginPath();
    c.moveTo(offset[0] + scale * l[4 * i]!, offset[1] - scale * l[4 * i + 1]!);
    c.lineTo(offset[0] + scale * l[4 * i + 2]!, offset[1] - scale * l[4 * i + 3]!);
    c.strokeStyle = up ? palette.up : palette.down;
    c.lineWidth = part === selected ? 2.6 : short ? 0.6 : 1.1;
    c.lineCap = 'butt';
    c.setLineDash(short ? [] : up ? [7, 4] : [7, 3, 2, 3]);
    c.stroke();
  }
  c.setLineDash([]);
}
