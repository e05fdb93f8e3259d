import { chromium } from 'playwright-core';

/**
 * Debian's Chromium, drawing in software as it does by itself where there is no graphics card. A page that tests put in
 * the place of the server's comes from no address, and would need leave to speak to this machine.
 */
export const launch = () =>
  chromium.launch({
    executablePath: '/usr/bin/chromium',
    args: [
      '--no-sandbox',
      '--enable-unsafe-swiftshader',
      ...(process.env.STUDIO_DIST ? ['--disable-features=LocalNetworkAccessChecks'] : []),
    ],
  });
