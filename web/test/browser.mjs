// The page against a running server: node test/browser.mjs ADDRESS [FLOW …]. What a flow downloads is written to a
// folder of its name in STUDIO_FILES; STUDIO_PROCESS is the server's process, whose workers one flow ends.
import assert from 'node:assert/strict';
import { browser, documentsOf, folder, fresh } from './driving.mjs';
import * as access from './flows/access.mjs';
import * as away from './flows/away.mjs';
import * as bodies from './flows/bodies.mjs';
import * as connect from './flows/connect.mjs';
import * as features from './flows/features.mjs';
import * as frames from './flows/frames.mjs';
import * as hands from './flows/hands.mjs';
import * as hover from './flows/hover.mjs';
import * as look from './flows/look.mjs';
import * as measure from './flows/measure.mjs';
import * as lists from './flows/lists.mjs';
import * as numbers from './flows/numbers.mjs';
import * as order from './flows/order.mjs';
import * as page from './flows/page.mjs';
import * as panels from './flows/panels.mjs';
import * as refusal from './flows/refusal.mjs';
import * as right from './flows/right.mjs';
import * as server from './flows/server.mjs';
import * as slit from './flows/slit.mjs';
import * as small from './flows/small.mjs';
import * as start from './flows/start.mjs';
import * as states from './flows/states.mjs';
import * as transition from './flows/transition.mjs';
import * as unfold from './flows/unfold.mjs';

const address = process.argv[2],
  wanted = process.argv.slice(3);
const flows = {
  ...unfold,
  ...order,
  ...numbers,
  ...connect,
  ...transition,
  ...slit,
  ...panels,
  ...page,
  ...features,
  ...frames,
  ...hands,
  ...hover,
  ...measure,
  ...look,
  ...lists,
  ...bodies,
  ...right,
  ...refusal,
  ...server,
  ...access,
  ...states,
  ...start,
  ...away,
  ...small,
};

/** Waits until a page that was left has closed its documents, which it asks for without waiting for the answer. */
async function letGo(open) {
  const end = performance.now() + 60000;
  for (;;) {
    const now = await documentsOf(address);
    if (now.join() === open.join()) return;
    assert.ok(performance.now() < end, `the page left documents open: ${now} instead of ${open}`);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}

/** What the page was busy with when a flow failed. */
const stateOf = (page) =>
  page
    .evaluate(() => {
      const { document: d, computing, busy, opening, stale, shapeIsDraft, problem, note } = window.planish.store.state;
      return JSON.stringify({ open: d?.name, computing, busy, opening, stale, shapeIsDraft, problem, note });
    })
    .catch(String);

let failed = 0;
for (const [name, flow] of Object.entries(flows)) {
  if (wanted.length ? !wanted.includes(name) : flow.isAlone) continue;
  const begun = performance.now(),
    open = await documentsOf(address),
    given = await fresh({ name });
  try {
    const file = await flow(given);
    await given.page.goto('about:blank');
    await letGo(open);
    assert.deepEqual(given.said, [], 'nothing on the console');
    console.log(`ok ${name}${file ? ` (${file})` : ''} ${((performance.now() - begun) / 1000).toFixed(1)} s`);
  } catch (error) {
    ++failed;
    await given.page.screenshot({ path: `${folder(given.page)}/failed.png` });
    console.log(`not ok ${name}: ${error.message}\n   ${await stateOf(given.page)}\n   ${given.said.join('\n   ')}`);
  }
  await given.context.close();
}
await browser.close();
process.exitCode = failed ? 1 : 0;
