import type { Palette } from './theme.ts';

const height = 20,
  beside = 20; // px from a place to its name

/** Writes names beside their places, with a line to each, so that none covers its place or another name. */
export function writeNames(
  c: CanvasRenderingContext2D,
  names: { text: string; x: number; y: number }[],
  { halo, hit, label }: Palette,
): boolean {
  c.font = 'bold 12px system-ui, sans-serif';
  c.textBaseline = 'middle';
  c.textAlign = 'left';
  const taken: { x: number; y: number; w: number }[] = [],
    right = c.canvas.clientWidth;
  for (const { text, x, y } of names) {
    const w = c.measureText(text).width + 12,
      left = x + beside + w > right ? x - beside - w : x + beside;
    let top = Math.max(2, y - beside - height);
    const covers = (t: (typeof taken)[0]) => Math.abs(t.y - top) < height + 2 && t.x < left + w && left < t.x + t.w;
    while (taken.some(covers)) top += height + 2;
    taken.push({ x: left, y: top, w });
    c.strokeStyle = c.fillStyle = hit;
    c.lineWidth = 1.5;
    c.beginPath();
    c.moveTo(x, y);
    c.lineTo(left > x ? left : left + w, top + height / 2);
    c.stroke();
    c.beginPath();
    c.arc(x, y, 3, 0, 2 * Math.PI);
    c.fill();
    c.beginPath();
    c.roundRect(left, top, w, height, 4);
    c.fillStyle = halo;
    c.fill();
    c.stroke();
    c.fillStyle = label;
    c.fillText(text, left + 6, top + height / 2 + 0.5);
  }
  return names.length > 0;
}
