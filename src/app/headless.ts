import { urlSource } from '../editor/loading/sources.ts';
import { openScene } from '../formats/open.ts';
import type { Interpolation } from '../formats/registry.ts';
import { SceneRenderer } from '../render/renderer.ts';
import { changeMotion, type MotionChange } from '../scene/change.ts';
import type { AovName, RenderSettings, ViewPoint } from '../scene/view.ts';

/**
 * The page that the command line drives where a picture is to be made with WebGL2. It draws one scene, opened from the server
 * that serves this page, and gives its pictures back as base64, which is what a remote call can carry.
 *
 * `await page.goto('…/headless.html')`, then
 * `await page.evaluate((r) => window.slowlight.open(r), { base: 'http://127.0.0.1:1234/scene/', entry: 'street.usda', width: 640, height: 360, variants: [] })`
 * once, and `await page.evaluate((r) => window.slowlight.render(r), { view, settings, samples: 1, aovs: ['depth'] })` per picture.
 * Errors reject the call with the reader's or the renderer's own message.
 */
interface HeadlessPage {
  open(request: OpenRequest): Promise<OpenReply>;
  render(request: RenderRequest): Promise<RenderReply>;
}

interface OpenRequest {
  /** Address of the folder of the scene, of this page's origin, ending with '/'. */
  readonly base: string;
  /** File in that folder. */
  readonly entry: string;
  /** As ReadOptions has them. */
  readonly animation?: string | number;
  readonly interpolation?: Interpolation;
  readonly subdivision?: number;
  readonly variants: readonly (readonly [set: string, option: string])[];
  /** How its things are to move, with the speed of light that flights are measured by [m/s]. */
  readonly motion?: MotionChange & { readonly speedOfLight: number };
  /** Of the pictures [px]. */
  readonly width: number;
  readonly height: number;
}

interface OpenReply {
  /** What draws, as the browser names it. */
  readonly adapterName: string;
}

interface RenderRequest {
  readonly view: ViewPoint;
  readonly settings: RenderSettings;
  /** n × n samples per pixel. */
  readonly samples: number;
  readonly aovs: readonly AovName[];
}

interface RenderReply {
  /** Base64 of RGBA8, sRGB, rows from the top. */
  readonly pixels: string;
  /** Base64 of little-endian f32, in the AOV's own channels, rows from the top. */
  readonly aovs: Readonly<Partial<Record<AovName, string>>>;
}

declare global {
  interface Window {
    slowlight: HeadlessPage;
  }
}

let renderer: SceneRenderer | undefined;

window.slowlight = {
  async open({ base, entry, width, height, animation, interpolation, subdivision, variants, motion }) {
    const read = await openScene(
      urlSource(base, () => {}),
      entry,
      {
        ...(animation !== undefined && { animation }),
        ...(interpolation && { interpolation }),
        ...(subdivision !== undefined && { subdivision }),
        variants: new Map(variants),
      },
    );
    const scene = motion ? changeMotion(read, motion, motion.speedOfLight) : read;
    renderer?.dispose();
    renderer = await SceneRenderer.create({ canvas: newCanvas(width, height), backend: 'webgl' });
    renderer.setSize(width, height);
    await renderer.setScene(scene);
    return { adapterName: adapterName() };
  },

  async render({ view, settings, samples, aovs }) {
    if (!renderer) throw new Error('open a scene first');
    renderer.render(view, settings, samples);
    const pixels = await base64(await renderer.readPixels());
    const read: Partial<Record<AovName, string>> = {};
    for (const name of aovs) read[name] = await base64(await renderer.readAov(name));
    return { pixels, aovs: read };
  },
};

function newCanvas(width: number, height: number): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  document.body.replaceChildren(canvas);
  return canvas;
}

/** Of a context of its own: the renderer's is not to be touched. */
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
