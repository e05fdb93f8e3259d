// Pictures of the page for docs/studio.md: node test/screens.mjs ADDRESS [NAME …]
// Each state is taken light and dark, at 1280 × 720 and at 2560 × 1440, to docs/studio/NAME-{light,dark}[-large].webp.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, statSync, writeFileSync } from 'node:fs';
import { browser, fresh } from './driving.mjs';
import { scenes } from './scenes.mjs';

const address = process.argv[2],
  wanted = process.argv.slice(3),
  shown = new URL('../../docs/studio/', import.meta.url).pathname,
  made = `${process.env.STUDIO_FILES ?? '/tmp/planish-studio-files'}/known`;
const sizes = [
  { suffix: '', width: 1280, height: 720 },
  { suffix: '-large', width: 2560, height: 1440 },
];

/** A PNG as a WebP, made by the page: without loss where that takes less, as it does of what is mostly flat. */
const webp = (page, png) =>
  page.evaluate(async (data) => {
    const image = new Image();
    image.src = `data:image/png;base64,${data}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    canvas.getContext('2d').drawImage(image, 0, 0);
    const blobs = await Promise.all([0.8, 1].map((quality) => canvas.convertToBlob({ type: 'image/webp', quality })));
    const [least] = blobs.sort((a, b) => a.size - b.size);
    return [...new Uint8Array(await least.arrayBuffer())];
  }, png.toString('base64'));

async function inTheme(page, theme) {
  await page.evaluate((t) => {
    document.documentElement.dataset.theme = t;
    window.planish.store.dispatch({ type: 'theme', theme: t });
  }, theme);
  await page.waitForTimeout(400);
}

/** Another size needs the part fitted anew; what is near to the pointer stays as it is. */
async function inSize(page, { width, height }, fitted) {
  await page.setViewportSize({ width, height });
  await page.waitForTimeout(300);
  if (fitted) await page.evaluate(() => window.planish.views.fit());
  await page.waitForFunction(() => !window.planish.store.state.computing);
  await page.waitForTimeout(700);
}

if (!existsSync(`${made}/all_parts.step`))
  execFileSync('python3', ['../tools/make_known_parts.py', made, '--together'], {
    cwd: new URL('..', import.meta.url).pathname,
  });
if (!existsSync(`${made}/lanced.step`))
  writeFileSync(
    `${made}/lanced.step`,
    execFileSync('python3', ['-c', 'import step_files; print(step_files.lanced())'], {
      cwd: new URL('../../tests/cli', import.meta.url).pathname,
    }),
  );
mkdirSync(shown, { recursive: true });
let total = 0;
for (const [name, scene] of Object.entries(scenes)) {
  if (wanted.length && !wanted.includes(name)) continue;
  const { page, said, context } = await fresh({ name: `screen-${name}` });
  const { fitted = true, finish } = (await scene({ page, address, made })) ?? {};
  for (const size of sizes) {
    await inSize(page, size, fitted);
    await finish?.(size);
    for (const theme of ['light', 'dark']) {
      await inTheme(page, theme);
      const path = `${shown}${name}-${theme}${size.suffix}.webp`;
      writeFileSync(path, Buffer.from(await webp(page, await page.screenshot({ caret: 'hide' }))));
      total += statSync(path).size;
    }
  }
  console.log(`${name}${said.length ? `: ${said.join('; ')}` : ''}`);
  await context.close();
}
console.log(`${Math.round(total / 1024)} KiB`);
await browser.close();
