import { build } from './buildProject.ts';

const ABOUT = {
  title: 'Two renderers',
  lookFor:
    'A room at 0.1 c, drawn twice. Left: a still by the exact renderer, which follows light from thing to thing, so that walls colour what is white, and the brass ball has the colours of the room. Right: the renderer that draws while you fly. Edges run on from one to the other. Set the mode of the mix to difference: what is left is that light, and noise, of which more samples leave less. Turn or fly, and the still stays what it is.',
};

/** A wall of the room: `at` is its centre. */
const wall = (name: string, [width, height, depth]: readonly [number, number, number], at: readonly number[]) => ({
  [name]: { type: 'box', set: { name, width, height, depth } },
  [`${name}At`]: { type: 'transform', set: { position: at }, from: { geometry: `${name}.geometry` } },
});
const painted = (of: string, color: readonly number[], more: Readonly<Record<string, number>> = {}) => ({
  type: 'material',
  set: { color, roughness: 0.9, ...more },
  from: { geometry: `${of}.geometry` },
});

/** The reference renderer's picture beside the rasterizer's, of a room with coloured walls. */
export const truth = () =>
  build(ABOUT, {
    ...wall('Floor', [4, 0.1, 4], [0, -0.05, 0]),
    ...wall('Back', [4, 3, 0.1], [0, 1.5, -2.05]),
    ...wall('Left', [0.1, 3, 4], [-2.05, 1.5, 0]),
    ...wall('Right', [0.1, 3, 4], [2.05, 1.5, 0]),
    shell: { type: 'merge', from: { geometry: ['FloorAt.geometry', 'BackAt.geometry'] } },
    white: painted('shell', [0.75, 0.74, 0.7]),
    red: painted('LeftAt', [0.7, 0.06, 0.04]),
    green: painted('RightAt', [0.08, 0.5, 0.1]),

    block: { type: 'box', set: { name: 'Block', width: 0.9, height: 1.7, depth: 0.9 } },
    standing: {
      type: 'transform',
      set: { position: [0, 0.85, -0.9], rotation: [0, 20, 0] },
      from: { geometry: 'block.geometry' },
    },
    chalk: painted('standing', [0.8, 0.8, 0.78]),
    ball: { type: 'sphere', set: { name: 'Ball', radius: 0.6 } },
    lying: { type: 'transform', set: { position: [-0.85, 0.6, 0.2] }, from: { geometry: 'ball.geometry' } },
    brass: {
      type: 'material',
      set: { color: [0.9, 0.6, 0.22], metallic: 1, roughness: 0.6 },
      from: { geometry: 'lying.geometry' },
    },

    eye: { type: 'camera', set: { name: 'Eye', position: [0, 1.4, 4.6], target: [0, 1.3, 0], fieldOfView: 44 } },
    lamp: {
      type: 'lamp',
      set: { name: 'Ceiling', shape: 'rect', position: [0, 2.9, 0], size: 1, brightness: 14, color: [1, 0.93, 0.82] },
    },
    sky: { type: 'sky', set: { color: [0.5, 0.6, 0.8], brightness: 0.1 } },
    start: { type: 'observer', set: { beta: [0, 0, -0.1] } },
    scene: {
      type: 'scene',
      from: {
        geometry: ['white', 'red', 'green', 'chalk', 'brass', 'eye'].map((id) => `${id}.geometry`),
        lights: ['lamp.lights', 'sky.lights'],
        observer: 'start.observer',
      },
    },
    console: { type: 'relativity-console', set: { speedOfLight: 10 }, from: { scene: 'scene.scene' } },
    camera: { type: 'scene-camera', from: { relativity: 'console.relativity' } },
    seen: { type: 'relativity-rasterize', from: { view: 'camera.view' } },
    lighting: { type: 'deferred-lighting', from: { gbuffer: 'seen.gbuffer' } },
    truth: {
      type: 'reference-render',
      set: { width: 320, height: 180, samples: 3 },
      from: { gbuffer: 'seen.gbuffer' },
    },
    both: {
      type: 'mix-color',
      set: { mode: 'split', alpha: 0.5 },
      from: { below: 'truth.image', above: 'lighting.image' },
    },
    toneMap: { type: 'tone-map', from: { image: 'both.image' } },
    output: { type: 'output', from: { image: 'toneMap.image' } },
  });
