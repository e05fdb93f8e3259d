import { writeFileSync } from 'node:fs';
import { folder } from './driving.mjs';

const web = [0, 0, 0, 60, 0, 0, 60, 80, 0, 0, 80, 0],
  long = [-2.75, 0, 2.75, -2.75, 80, 2.75, -2.75, 80, 92.75, -2.75, 0, 92.75],
  short = [62.75, 0, 2.75, 62.75, 80, 2.75, 62.75, 80, 32.75, 62.75, 0, 32.75];
const corners = (all) => [0, 3, 6, 9].map((i) => all.slice(i, i + 3));

/** A channel whose long leg is in the way of the punch once it stands. */
export function channel(page) {
  const path = `${folder(page)}/channel.json`;
  writeFileSync(
    path,
    JSON.stringify({
      format: 'planish/plates',
      version: 1,
      thickness: 1.5,
      defaults: { inside_radius: 2 },
      plates: [
        { id: 'web', outline: corners(web) },
        { id: 'long', outline: corners(long) },
        { id: 'short', outline: corners(short) },
      ],
    }),
  );
  return path;
}
