import { inputError } from '../formats/diagnostics/inputError.ts';
import { msg } from '../messages/message.ts';
import type { HeadlessPage } from '../pipelines/headlessPage.ts';
import type { InteractiveRenderer } from '../pipelines/interactiveRenderer.ts';
import { picturesOf } from '../pipelines/interactiveSession.ts';
import { pipelineNamed } from '../pipelines/registry.ts';
import type { DomeMaps } from '../render/lights/sky/domeMaps.ts';
import { type StoredFile, setFileReader } from '../scene/streaming/storedNumbers.ts';
import { decodeTransfer } from '../scene/transfer/transferCodec.ts';
import type { Scene } from '../scene/types.ts';
import type { AovName } from '../scene/view/view.ts';

declare global {
  interface Window {
    slowlight: HeadlessPage;
  }
}

let renderer: InteractiveRenderer | undefined;

/** Between frames the page takes in what arrives: code that few pictures need, and files. */
const nextFrame = () => new Promise<void>((next) => void setTimeout(next));

const pictures = (opened: InteractiveRenderer) =>
  picturesOf(opened, { nextFrame, isShared: false, guard: (work) => work, assertHealthy: () => {} });

window.slowlight = {
  async start(id) {
    renderer?.dispose();
    const pipeline = pipelineNamed(id);
    renderer = await pipeline.openInteractive?.({ canvas: newCanvas(), backend: 'webgl' });
    if (!renderer) throw new Error(`pipeline ${id} draws no frames`);
    return { adapterName: adapterName(), largest: renderer.info.maxTextureSize };
  },

  async open({ scenes, files, width, height }) {
    if (!renderer) throw new Error('start first');
    setFileReader((file, at, length) => partOfFile(files, file, at, length));
    const [scene, ...others] = decodeTransfer(await (await fetch(scenes)).arrayBuffer()) as [Scene, ...Scene[]];
    renderer.setSize(width, height);
    await renderer.setScene(scene, others);
  },

  async showDome({ index, maps }) {
    renderer?.showDome?.(
      decodeTransfer(await (await fetch(maps, { cache: 'no-store' })).arrayBuffer()) as DomeMaps,
      index,
    );
  },

  async render(request) {
    if (!renderer) throw new Error('open a scene first');
    const { pixels, aovs } = await pictures(renderer).render(request);
    const read: Partial<Record<AovName, string>> = {};
    for (const [name, data] of aovs) read[name] = await base64(data);
    return { pixels: request.pixels ? await base64(pixels) : '', aovs: read };
  },

  async measure({ views, settings }) {
    if (!renderer) throw new Error('open a scene first');
    const { luminance, doppler, time } = await pictures(renderer).measureLight(views, settings);
    return { luminance: await base64(luminance), doppler: await base64(doppler), time: await base64(time) };
  },
};

/**
 * Synchronous, since the renderer waits: on the main thread a synchronous request returns bytes only as text, in the
 * low bytes of its characters.
 */
function partOfFile(files: string, { name, handle }: StoredFile, at: number, length: number): Uint8Array<ArrayBuffer> {
  const request = new XMLHttpRequest();
  request.open('GET', `${files}${at}/${length}/${encodeURIComponent(JSON.stringify(handle))}`, false);
  request.overrideMimeType('text/plain; charset=x-user-defined');
  request.send();
  if (request.status !== 200)
    throw inputError('file.changed', name, msg`it is not what was opened any more, or is gone; open the scene again`);
  return Uint8Array.from(request.responseText, (character) => character.charCodeAt(0));
}

function newCanvas(): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  document.body.replaceChildren(canvas);
  return canvas;
}

/** From a context of its own, to leave the renderer's untouched. */
function adapterName(): string {
  const gl = document.createElement('canvas').getContext('webgl2');
  const unmasked = gl?.getExtension('WEBGL_debug_renderer_info')?.UNMASKED_RENDERER_WEBGL;
  return String(gl?.getParameter(unmasked ?? gl.RENDERER) ?? 'WebGL2');
}

async function base64(data: Uint8Array | Float32Array): Promise<string> {
  const bytes = new Uint8Array(data.buffer, data.byteOffset, data.byteLength);
  const url = await new Promise<string>((resolve, reject) => {
    const reader = new FileReader();
    reader.addEventListener('load', () => resolve(String(reader.result)));
    reader.addEventListener('error', () => reject(reader.error));
    reader.readAsDataURL(new Blob([bytes.slice()]));
  });
  return url.slice(url.indexOf(',') + 1);
}
