// A tab of Chromium that shows the element, for measuring.

import { readFileSync } from 'node:fs';
import { launchChromium } from '../tests/support/chromium.mjs';
import { serve } from '../tests/support/server.mjs';

/** Calls use() with a tab that has a loaded <edgeshade-viewer>, on SwiftShader. */
export async function withViewerTab(use) {
  const server = await serve();
  const browser = await launchChromium({ composites: true });
  try {
    const tab = await browser.newPage({ viewport: { width: 960, height: 540 } });
    await tab.goto(`${server.address}/tests/plain.html`);
    await tab.waitForFunction(() => document.querySelector('edgeshade-viewer')?.loaded);
    await use(tab);
  } finally {
    await browser.close();
    await server.close();
  }
}

/** A file as a page's code can take it. */
export const base64Of = (file) => readFileSync(file).toString('base64');
