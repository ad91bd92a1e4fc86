// The element's contents: the picture, its progress bar, its notices.

export const look = `
<style>
  :host { display: block; position: relative; min-height: 8rem; overflow: hidden; contain: strict;
    --edgeshade-accent: #b4531a; --edgeshade-surface: #fbfaf8; --edgeshade-ink: #23201c;
    background: #dbe3eb; font: 14px/1.45 system-ui, sans-serif; }
  @media (prefers-color-scheme: dark) {
    :host { --edgeshade-accent: #f0a067; --edgeshade-surface: #262422; --edgeshade-ink: #eee9e2;
      background: #3e464f; }
  }
  :host([hidden]) { display: none; }
  canvas { display: block; width: 100%; height: 100%; touch-action: none; outline: none; }
  canvas:focus-visible + .ring { box-shadow: inset 0 0 0 3px var(--edgeshade-accent); }
  .ring { position: absolute; inset: 0; pointer-events: none; }
  .progress { position: absolute; inset: 0 0 auto; pointer-events: none; }
  .progress[hidden] { display: none; }
  .bar { height: 4px; background: color-mix(in srgb, var(--edgeshade-accent) 22%, transparent); }
  .bar > div { height: 100%; width: 0; background: var(--edgeshade-accent);
    transition: width .12s linear; }
  .stage { display: inline-block; margin: .6rem; padding: .2rem .6rem; border-radius: .4rem;
    background: var(--edgeshade-surface); color: var(--edgeshade-ink);
    font-variant-numeric: tabular-nums; }
  .notices { position: absolute; inset: var(--edgeshade-notices-inset, auto 0 0); display: grid; gap: .5rem;
    justify-items: center; padding: .8rem;
    pointer-events: none; }
  .notice { display: flex; gap: .8rem; align-items: start; max-width: 34rem; padding: .6rem .8rem;
    border-radius: .5rem; pointer-events: auto; background: var(--edgeshade-surface);
    color: var(--edgeshade-ink); border-left: 4px solid var(--edgeshade-accent);
    box-shadow: 0 4px 18px rgb(0 0 0 / .25); overflow-wrap: anywhere; }
  .notice[data-kind=error] { border-color: #c8321f; }
  .notice button { font: inherit; color: inherit; background: none; border: 0; padding: 0 .3rem;
    cursor: pointer; border-radius: .3rem; }
  .notice button:focus-visible { outline: 2px solid var(--edgeshade-accent); }
  @media (prefers-reduced-motion: reduce) { * { transition: none !important; } }
</style>
<canvas tabindex="0" role="application" aria-roledescription="3D view"></canvas>
<div class="ring"></div>
<div class="progress" role="progressbar" aria-label="Loading" aria-valuemin="0" aria-valuemax="100" hidden><div class="bar"><div></div></div><span class="stage"></span></div>
<div class="notices"></div>
<slot></slot>
`;
