import type { Palette } from './theme.ts';

const height = 20,
  beside = 20; // px from a place to its name

export interface LabelledPlace {
  text: string;
  x: number;
  y: number;
  behind: boolean; // hidden by what is seen
}

/**
 * Writes names beside their places, with a line to each, so that none covers its place or another name. The line to
 * what is hidden is dashed, as hidden lines are in drawings, and its name says so.
 */
export function writeNames(c: CanvasRenderingContext2D, names: LabelledPlace[], palette: Palette): boolean {
  const { halo, hit, label } = palette;
  c.textBaseline = 'middle';
  c.textAlign = 'left';
  const taken: { x: number; y: number; w: number }[] = [],
    right = c.canvas.clientWidth;
  for (const { text, x, y, behind } of [...names].sort((a, b) => Number(a.behind) - Number(b.behind))) {
    const said = behind ? `${text}, behind` : text;
    c.font = `${behind ? '' : 'bold '}12px system-ui, sans-serif`;
    const w = c.measureText(said).width + 12,
      left = x + beside + w > right ? x - beside - w : x + beside;
    let top = Math.max(2, y - beside - height);
    const covers = (t: (typeof taken)[0]) => Math.abs(t.y - top) < height + 2 && t.x < left + w && left < t.x + t.w;
    while (taken.some(covers)) top += height + 2;
    taken.push({ x: left, y: top, w });
    const line = new Path2D();
    line.moveTo(x, y);
    line.lineTo(left > x ? left : left + w, top + height / 2);
    c.strokeStyle = halo; // so that it is seen on what is as dark, or red
    c.lineWidth = 3.5;
    c.stroke(line);
    c.strokeStyle = c.fillStyle = behind ? label : hit;
    c.lineWidth = behind ? 1 : 1.5;
    c.setLineDash(behind ? [4, 3] : []);
    c.stroke(line);
    c.beginPath();
    c.roundRect(left, top, w, height, 4);
    const box = c.fillStyle;
    c.fillStyle = halo;
    c.fill();
    c.stroke();
    c.setLineDash([]);
    c.beginPath();
    c.arc(x, y, 3, 0, 2 * Math.PI);
    c.fillStyle = behind ? halo : box;
    c.fill();
    if (behind) c.stroke();
    c.fillStyle = label;
    c.fillText(said, left + 6, top + height / 2 + 0.5);
  }
  return names.length > 0;
}
