import { build } from './buildProject.ts';

const ABOUT = {
  title: 'Letters',
  lookFor:
    'Words of solid letters, where light goes at 10 m/s. The white ones rest; the yellow ones fly by at 0.8 c, and show you their ends and colours that they do not have.',
};

/** A word at rest, and one that passes above it at 0.8 c and appears rotated and shifted. c = 10 m/s. */
export const letters = () =>
  build(ABOUT, {
    ground: { type: 'grid', set: { name: 'Ground', width: 80, length: 60, columns: 40, rows: 30 } },
    stone: {
      type: 'material',
      set: { color: [0.05, 0.13, 0.15], roughness: 0.8 },
      from: { geometry: 'ground.geometry' },
    },

    title: { type: 'solid-text', set: { name: 'Title', text: 'SLOWLIGHT', size: 1, depth: 0.4 } },
    ivory: { type: 'material', set: { color: [0.85, 0.8, 0.7] }, from: { geometry: 'title.geometry' } },

    word: { type: 'solid-text', set: { name: 'Passing', text: '慢光 0.8 c', size: 1.3, depth: 0.5 } },
    yellow: { type: 'material', set: { color: [0.9, 0.62, 0.2], roughness: 0.4 }, from: { geometry: 'word.geometry' } },
    behind: { type: 'transform', set: { position: [0, 1.5, -1.5] }, from: { geometry: 'yellow.geometry' } },
    passing: { type: 'motion-uniform', set: { velocity: [8, 0, 0], at: 2 } },
    flyer: {
      type: 'move',
      set: { authoredIn: 'rest' },
      from: { geometry: 'behind.geometry', motion: 'passing.motion' },
    },

    things: { type: 'merge', from: { geometry: ['ivory', 'flyer', 'stone'].map((id) => `${id}.geometry`) } },
    written: {
      type: 'write-usd',
      set: { name: 'letters.usda', speedOfLight: 10 },
      from: { geometry: 'things.geometry', time: 'clock.time' },
    },
    eye: { type: 'camera', set: { name: 'Eye', position: [3.2, 1.9, 5.6], target: [0.1, 1.3, -0.6], fieldOfView: 48 } },
    sun: { type: 'sun', set: { brightness: 2.4, direction: [-0.5, -0.8, -0.6] } },
    sky: { type: 'sky', set: { color: [0.2, 0.4, 0.75], brightness: 0.8 } },
    clock: { type: 'time', set: { from: 0, to: 5, openAt: 2.6 } },
    scene: {
      type: 'scene',
      from: {
        geometry: ['written.geometry', 'eye.geometry'],
        lights: ['sun.lights', 'sky.lights'],
        time: 'clock.time',
      },
    },
    console: { type: 'relativity-console', set: { speedOfLight: 10 }, from: { scene: 'scene.scene' } },
    camera: { type: 'scene-camera', from: { relativity: 'console.relativity' } },
    rasterize: { type: 'relativity-rasterize', from: { view: 'camera.view' } },
    lighting: { type: 'deferred-lighting', from: { gbuffer: 'rasterize.gbuffer' } },
    toneMap: { type: 'tone-map', from: { image: 'lighting.image' } },
    output: { type: 'output', from: { image: 'toneMap.image' } },
  });
