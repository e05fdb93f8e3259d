// A page of the studio, as a user has it: opened, dragged, waited for.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { launch } from './launch.mjs';
import { serveDist } from './serve-dist.mjs';

export const address = process.argv[2];
const files = process.env.STUDIO_FILES ?? '/tmp/planish-studio-files';
export const browser = await launch();

export const state = (page, code) =>
  page.evaluate(`(() => { const s = window.planish.store.state, views = window.planish.views; return ${code}; })()`);
const settled = (page) =>
  page.waitForFunction(
    () => {
      const s = window.planish.store.state;
      return s.document && s.shape && !s.shapeIsDraft && !s.computing && s.past !== undefined;
    },
    null,
    { timeout: 60000 },
  );
export const rested = async (page) => {
  await page.waitForTimeout(250);
  await settled(page);
};

const folders = new WeakMap();

/** Where the files of a page's flow are. */
export const folder = (page) => folders.get(page);

// What the tests wait for is evaluated in the page, which its policy forbids; one flow keeps the policy.
export async function fresh({ name = 'other', bypassCSP = true } = {}) {
  const context = await browser.newContext({
    viewport: { width: 1280, height: 720 },
    acceptDownloads: true,
    bypassCSP,
  });
  const page = await context.newPage(),
    said = [];
  folders.set(page, `${files}/${name}`);
  mkdirSync(folder(page), { recursive: true });
  page.on('console', (m) => {
    if (m.type() === 'error') said.push(m.text());
  });
  page.on('pageerror', (e) => said.push(e.message));
  await serveDist(page, address);
  await forgetKept();
  await page.goto(address);
  await page.waitForSelector('[data-testid=examples-menu]');
  await page.waitForTimeout(300);
  await page.unrouteAll(); // what looks at every request delays it
  const reload = page.reload.bind(page);
  page.reload = async () => {
    await serveDist(page, address);
    return reload();
  };
  return { page, said, context };
}

export async function example(page, name) {
  if (await page.locator(`[data-testid="example-${name}"]`).count()) {
    await page.click('[data-testid=examples-menu]');
    await page.click(`[data-testid="example-${name}"]`);
    await opened(page, name);
  } else await open(page, [new URL(`../../examples/${name}`, import.meta.url).pathname]);
}

export async function open(page, paths) {
  await page.setInputFiles('[data-testid=file-input]', paths);
  await opened(page, paths[0]);
}

/** A slit file without its subdivisions, which take most of the time. */
export function coarse(page, name) {
  const path = `${folder(page)}/${name}`;
  writeFileSync(
    path,
    JSON.stringify({
      ...JSON.parse(readFileSync(new URL(`../../examples/slit/${name}`, import.meta.url), 'utf8')),
      subdivisions: 0,
    }),
  );
  return path;
}

export async function opened(page, path) {
  await page.waitForFunction((n) => window.planish.store.state.document?.name === n, path.split('/').at(-1));
  await rested(page);
}

/** Ids of the documents that are open at the server of an address, asked for outside of any page. */
export async function documentsOf(address) {
  const { origin, hash } = new URL(address);
  const answer = await fetch(`${origin}/api/documents`, { headers: { 'X-Planish-Token': hash.slice(1) } });
  return (await answer.json()).map((d) => d.id);
}

/** A machine on which nothing is kept of earlier flows. */
async function forgetKept() {
  const { origin, hash } = new URL(address),
    headers = { 'X-Planish-Token': hash.slice(1) };
  for (const { name } of await (await fetch(`${origin}/api/kept`, { headers })).json())
    await fetch(`${origin}/api/kept/${encodeURIComponent(name)}`, { method: 'DELETE', headers });
}

/** Names of the documents that are open at the server. */
export const openAtServer = (page) =>
  page.evaluate(async () =>
    (await (await fetch('/api/documents', { headers: { 'X-Planish-Token': location.hash.slice(1) } })).json()).map(
      (d) => d.name,
    ),
  );

export async function download(page, format) {
  await page.click('[data-testid=download-menu]');
  const [file] = await Promise.all([page.waitForEvent('download'), page.click(`[data-testid="download-${format}"]`)]);
  const path = `${folder(page)}/${file.suggestedFilename()}`;
  await file.saveAs(path);
  return path;
}

export async function drag(page, from, by, steps = 12) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  for (let i = 1; i <= steps; ++i) {
    await page.mouse.move(from.x + (by.x * i) / steps, from.y + (by.y * i) / steps);
    await page.waitForTimeout(20);
  }
  await page.mouse.up();
}

export async function enter(page, testid, text) {
  await page.fill(`[data-testid="${testid}"]`, text);
  await page.keyboard.press('Enter');
}

export async function slide(page, testid, share) {
  await page.locator(`[data-testid="${testid}"]`).scrollIntoViewIfNeeded();
  const box = await page.locator(`[data-testid="${testid}"]`).boundingBox(),
    at = await page.$eval(`[data-testid="${testid}"]`, (e) => (e.value - e.min) / (e.max - e.min));
  const x = (s) => box.x + 8 + s * (box.width - 16);
  await drag(page, { x: x(at), y: box.y + box.height / 2 }, { x: x(share) - x(at), y: 0 });
}

export function timings(name, list) {
  const of = (key) => {
    const v = list
      .map((t) => t[key])
      .filter((x) => x !== null)
      .sort((a, b) => a - b);
    return v.length
      ? `${v[Math.floor(v.length / 2)].toFixed(1)} / ${v[Math.floor(0.95 * v.length)].toFixed(1)} ms`
      : '–';
  };
  console.log(
    `   ${name}: ${list.length} drafts; to geometry ${of('toGeometry')}, to the frame ${of('toFrame')} (median / 95 %)`,
  );
}
