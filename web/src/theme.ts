/** Colours of both views, read from the style sheet, so that there is one place for them. */
export interface Palette {
  background: string;
  flange: string;
  bend: string;
  flangeUnder: string;
  bendUnder: string;
  selected: string;
  rim: string;
  edge: string;
  crease: string;
  up: string;
  down: string;
  outline: string;
  form: string;
  fill: string;
  label: string;
  halo: string;
  dimension: string;
  overlap: string;
  warning: string;
  error: string;
  info: string;
  curve: string;
  ridge: string;
  anchor: string;
  scan: string;
  punch: string;
  die: string;
  beam: string;
  finger: string;
  hit: string;
  measure: string;
  section: string;
}
const names: Record<keyof Palette, string> = {
  background: '--view',
  flange: '--flange',
  bend: '--bend',
  flangeUnder: '--flange-under',
  bendUnder: '--bend-under',
  selected: '--selected',
  rim: '--rim',
  edge: '--edge',
  crease: '--crease',
  up: '--up',
  down: '--down',
  outline: '--outline',
  form: '--form',
  fill: '--fill',
  label: '--label',
  halo: '--halo',
  dimension: '--dimension',
  overlap: '--overlap',
  warning: '--warning',
  error: '--error',
  info: '--info',
  curve: '--curve',
  ridge: '--ridge',
  anchor: '--anchor',
  scan: '--scan',
  punch: '--punch',
  die: '--die',
  beam: '--beam',
  finger: '--finger',
  hit: '--hit',
  measure: '--measure',
  section: '--section',
};

export function readPalette(): Palette {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(
    Object.entries(names).map(([key, name]) => [key, style.getPropertyValue(name).trim()]),
  ) as unknown as Palette;
}
