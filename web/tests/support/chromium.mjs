// A Chromium without a window that draws WebGL in software, the same everywhere.

import { chromium } from 'playwright-core';

const flags = ['--headless=new', '--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync',
  '--js-flags=--expose-gc'];

export const launchChromium = () => chromium.launch({
  executablePath: process.env.EDGESHADE_CHROMIUM ?? '/usr/bin/chromium',
  args: flags,
});
