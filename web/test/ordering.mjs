// The bend order, as a user has it: planned, changed, checked.

export const drawn = (page) =>
  page.evaluate(() => new Promise((f) => requestAnimationFrame(() => requestAnimationFrame(f))));

/** Waits until the order that is shown has been checked, and is drawn. */
export async function checked(page) {
  await page.waitForFunction(() => {
    const { order } = window.planish.store.state;
    return order.answer && !order.computing && !order.asked;
  });
  await drawn(page);
}

export async function plan(page) {
  await page.click('[data-testid=tab-order]');
  await page.click('[data-testid=plan]');
  await checked(page);
}

/** The bends in the order of their strokes. */
export const strokeNames = (page) =>
  page.$$eval('[data-testid=strokes] li', (rows) => rows.map((row) => row.getAttribute('data-stroke')));

/** Of a channel that is planned: its second stroke first, and the collision that this makes. */
export async function collide(page) {
  await page.focus('[data-testid=stroke-2]');
  await page.keyboard.press('Alt+ArrowUp');
  await page.waitForFunction(() => window.planish.store.state.order.given);
  await checked(page);
  await page.click('[data-testid=stroke-2]');
  await page.waitForSelector('[data-testid=collision]');
}
