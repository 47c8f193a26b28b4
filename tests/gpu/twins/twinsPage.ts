import { WebGPURenderer } from 'three/webgpu';
import { twinRegistry } from '../../../src/shaders/twins/registry.ts';
import { casesOf } from './compareTwin.ts';
import { pipelines } from './precision.ts';
import { renderTwin } from './runTwin.ts';
import { surfaceCodes } from './surfaceCodes.ts';

declare global {
  interface Window {
    /** Runs a twin on WebGL2; returns its outputs. */
    runTwin: (name: string, seed: number) => Promise<number[]>;
  }
}

let opened: Promise<WebGPURenderer> | undefined;

async function open(): Promise<WebGPURenderer> {
  const renderer = new WebGPURenderer({ forceWebGL: true });
  await renderer.init();
  return renderer;
}

window.runTwin = async (name, seed) => {
  opened ??= open();
  const twin = [...twinRegistry, ...pipelines, ...surfaceCodes].find((candidate) => candidate.name === name);
  if (!twin) throw new Error(`no twin is called ${name}`);
  return [...(await renderTwin(await opened, twin, casesOf(twin, seed)))];
};
