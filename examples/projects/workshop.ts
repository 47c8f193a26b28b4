import { build } from './buildProject.ts';

const ABOUT = {
  title: 'Workshop',
  lookFor:
    'Made of nodes alone, in a world where light goes at 12 m/s. A frame passes at 7 m/s, a ball goes round at 8 m/s, a ring spins, a dart is thrust from rest, a crate follows a winding path, a tile tumbles from place to place. Each is seen where it was when its light left, and bluer as it comes, redder as it goes.',
};

/** Every kind of motion in one yard, made of nodes alone, without a file. c = 12 m/s. */
export const workshop = () =>
  build(ABOUT, {
    ground: { type: 'grid', set: { name: 'Ground', width: 60, length: 60, columns: 30, rows: 30 } },
    sand: {
      type: 'material',
      set: { color: [0.42, 0.3, 0.19], roughness: 0.9 },
      from: { geometry: 'ground.geometry' },
    },

    post: { type: 'cylinder', set: { name: 'Post', radius: 0.15, height: 3 } },
    standing: { type: 'transform', set: { position: [0, 1.5, 0] }, from: { geometry: 'post.geometry' } },
    clay: { type: 'material', set: { color: [0.6, 0.2, 0.09] }, from: { geometry: 'standing.geometry' } },
    posts: {
      type: 'instances',
      set: { arrangement: 'ring', count: 18, radius: 14 },
      from: { geometry: 'clay.geometry' },
    },

    frame: { type: 'lattice', set: { name: 'Frame', x: 3, y: 3, z: 3, cell: 0.9, thickness: 0.08 } },
    red: { type: 'material', set: { color: [0.7, 0.08, 0.05], roughness: 0.4 }, from: { geometry: 'frame.geometry' } },
    raised: { type: 'transform', set: { position: [0, 1.7, -3] }, from: { geometry: 'red.geometry' } },
    passing: { type: 'motion-uniform', set: { velocity: [7, 0, 0], at: 2 } },
    train: { type: 'move', from: { geometry: 'raised.geometry', motion: 'passing.motion' } },

    ball: { type: 'sphere', set: { name: 'Ball', radius: 0.7 } },
    gold: { type: 'material', set: { preset: 'gold' }, from: { geometry: 'ball.geometry' } },
    orbit: { type: 'motion-circular', set: { center: [0, 1, 0], radius: 5, speed: 8, to: 20 } },
    planet: { type: 'move', from: { geometry: 'gold.geometry', motion: 'orbit.motion' } },

    ring: { type: 'torus', set: { name: 'Ring', ring: 1.6, tube: 0.3 } },
    copper: { type: 'material', set: { preset: 'copper' }, from: { geometry: 'ring.geometry' } },
    upright: {
      type: 'transform',
      set: { position: [-4, 2, 2], rotation: [90, 0, 0] },
      from: { geometry: 'copper.geometry' },
    },
    turning: { type: 'motion-spin', set: { center: [-4, 2, 2], axis: [1, 0, 0], rate: 4, to: 20 } },
    wheel: { type: 'move', from: { geometry: 'upright.geometry', motion: 'turning.motion' } },

    dart: { type: 'cylinder', set: { name: 'Dart', radius: 0.35, height: 2, pointed: true, axis: 'X' } },
    blue: {
      type: 'material',
      set: { color: [0.05, 0.15, 0.6], metallic: 0.2, roughness: 0.3 },
      from: { geometry: 'dart.geometry' },
    },
    aloft: { type: 'transform', set: { position: [4, 3.4, 0] }, from: { geometry: 'blue.geometry' } },
    thrust: { type: 'motion-hyperbolic', set: { acceleration: [6, 0, 0], restAt: 2 } },
    rocket: {
      type: 'move',
      set: { authoredIn: 'rest' },
      from: { geometry: 'aloft.geometry', motion: 'thrust.motion' },
    },

    crate: { type: 'box', set: { name: 'Crate', width: 0.9, height: 0.9, depth: 0.9 } },
    smooth: { type: 'subdivide', set: { levels: 3, surface: 'smooth' }, from: { geometry: 'crate.geometry' } },
    yellow: {
      type: 'material',
      set: { color: [0.8, 0.55, 0.05], roughness: 0.4 },
      from: { geometry: 'smooth.geometry' },
    },
    track: {
      type: 'motion-path',
      set: { places: ['-8 0.5 4', '-2 0.5 6', '4 0.5 4', '8 0.5 6'], from: 0, to: 4 },
    },
    runner: { type: 'move', from: { geometry: 'yellow.geometry', motion: 'track.motion' } },

    tile: { type: 'box', set: { name: 'Tile', width: 1.2, height: 0.12, depth: 1.2 } },
    snow: { type: 'material', set: { preset: 'snow' }, from: { geometry: 'tile.geometry' } },
    cues: {
      type: 'motion-keyframes',
      set: { keys: ['0 6 2 -2 0 0 0', '1.5 6 4 -2 0 0 90', '3 3 4 -2 180 0 90', '4.5 6 2 -2 0 0 0'] },
    },
    tumbler: { type: 'move', from: { geometry: 'snow.geometry', motion: 'cues.motion' } },
    visit: { type: 'lifetime', set: { birth: 0, death: 4 }, from: { geometry: 'tumbler.geometry' } },

    things: {
      type: 'merge',
      from: {
        geometry: ['planet', 'wheel', 'rocket', 'runner'].map((id) => `${id}.geometry`),
      },
    },
    later: { type: 'retime', set: { offset: 0 }, from: { geometry: 'things.geometry' } },
    eye: { type: 'camera', set: { name: 'Eye', position: [1.2, 2.8, 8.8], target: [0.1, 1.5, 0], fieldOfView: 48 } },

    sun: { type: 'sun', set: { brightness: 2.2, color: [1, 0.92, 0.8], direction: [-0.6, -0.7, -0.5] } },
    sky: { type: 'sky', set: { color: [0.25, 0.42, 0.8], brightness: 0.7 } },
    glow: { type: 'spectrum', set: { kind: 'lamp', lamp: 'sodium' } },
    lamp: {
      type: 'lamp',
      set: { position: [-7, 3, 0], brightness: 40, color: [1, 0.6, 0.1] },
      from: { spectrum: 'glow.spectrum' },
    },

    clock: { type: 'time', set: { from: 0, to: 5, openAt: 2.85 } },
    start: { type: 'observer', set: { beta: [0, 0, -0.1] } },
    scene: {
      type: 'scene',
      from: {
        geometry: ['sand', 'posts', 'train', 'visit', 'later', 'eye'].map((id) => `${id}.geometry`),
        lights: ['sun.lights', 'sky.lights', 'lamp.lights'],
        observer: 'start.observer',
        time: 'clock.time',
      },
    },
    console: { type: 'relativity-console', set: { speedOfLight: 12 }, from: { scene: 'scene.scene' } },
    camera: { type: 'scene-camera', from: { relativity: 'console.relativity' } },
    rasterize: { type: 'relativity-rasterize', from: { view: 'camera.view' } },
    lighting: { type: 'deferred-lighting', from: { gbuffer: 'rasterize.gbuffer' } },
    toneMap: { type: 'tone-map', from: { image: 'lighting.image' } },
    still: { type: 'save-image', set: { name: 'workshop.png' }, from: { image: 'toneMap.image' } },
    film: { type: 'save-video', set: { name: 'workshop.mp4', stayInPlace: true }, from: { image: 'toneMap.image' } },
    output: { type: 'output', from: { image: 'toneMap.image' } },
  });
