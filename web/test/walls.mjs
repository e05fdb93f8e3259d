const square = (id, outline) => ({ id, outline });

/** Two walls that cover each other when flat. */
export const walls = JSON.stringify({
  format: 'planish/plates',
  version: 1,
  thickness: 2,
  plates: [
    square('floor', [
      [0, 0, 0],
      [100, 0, 0],
      [100, 100, 0],
      [0, 100, 0],
    ]),
    square('up', [
      [106, 0, 6],
      [106, 200, 6],
      [106, 200, 100],
      [106, 0, 100],
    ]),
    square('down', [
      [0, 106, -6],
      [200, 106, -6],
      [200, 106, -100],
      [0, 106, -100],
    ]),
  ],
});
