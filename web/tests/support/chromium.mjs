// A Chromium without a window that draws WebGL in software, the same everywhere.

import { chromium } from 'playwright-core';

const flags = ['--headless=new', '--no-sandbox', '--use-gl=angle', '--enable-unsafe-swiftshader',
  '--ignore-gpu-blocklist', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync',
  '--js-flags=--expose-gc'];

/** `angle`: what Chromium draws with; gl-egl is the system's own GL, Mesa's software for one. */
export const launchChromium = ({ angle = 'swiftshader' } = {}) => chromium.launch({
  executablePath: process.env.EDGESHADE_CHROMIUM ?? '/usr/bin/chromium',
  args: [...flags, `--use-angle=${angle}`],
  env: { EGL_PLATFORM: 'surfaceless', ...process.env },
});
