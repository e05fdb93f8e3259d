import { writeFileSync } from 'node:fs';

/**
 * A plates file: a plate of 90 × 50 × 2 with rows of 20 square holes, webs of 0.2 between them, the first row at the
 * height `from`, and beside it one that goes up to `high`.
 */
export function perforated(path, { holes, from, high }) {
  const square = (x, y) =>
    [
      [0, 0],
      [1, 0],
      [1, 1],
      [0, 1],
    ].map(([u, v]) => [x + 3.8 * u, y + 3.8 * v, 0]);
  const plates = [
    {
      id: 'A',
      outline: [
        [0, 0, 0],
        [90, 0, 0],
        [90, 50, 0],
        [0, 50, 0],
      ],
      holes: Array.from({ length: holes }, (_, i) => square(3 + 4 * (i % 20), from + 4 * Math.floor(i / 20))),
    },
    {
      id: 'B',
      outline: [
        [0, 54, 4],
        [90, 54, 4],
        [90, 54, high],
        [0, 54, high],
      ],
    },
  ];
  writeFileSync(path, JSON.stringify({ format: 'planish/plates', version: 1, units: 'mm', thickness: 2, plates }));
  return path;
}
