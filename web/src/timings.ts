/** From a drag event to new geometry in the renderer's hands, and to the frame that shows it; in milliseconds. */
export interface DragTiming {
  toGeometry: number;
  toFrame: number | null;
}

declare global {
  interface Window {
    planishTimings: DragTiming[];
  }
}

const most = 2000;
let waiting: { entry: DragTiming; from: number }[] = [];

/** To be called when the geometry of a drag event at `from` is in the renderer's hands. */
export function geometryShown(from: number) {
  const entry: DragTiming = { toGeometry: performance.now() - from, toFrame: null };
  window.planishTimings.push(entry);
  if (window.planishTimings.length > most) window.planishTimings.shift();
  waiting.push({ entry, from });
}

/** To be called when a frame has been drawn. */
export function frameDrawn() {
  if (waiting.length === 0) return;
  const now = performance.now();
  for (const { entry, from } of waiting) entry.toFrame = now - from;
  waiting = [];
}
