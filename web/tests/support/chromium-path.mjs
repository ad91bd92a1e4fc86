// The Chromium that draws tests' pages; run as a program, this prints its path.

import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

/** The engine alone takes half the processor time of the whole browser. */
const programs = ['/usr/bin/chromium-headless-shell', '/usr/bin/chromium'];

/** undefined: there is none. */
export const chromiumPath = [process.env.EDGESHADE_CHROMIUM ?? programs].flat().find((path) => existsSync(path));

if (process.argv[1] === fileURLToPath(import.meta.url)) console.log(chromiumPath ?? '');
