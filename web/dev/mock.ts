import type { IncomingMessage, ServerResponse } from 'node:http';
import type { Plugin } from 'vite';
import { readFileSync } from 'node:fs';
import { twoFlangesShape } from '../test/two-flanges.ts';

/** A stand-in for the server while the page is worked on without one: every document is the same two flanges. */
export function mock(): Plugin {
  return {
    name: 'planish-mock',
    configureServer(server) {
      server.middlewares.use('/api', (request: IncomingMessage, response: ServerResponse) => {
        const chunks: Buffer[] = [];
        request.on('data', (c: Buffer) => chunks.push(c));
        request.on('end', () => answer(request, response, Buffer.concat(chunks)));
      });
    },
  };
}

function answer(request: IncomingMessage, response: ServerResponse, body: Buffer) {
  const path = new URL(request.url ?? '/', 'http://x').pathname, json = (value: unknown) => { response.setHeader('Content-Type', 'application/json'); response.end(JSON.stringify(value)); };
  if (path === '/examples') return json([{ name: 'connect/a_folded.json', kind: 'connect', title: 'A folded floor' }, { name: 'transition/a_square_to_round.json', kind: 'transition', title: 'Square to round' }, { name: 'slit/chair.json', kind: 'slit', title: 'A chair' }]);
  if (path.startsWith('/examples/')) return response.end(readFileSync(new URL(`../../examples/${decodeURIComponent(path.slice(10))}`, import.meta.url)));
  if (path === '/documents' && request.method === 'POST') {
    const name = new URL(request.url ?? '/', 'http://x').searchParams.get('name') ?? '', text = name.endsWith('.json') ? body.toString() : null;
    const kind = !text ? 'unfold' : text.includes('"plates"') ? 'connect' : text.includes('"strips"') ? 'slit' : 'transition';
    return json({ id: 'd1', kind, name, text, info: text ? null : { bodies: [{ number: 1, name: 'one', quantity: 1, faces: 8, size: [1, 1, 1], volume: 1 }, { number: 2, name: 'two', quantity: 1, faces: 8, size: [1, 1, 1], volume: 1 }] } });
  }
  if (path === '/documents') return json([]);
  if (/\/(draft|result)$/.test(path)) return response.end(Buffer.from(twoFlangesShape()));
  if (path.endsWith('/progress')) return json(null);
  response.statusCode = 204;
  response.end();
}
