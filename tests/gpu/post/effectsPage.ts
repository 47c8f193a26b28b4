import { type Gpu, openGpu } from '../../../src/render/gpu/device.ts';
import { EFFECT_CASES } from './effectCases.ts';
import { runEffect } from './runEffect.ts';

declare global {
  interface Window {
    /** Runs one of the cases on WebGL2. */
    drawEffect: (name: string) => Promise<number[]>;
  }
}

let opened: Promise<Gpu> | undefined;

window.drawEffect = async (name) => {
  opened ??= openGpu({ canvas: document.createElement('canvas'), backend: 'webgl' });
  const of = EFFECT_CASES.find((candidate) => candidate.name === name);
  if (!of) throw new Error(`no case is called ${name}`);
  return [...(await runEffect(await opened, of))];
};
