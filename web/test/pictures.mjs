// Pictures of the examples for the start screen, drawn by the page itself: node test/pictures.mjs ADDRESS
// They go to public/pictures as transparent WebP, which suits both themes.
import { mkdirSync, writeFileSync } from 'node:fs';
import { browser, example, fresh } from './driving.mjs';

const width = 264,
  times = 3; // as large it is drawn, and then made small
const bare = `.buttons, .fold, .machine, .over, .view.flat { display: none !important }
  main { display: block !important }
  .view.folded { width: ${times * width}px !important; height: ${(times * width * 5) / 8}px !important }`;

/** The page on a background, as a PNG. */
async function shown(page, background) {
  await page.evaluate((colour) => {
    const { style } = document.documentElement,
      { store } = window.planish;
    style.setProperty('--view', colour);
    for (const theme of ['dark', 'light']) store.dispatch({ type: 'theme', theme });
  }, background);
  await page.waitForTimeout(300);
  return (await page.locator('.folded .canvas').screenshot()).toString('base64');
}

/** What is the same on black and on white is opaque; the rest lets the background through. */
const transparent = (page, black, white) =>
  page.evaluate(
    async ([dark, light, width]) => {
      const read = async (png) => {
        const image = new Image();
        image.src = `data:image/png;base64,${png}`;
        await image.decode();
        const height = Math.round((width * image.height) / image.width),
          canvas = new OffscreenCanvas(width, height),
          context = canvas.getContext('2d');
        context.drawImage(image, 0, 0, width, height);
        return { canvas, context, data: context.getImageData(0, 0, width, height) };
      };
      const [a, b] = [await read(dark), await read(light)],
        [onBlack, onWhite] = [a.data.data, b.data.data];
      for (let i = 0; i < onBlack.length; i += 4) {
        const alpha = 255 - Math.max(...[0, 1, 2].map((k) => onWhite[i + k] - onBlack[i + k]));
        for (let k = 0; k < 3; ++k) onBlack[i + k] = alpha > 0 ? Math.min(255, (255 * onBlack[i + k]) / alpha) : 0;
        onBlack[i + 3] = alpha;
      }
      a.context.putImageData(a.data, 0, 0);
      const blob = await a.canvas.convertToBlob({ type: 'image/webp', quality: 0.8 });
      return [...new Uint8Array(await blob.arrayBuffer())];
    },
    [black, white, width],
  );

const { page } = await fresh({ name: 'pictures' });
await page.setViewportSize({ width: 1600, height: 900 });
const firsts = await page.evaluate(() => window.planish.store.state.examples.map((e) => e.name));
for (const name of firsts) {
  await example(page, name);
  await page.waitForTimeout(300);
  const style = await page.addStyleTag({ content: bare });
  await page.waitForTimeout(200);
  await page.evaluate(() => {
    window.planish.views.folded.look('iso');
    window.planish.views.folded.fit();
  });
  const [black, white] = [await shown(page, '#000000'), await shown(page, '#ffffff')];
  const path = new URL(`../public/pictures/${name.replace(/\.\w+$/, '.webp')}`, import.meta.url);
  mkdirSync(new URL('.', path), { recursive: true });
  writeFileSync(path, Buffer.from(await transparent(page, black, white)));
  await style.evaluate((s) => s.remove());
}
await browser.close();
