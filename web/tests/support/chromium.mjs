// A headless Chromium that draws WebGL, in software by default, the same on every machine. SwiftShader takes
// most of the time to compile shaders, so pages of one browser share what it compiled. It keeps more freed
// memory, as giving it back waits for other cores: 8 % of the time of all tests.

import { chromium } from 'playwright-core';
import { chromiumPath } from './chromium-path.mjs';

const flags = ['--headless=new', '--no-sandbox', '--use-gl=angle', '--enable-unsafe-swiftshader',
  '--ignore-gpu-blocklist', '--enable-features=PartitionAllocLargeEmptySlotSpanRing', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync',
  '--enable-angle-features=preferGlobalPipelineCache'];

/** Give pages an adapter of WebGPU that computes on SwiftShader's Vulkan. */
const webGpuFlags = ['--enable-unsafe-webgpu', '--use-webgpu-adapter=swiftshader'];

/** Optimise WebAssembly only where it has run for long. */
const briefFlag = '--wasm-tiering-budget=60000000';

/**
 * `angle`: the GL that Chromium draws with; gl-egl is the system's own, for example Mesa's software
 * renderer. `webGpu`: whether pages have WebGPU. `composites`: whether that GL also composes the page,
 * which takes longer than the processor does. `brief`: whether pages run too briefly for optimised
 * WebAssembly to pay, as those of tests do: optimising it took 6 % of their time.
 */
export const launchChromium = ({ angle = 'swiftshader', webGpu = false, composites = false, brief = false } = {}) => chromium.launch({
  executablePath: chromiumPath,
  args: [...flags, ...(webGpu ? webGpuFlags : []), ...(composites ? [] : ['--disable-gpu-compositing']), `--use-angle=${angle}`,
    `--js-flags=--expose-gc${brief ? ` ${briefFlag}` : ''}`],
  env: { EGL_PLATFORM: 'surfaceless', ...process.env },
});
