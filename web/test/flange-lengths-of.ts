// Outside lengths of shapes, as the bend table has them: tsx test/flange-lengths-of.ts SHAPE…, as JSON.
import { readFileSync } from 'node:fs';
import { flangeLengths } from '../src/flange-lengths.ts';
import { decodeShape } from '../src/shape.ts';

const shapes = process.argv.slice(2).map((path) => decodeShape(new Uint8Array(readFileSync(path)).buffer));
console.log(JSON.stringify(shapes.map((shape) => Object.fromEntries(flangeLengths(shape)))));
