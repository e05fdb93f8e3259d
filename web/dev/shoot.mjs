// Screenshots of the page: node dev/shoot.mjs ADDRESS OUT STEP… ; a step is `example:NAME`, `tab:NAME`, `wait:MS`,
// `shot:NAME`, `click:TESTID`, `key:KEY`, `dark`, `eval:CODE`.
import { launch } from '../test/launch.mjs';
import { serveDist } from '../test/serve-dist.mjs';
const [address, out, ...steps] = process.argv.slice(2);
const browser = await launch();
const page = await browser.newPage({ viewport: { width: 1280, height: 720 }, bypassCSP: true });
page.on('console', (m) => {
  if (['error', 'warning'].includes(m.type())) console.log('console', m.type(), m.text());
});
page.on('pageerror', (e) => console.log('pageerror', e.message));
page.on('response', (r) => {
  if (r.status() >= 400) console.log(r.status(), r.request().method(), r.url());
});
await serveDist(page, address);
await page.goto(address);
await page.waitForTimeout(800);
const settled = () =>
  page.waitForFunction(
    () => {
      const s = window.planish.store.state;
      return s.document && s.shape && !s.shapeIsDraft && !s.computing;
    },
    null,
    { timeout: 20000 },
  );
for (const step of steps) {
  const at = step.indexOf(':'),
    verb = at < 0 ? step : step.slice(0, at),
    rest = at < 0 ? '' : step.slice(at + 1);
  try {
    if (verb === 'example') {
      await page.evaluate((n) => {
        document.querySelector('[data-testid="examples-menu"]').click();
        setTimeout(() => document.querySelector(`[data-testid="example-${n}"]`).click(), 50);
      }, rest);
      await page.waitForFunction((n) => window.planish.store.state.document?.name === n, rest.split('/').at(-1));
      await page.waitForTimeout(300);
      await settled();
      await page.waitForTimeout(400);
    } else if (verb === 'open') {
      await page.setInputFiles('[data-testid=file-input]', rest.split(','));
      await page.waitForFunction(
        (n) => window.planish.store.state.document?.name === n,
        rest.split(',')[0].split('/').at(-1),
      );
      await page.waitForTimeout(300);
      await settled();
      await page.waitForTimeout(400);
    } else if (verb === 'settled') {
      await settled();
      await page.waitForTimeout(300);
    } else if (verb === 'tab') await page.click(`[data-testid="tab-${rest}"]`);
    else if (verb === 'wait') await page.waitForTimeout(Number(rest));
    else if (verb === 'click') await page.click(`[data-testid="${rest}"]`, { timeout: 3000 });
    else if (verb === 'key') await page.keyboard.press(rest);
    else if (verb === 'dark') {
      await page.emulateMedia({ colorScheme: 'dark' });
      await page.click('[data-testid=theme]');
    } else if (verb === 'eval') console.log('eval', JSON.stringify(await page.evaluate(rest)));
    else if (verb === 'shot') {
      await page.waitForTimeout(250);
      await page.screenshot({ path: `${out}/${rest}.png` });
    }
  } catch (e) {
    console.log('step', step, 'failed:', e.message.split('\n')[0], await page.textContent('.messages'));
  }
}
await browser.close();
