import { createRequire } from 'node:module';

const axe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

/** What axe-core says against the page as it is now, a line each. */
export async function violations(page) {
  if (!(await page.evaluate(() => 'axe' in window))) await page.addScriptTag({ path: axe });
  return page.evaluate(async () =>
    (await window.axe.run()).violations.flatMap(({ id, nodes }) =>
      nodes.map((n) => `${id}: ${n.target} ${(n.any[0] ?? n.all[0] ?? n.none[0])?.message ?? ''}`),
    ),
  );
}

/** The page in a theme, drawn. */
export async function inTheme(page, theme) {
  await page.evaluate((t) => {
    document.documentElement.dataset.theme = t;
    window.planish.store.dispatch({ type: 'theme', theme: t });
  }, theme);
  await page.waitForTimeout(50);
}

/** What is found against the page in both themes, a state after the other; `found` has a line each. */
export function looker(page) {
  const found = [];
  const look = async (what) => {
    for (const theme of ['light', 'dark']) {
      await inTheme(page, theme);
      for (const line of await violations(page)) found.push(`${what}, ${theme}: ${line}`);
    }
  };
  return { found, look };
}
