import { build, type NodeSketch } from './buildProject.ts';

/** 0.6 c, the slower one of the two speeds that the paper shows. */
const BETA = 0.6;

/** What the texture-based paper (docs/physics.md §14) draws of a view, at the left, and what spectra make of it, at the right; each with its own exposure, that at the right changed by `seen` [EV]. */
const sideBySide = (view: string, seen: number): Readonly<Record<string, NodeSketch>> => ({
  paper: {
    type: 'relativity-rasterize',
    set: { colors: 'linear-spectrum', beaming: 0 },
    from: { view },
  },
  paperLight: { type: 'deferred-lighting', from: { gbuffer: 'paper.gbuffer' } },
  paperTone: { type: 'tone-map', from: { image: 'paperLight.image' } },
  seen: { type: 'relativity-rasterize', from: { view } },
  seenLight: { type: 'deferred-lighting', from: { gbuffer: 'seen.gbuffer' } },
  seenTone: { type: 'tone-map', set: { exposure: seen }, from: { image: 'seenLight.image' } },
  both: {
    type: 'mix-color',
    set: { mode: 'split', alpha: 0.5 },
    from: { below: 'paperTone.image', above: 'seenTone.image' },
  },
  output: { type: 'output', from: { image: 'both.image' } },
});

/** From a file to what an observer sees who moves ahead; `lights`: in place of the file's. */
const looksAt = (
  source: string,
  fieldOfView: number,
  lights: { readonly lights?: readonly string[] } = {},
): Readonly<Record<string, NodeSketch>> => ({
  read: { type: 'read', set: { source } },
  start: { type: 'observer', set: { beta: [0, 0, -BETA] } },
  scene: { type: 'scene', from: { geometry: ['read.geometry'], observer: 'start.observer', ...lights } },
  console: { type: 'relativity-console', from: { scene: 'scene.scene' } },
  camera: { type: 'scene-camera', set: { fieldOfView }, from: { relativity: 'console.relativity' } },
});

/** Both halves of a panorama whose colours are those of surfaces in daylight. */
const looksAround = (source: string, fieldOfView: number): Readonly<Record<string, NodeSketch>> => ({
  panorama: { type: 'panorama', set: { source, reading: 'filter' } },
  ...looksAt(source, fieldOfView, { lights: ['panorama.lights'] }),
  ...sideBySide('camera.view', -0.7),
});

/** The paper's first test scene, as it had it: six pictures of a cube's inside. */
export const textureCube = () =>
  build(
    {
      title: 'Textures at speed: a cube',
      lookFor:
        'The inside of a checkered cube at 0.6 c, as a picture of six faces. At the left as the paper on texture mapping (Mantiuk et al. 2004) had it: directions are right, colours are shifted by its simple spectrum, and brightness is not. At the right what is seen: it is much brighter ahead than aside. Change your speed with W and S: the squares ahead shrink, and what lies behind you comes into view.',
    },
    looksAround('panoramas/checkered-cube.png', 100),
  );

/** The paper's second: a hall, which is drawn once into six faces at rest, and seen in them at any velocity. */
export const textureHall = () =>
  build(
    {
      title: 'Textures at speed: a hall',
      lookFor:
        'The hall at 0.6 c, out of six faces that are drawn once, at rest: the pipeline of the paper on texture mapping (Mantiuk et al. 2004), with the light of every surface computed anew instead of colours. At the left the paper’s colours and brightness, at the right what is seen. Change your speed with W and S, and look around: no geometry is drawn while you stay in place. Remove the node Capture and compare.',
    },
    {
      ...looksAt('hall.usdc', 75),
      capture: { type: 'capture', from: { view: 'camera.view' } },
      ...sideBySide('capture.view', -1.3),
    },
  );

/** A photograph in place of the paper's textures: light of all directions, with its sun, as the reference renderer finds it in the hall (scripts/pictures.mjs). */
export const textureInterior = () =>
  build(
    {
      title: 'Textures at speed: an interior',
      lookFor:
        'Like the cube, with a panorama of high dynamic range as a camera would take it: the hall, traced by the reference renderer at rest. All that is known of a texel is its colour, which at the right is taken for that of a surface in daylight. Compare with the hall that is captured, where lights and materials are known. Change your speed with W and S, and look behind you.',
    },
    looksAround('panoramas/interior.exr', 75),
  );
