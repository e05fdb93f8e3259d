// The page of a batch in a browser, opened as a file: node test/batch-page.mjs INDEX.HTML PICTURES. Says what it saw
// as a line of JSON, and keeps screenshots in PICTURES.
import { pathToFileURL } from 'node:url';
import { launch } from './launch.mjs';

const [file, pictures] = process.argv.slice(2);
const browser = await launch();
const page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
const said = [];
page.on('console', (message) => said.push(message.text()));
page.on('pageerror', (error) => said.push(String(error)));
page.on('requestfailed', (request) => said.push(`failed: ${request.url()}`));
const seen = {};

/** Pictures that have been loaded, and rows that stand on the page. */
const loaded = () =>
  page.evaluate(() => ({
    rows: document.querySelectorAll('#rows tr').length,
    pictures: [...document.images].filter((image) => image.complete && image.naturalWidth > 0).length,
    broken: [...document.images].filter((image) => image.complete && image.naturalWidth === 0).length,
  }));
const names = () =>
  page.evaluate(() => [...document.querySelectorAll('#rows tr')].map((row) => row.cells[1].textContent));
const count = () => page.textContent('#count');

const begun = performance.now();
await page.goto(pathToFileURL(file).href);
await page.waitForSelector('#rows tr');
seen.open = (performance.now() - begun) / 1000;
await page.waitForTimeout(300);
seen.first = await loaded();
seen.firstStatus = await page.textContent('#rows tr .status');
await page.screenshot({ path: `${pictures}/top.png` });
await page.evaluate(() => window.scrollTo(0, 20000));
await page.waitForTimeout(700);
await page.evaluate(() => window.scrollTo(0, 8000));
await page.waitForTimeout(700);
seen.scrolled = await loaded();
await page.screenshot({ path: `${pictures}/scrolled.png` });

seen.sums = await page.evaluate(() => [...document.querySelectorAll('#sums button')].map((one) => one.textContent));
seen.passed = await page.textContent('#passed-count');
await page.click('#sums button.refused');
seen.refused = await count();
seen.why = await page.textContent('#rows tr .status');
await page.selectOption('#status', 'ok');
seen.ok = await count();
await page.selectOption('#status', '');
await page.fill('#name', '-0012.');
seen.named = await names();
await page.fill('#name', '');
await page.fill('#from', '100');
await page.fill('#to', '110');
seen.sized = await count();
await page.fill('#from', '');
await page.fill('#to', '');
await page.click('th[data-key=length] button');
seen.sorted = (await page.getAttribute('th[data-key=length]', 'aria-sort')) + ' ' + (await names())[0];
await page.click('th[data-key=length] button');
seen.down = (await names())[0];
for (let i = 0; i < 2; ++i) await page.click('th[data-key=copies] button');
const same = page.locator('td button').first();
if (await same.count()) {
  await same.click();
  seen.same = await names();
  await page.click('#same');
}
seen.all = await count();
seen.reasons = await page.evaluate(() => [...document.querySelectorAll('#reason option')].map((one) => one.value));
await browser.close();
console.log(JSON.stringify({ ...seen, said }));
