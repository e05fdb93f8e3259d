import { drawDimensions } from './flat-dimensions.ts';
import type { LabelWriter } from './flat-labels.ts';
import { isUp, lengthOfLine, onScreen, type FlatScene, type Lie } from './flat-scene.ts';
import { findingMarks, type FindingMark } from './finding-marks.ts';
import { isKnown } from './report.ts';
import type { Place } from './label-places.ts';
import { turnedPlace } from './orientation.ts';
import { sidesAsReported, type Rectangle } from './rectangle.ts';
import type { BendRow, Shape, Vec2 } from './types.ts';
import { clean, lengthText, millimetres } from './units.ts';

/** Draws the marks of the findings, and returns them. */
export function markFindings(
  c: CanvasRenderingContext2D,
  lie: Lie,
  scene: FlatScene,
  writer: LabelWriter,
): FindingMark[] {
  const { palette, findings, finding, report, turn } = scene,
    factor = millimetres(report?.units);
  const at = (p: Vec2) => onScreen(lie, ...turnedPlace([p[0] * factor, p[1] * factor], turn));
  const marks = findingMarks(findings, at, finding);
  for (const {
    finding: i,
    severity,
    at: [x, y],
    of,
    radius: r,
    numbered,
  } of marks) {
    if (of[0] !== x || of[1] !== y) {
      c.beginPath();
      c.moveTo(...of);
      c.lineTo(x, y);
      c.strokeStyle = palette[severity];
      c.lineWidth = 1.5;
      c.stroke();
    }
    c.beginPath();
    c.arc(x, y, r, 0, 2 * Math.PI);
    c.fillStyle = palette[severity];
    c.globalAlpha = 0.9;
    c.fill();
    c.globalAlpha = 1;
    c.strokeStyle = palette.halo;
    c.lineWidth = 1.5;
    c.stroke();
    writer.reserve({ x: x - r, y: y - r, w: 2 * r, h: 2 * r });
    if (!numbered) continue;
    c.fillStyle = palette.background;
    c.font = 'bold 10px system-ui, sans-serif';
    c.textAlign = 'center';
    c.textBaseline = 'middle';
    c.fillText(String(i + 1), x, y + 0.5);
  }
  return marks;
}

/** Length and width of the blank. */
export function dimensionBlank(
  c: CanvasRenderingContext2D,
  lie: Lie,
  { palette, units, report }: FlatScene,
  r: Rectangle,
  writer: LabelWriter,
) {
  const factor = millimetres(report?.units),
    box = r.corners.map((p) => onScreen(lie, ...p)) as typeof r.corners;
  const reported = report?.flat?.size,
    size = reported && isKnown(reported) ? sidesAsReported(r.size, reported.map((v) => v * factor) as Vec2) : r.size;
  const text = size.map((v) => lengthText(v, 'mm', units)) as [string, string];
  drawDimensions(c, box, text, palette, writer, r.turned);
}

/** Names of bends along their lines, and of flanges or strips where `places` have room for them. */
export function writeLabels(
  lie: Lie,
  scene: FlatScene,
  shape: Shape,
  writer: LabelWriter,
  places: () => Map<number, Place>,
) {
  writeBends(lie, scene, shape, writer);
  const { palette, report } = scene,
    marks = report?.flat?.labels ?? [],
    factor = millimetres(report?.units);
  const flange = (text: string, at: Vec2, room: number) =>
    writer.write({ text, at: onScreen(lie, ...at), angle: 0, room, color: palette.label, weight: 'bold' });
  for (const { text, at } of marks)
    if (isKnown(at)) flange(text, turnedPlace([at[0] * factor, at[1] * factor], shape.turn), 200);
  if (marks.length) return;
  for (const [part, { at, room }] of places()) {
    const { name, plate } = shape.parts[part]!;
    if (room * lie.scale >= 9) flange(plate ?? name, at, 400);
  }
}

function writeBends(lie: Lie, scene: FlatScene, shape: Shape, writer: LabelWriter) {
  const { palette, selected } = scene,
    rows = new Map((scene.report?.flat?.bends ?? []).map((b) => [b.id, b])),
    written = new Set<number>();
  const l = shape.bend_lines,
    lines = Array.from(shape.bend_line_part, (part, i) => ({ part, i })).sort(
      (a, b) => lengthOfLine(l, b.i) - lengthOfLine(l, a.i),
    );
  const ridges = shape.handles.ridges !== undefined; // too many to name; strips are named
  for (const { part, i } of [...lines.filter((x) => x.part === selected), ...(ridges ? [] : lines)]) {
    if (written.has(part)) continue;
    const a = onScreen(lie, l[4 * i]!, l[4 * i + 1]!),
      b = onScreen(lie, l[4 * i + 2]!, l[4 * i + 3]!),
      room = Math.hypot(b[0] - a[0], b[1] - a[1]) - 6,
      name = shape.parts[part]?.name ?? '';
    const along = (t: number) =>
      writer.write({
        text: bendLabel(name, rows.get(name), scene),
        at: [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])],
        angle: Math.atan2(b[1] - a[1], b[0] - a[0]),
        room: 2 * Math.min(t, 1 - t) * room,
        color: isUp(shape, part) ? palette.up : palette.down,
        weight: part === selected ? 'bold' : 'normal',
      });
    if ([0.5, 0.27, 0.73].some(along)) written.add(part);
  }
}

function bendLabel(name: string, row: BendRow | undefined, { report, units }: FlatScene): string {
  if (!row) return name;
  const radius = (row.inside_radius ?? 0) > 0 ? ` R${lengthText(row.inside_radius, report?.units, units)}` : '';
  return `${name} ${row.direction} ${clean(row.angle, 1)}°${radius}`;
}
