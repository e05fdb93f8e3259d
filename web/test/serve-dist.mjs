import { existsSync, readFileSync } from 'node:fs';

const types = { html: 'text/html', js: 'text/javascript', css: 'text/css', webp: 'image/webp' };

/** The page as it is in web/dist, at a server's address: with STUDIO_DIST set tests need not build the program anew. */
export async function serveDist(page, address) {
  if (!process.env.STUDIO_DIST) return;
  const origin = new URL(address).origin;
  await page.route(
    (url) => url.origin === origin && !url.pathname.startsWith('/api'),
    (route) => {
      const path = new URL(route.request().url()).pathname,
        name = path === '/' ? 'index.html' : path.slice(1),
        file = new URL(`../dist/${name}`, import.meta.url);
      if (!existsSync(file)) return route.continue();
      return route.fulfill({ body: readFileSync(file), contentType: types[name.split('.').at(-1)] });
    },
  );
}
