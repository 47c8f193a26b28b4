import { IDENTITY } from '../../../src/math/quat.ts';
import { normalize } from '../../../src/math/vec3.ts';
import { properVelocity } from '../../../src/physics/lorentz/boost.ts';
import type { RasterRenderer } from '../../../src/render/api.ts';
import { makeObject, makeScene, restingAt } from '../../../src/scene/defaults.ts';
import type { FrameGraph, FrameGraphBuffer, FrameGraphPass } from '../../../src/scene/frameGraph/frameGraph.ts';
import { makeStillPixels, type StillPixels } from '../../../src/scene/frameGraph/still.ts';
import { box, plane, sphere } from '../../../src/scene/mesh/primitives.ts';
import { readShaderText } from '../../../src/scene/shaderText/shaderText.ts';
import type { DistantLight } from '../../../src/scene/types.ts';
import { perspective } from '../../../src/scene/view/lenses/perspectiveLens.ts';
import {
  type AovName,
  bufferSettings,
  DEFAULT_SETTINGS,
  type RenderSettings,
  type ViewPoint,
} from '../../../src/scene/view/view.ts';

export const SIZE = { width: 64, height: 48 };

export const VIEW: ViewPoint = {
  t: 0,
  position: [0, 0.5, 2],
  u: properVelocity([0.1, 0, -0.5]),
  orientation: IDENTITY,
  lens: perspective(1),
};

const SUN: DistantLight = {
  kind: 'distant',
  path: '/sun',
  color: [2, 1.9, 1.7],
  direction: normalize([-0.5, -1, -0.3]),
};
const yard = makeScene({
  name: 'yard',
  lights: [SUN],
  objects: [
    makeObject({ path: '/floor', mesh: plane(30, 30), motion: restingAt([0, -1, -8]) }),
    makeObject({ path: '/still', mesh: sphere(1), motion: restingAt([-1.2, 0, -5]) }),
    makeObject({ path: '/box', mesh: box([1, 1, 1]), motion: restingAt([1.5, -0.3, -4]) }),
  ],
});
const ball = makeScene({
  name: 'ball',
  lights: yard.lights,
  objects: [makeObject({ path: '/ball', mesh: sphere(1.5), motion: restingAt([0.5, 0.5, -6]) })],
});
export const SCENES = [yard, ball] as const;

/** Without shadows and occlusion, whose shaders compile slowly and do not matter for frame graphs. */
const base: RenderSettings = { ...DEFAULT_SETTINGS, speedOfLight: 1, shadows: false, occlusionRadius: 0 };
const { tone: _, grid: __, exposure: ___, shadows: ____, occlusionRadius: _____, ...optics } = base;
const ORDINARY: FrameGraphBuffer = { ...optics, view: 'galilean', dopplerMix: 0, beaming: 0, scene: 0 };
const OTHER: FrameGraphBuffer = { ...optics, scene: 1 };

const TEXT = `
fn effect(p: Pixel) -> vec4f {
  let near = 1 / (1 + depth(vec2i(0)));
  return vec4f(p.color.rgb * arg1 + vec3f(near, abs(normal(vec2i(1, 0)).y), doppler(vec2i(0)) * arg2), 1);
}`;

/** A different colour per pixel, dark and bright, none exactly a half float. */
export const still = (width: number, height: number): StillPixels =>
  makeStillPixels(
    width,
    height,
    Float32Array.from({ length: 3 * width * height }, (_, i) => (((i * 2654435761) % 1009) / 1009) ** 3 * 40),
  );
/** Smaller, larger and narrower than the picture, of equal height, and of another aspect ratio. */
export const STILLS = [
  [SIZE.width, SIZE.height],
  [31, 17],
  [150, 131],
  [21, SIZE.height],
  [300, SIZE.height],
] as const;
/** A still, displayed unchanged. */
export const showing = (shown: StillPixels): RenderSettings => ({
  ...base,
  frameGraph: { extraBuffers: [], passes: [{ kind: 'still', still: shown }] },
});

const REACH = 3;
/** Every kind of pass: three G-buffers of two scenes, images read by several passes, effects of both kinds, a still, and masks. */
const EVERYTHING: readonly FrameGraphPass[] = [
  { kind: 'light', buffer: 0, shadows: false, occlusion: false },
  { kind: 'occlusion', buffer: 0, radius: REACH },
  { kind: 'effect', effect: 'bilateral-filter', args: [2], image: 1, buffer: 0 },
  { kind: 'mix', mode: 'multiply', alpha: 1, below: 0, above: 2 },
  { kind: 'light', buffer: 1, shadows: false, occlusion: false },
  {
    kind: 'effect',
    effect: { text: TEXT, program: readShaderText(TEXT) },
    args: [0.5, 0.3],
    image: 4,
    buffer: 0,
    mask: 2,
  },
  { kind: 'tone', tone: 'agx', exposure: -1, metering: 'manual', image: 3 },
  { kind: 'false-colour', of: 'doppler', scale: { from: 0.5, to: 2 }, image: 6, buffer: 0 },
  { kind: 'mix', mode: 'split', alpha: 0.5, below: 7, above: 5 },
  { kind: 'light', buffer: 2, shadows: false, occlusion: false },
  { kind: 'mix', mode: 'normal', alpha: 0.5, below: 8, above: 9 },
  { kind: 'mix', mode: 'add', alpha: 0.3, below: 10, above: 6 },
  { kind: 'still', still: still(20, 30) },
  { kind: 'mix', mode: 'add', alpha: 0.01, below: 11, above: 12 },
  { kind: 'effect', effect: 'vignette', args: [1, 4, 0], image: 13, buffer: 2 },
];
export const FRAME_GRAPH: FrameGraph = { extraBuffers: [ORDINARY, OTHER], passes: EVERYTHING };
export const SETTINGS: RenderSettings = { ...base, frameGraph: FRAME_GRAPH };

/** Shadow settings of two lighting passes of one G-buffer. */
export const SHADOWS: RenderSettings = {
  ...base,
  shadows: true,
  frameGraph: {
    extraBuffers: [],
    passes: [
      { kind: 'light', buffer: 0, shadows: true, occlusion: false },
      { kind: 'light', buffer: 0, shadows: false, occlusion: false },
      { kind: 'mix', mode: 'difference', alpha: 1, below: 0, above: 1 },
    ],
  },
};

export type Data = Partial<Record<AovName, readonly number[]>>;
export interface RenderedFrameGraph {
  readonly light: readonly number[];
  /** Of each G-buffer separately. */
  readonly buffers: readonly Data[];
}

/** The light of stills displayed one after another. */
export async function renderStillImages(renderer: RasterRenderer): Promise<number[][]> {
  renderer.setSize(SIZE.width, SIZE.height);
  await renderer.setScene(SCENES[0]);
  const lights: number[][] = [];
  for (const [width, height] of STILLS) {
    renderer.render([VIEW], showing(still(width, height)));
    lights.push([...(await renderer.readAov('beauty'))]);
  }
  return lights;
}

/** The light of the frame graph, and its inputs. */
export async function renderFrameGraph(
  renderer: RasterRenderer,
  needed: readonly (readonly AovName[])[],
): Promise<RenderedFrameGraph> {
  renderer.setSize(SIZE.width, SIZE.height);
  const buffers: Data[] = [];
  for (const [i, names] of needed.entries()) {
    const { frameGraph: _, ...settings } = bufferSettings(SETTINGS, i);
    await renderer.setScene(SCENES[FRAME_GRAPH.extraBuffers[i - 1]?.scene ?? 0]!);
    const read = async (name: AovName): Promise<readonly number[]> => {
      // Light and occlusion have different settings.
      renderer.render([VIEW], name === 'occlusion' ? { ...settings, occlusionRadius: REACH } : settings);
      return [...(await renderer.readAov(name))];
    };
    const data: Data = {};
    for (const name of names) data[name] = await read(name);
    buffers.push(data);
  }
  await renderer.setScene(SCENES[0], SCENES.slice(1));
  renderer.render([VIEW], SETTINGS);
  return { light: [...(await renderer.readAov('beauty'))], buffers };
}
