import { build, type NodeSketch } from './buildProject.ts';

const ABOUT = {
  title: "God's eye",
  lookFor:
    'The world at one instant from above, and in the corner what the observer, the blue disc, sees at that instant. The red train passes him at 0.8 c and is 0.6 times as long as the yellow one, which is built alike and rests. What crosses the third ring now he will see in 3 s. Compare where the red train is with where he sees it. Fly: the disc is you, and its arrow is how far you come in a second; at c it would reach the first ring.',
};

/** [m/s] */
const C = 10;
const LENGTH = 4.5;
const GAP = 0.7;
/** Distance of the tracks behind the observer's position [m]. */
const NEAR = 8;
const FAR = 12;
/** Length contraction at 0.8 c: √(1 − 0.8²). */
const CONTRACTED = 0.6;

/** A row of wagons along x at a distance from the observer. Moving wagons contract individually; `part`: their spacing relative to that at rest. */
const train = (
  name: string,
  color: readonly [number, number, number],
  z: number,
  part: number,
): Readonly<Record<string, NodeSketch>> => ({
  [`${name}Wagon`]: { type: 'box', set: { name, width: LENGTH, height: 2.4, depth: 2.4 } },
  [`${name}Row`]: {
    type: 'instances',
    set: { countX: 5, countZ: 1, spacing: [part * (LENGTH + GAP), 0, 0] },
    from: { geometry: `${name}Wagon.geometry` },
  },
  [`${name}Paint`]: { type: 'material', set: { color, roughness: 0.5 }, from: { geometry: `${name}Row.geometry` } },
  [name]: { type: 'transform', set: { position: [0, 1.8, z] }, from: { geometry: `${name}Paint.geometry` } },
});

/** Two tracks along x, with two rails on sleepers each. */
const tracks: Readonly<Record<string, NodeSketch>> = {
  rail: { type: 'box', set: { name: 'Rail', width: 120, height: 0.3, depth: 0.16 } },
  rails: {
    type: 'instances',
    set: { countX: 1, countZ: 4, spacing: [1, 1, (FAR - NEAR) / 2] },
    from: { geometry: 'rail.geometry' },
  },
  steel: { type: 'material', set: { color: [0.6, 0.6, 0.62], roughness: 0.4 }, from: { geometry: 'rails.geometry' } },
  sleeper: { type: 'box', set: { name: 'Sleeper', width: 0.4, height: 0.2, depth: 3 } },
  sleepers: {
    type: 'instances',
    set: { countX: 80, countZ: 2, spacing: [1.5, 1, FAR - NEAR] },
    from: { geometry: 'sleeper.geometry' },
  },
  wood: {
    type: 'material',
    set: { color: [0.1, 0.07, 0.05], roughness: 0.9 },
    from: { geometry: 'sleepers.geometry' },
  },
  track: { type: 'merge', from: { geometry: ['steel.geometry', 'wood.geometry'] } },
  tracks: { type: 'transform', set: { position: [0, 0.4, -(NEAR + FAR) / 2] }, from: { geometry: 'track.geometry' } },
};

export const godsEye = () =>
  build(ABOUT, {
    ground: { type: 'grid', set: { name: 'Ground', width: 400, length: 300, columns: 40, rows: 30 } },
    stone: {
      type: 'material',
      set: { color: [0.012, 0.03, 0.06], roughness: 0.9 },
      from: { geometry: 'ground.geometry' },
    },
    ...tracks,
    ...train('Passing', [0.75, 0.07, 0.05], -NEAR, CONTRACTED),
    flight: { type: 'motion-uniform', set: { velocity: [0.8 * C, 0, 0], at: 3 } },
    express: {
      type: 'move',
      set: { authoredIn: 'rest' },
      from: { geometry: 'Passing.geometry', motion: 'flight.motion' },
    },
    ...train('Resting', [0.8, 0.6, 0.05], -FAR, 1),
    own: { type: 'camera', set: { name: 'Observer', position: [0, 1.7, -1.4], target: [0, 1.2, -9], fieldOfView: 90 } },
    sun: { type: 'sun', set: { brightness: 2, direction: [-0.4, -0.8, -0.4] } },
    sky: { type: 'sky' },
    time: { type: 'time', set: { from: 0, to: 6, openAt: 3 } },
    scene: {
      type: 'scene',
      from: {
        geometry: ['own', 'stone', 'tracks', 'express', 'Resting'].map((id) => `${id}.geometry`),
        lights: ['sun.lights', 'sky.lights'],
        time: 'time.time',
      },
    },
    console: { type: 'relativity-console', set: { speedOfLight: C }, from: { scene: 'scene.scene' } },
    camera: { type: 'scene-camera', from: { relativity: 'console.relativity' } },
    // What is.
    outside: {
      type: 'outside-view',
      set: { shows: 'now', distance: 42, azimuth: 9, elevation: 39, fieldOfView: 47 },
      from: { view: 'camera.view' },
    },
    map: { type: 'relativity-rasterize', from: { view: 'outside.view' } },
    mapLight: { type: 'deferred-lighting', from: { gbuffer: 'map.gbuffer' } },
    outlined: { type: 'post-process', set: { effect: 'edge', arg2: 4, arg3: 1.5 }, from: { image: 'mapLight.image' } },
    mapTone: { type: 'tone-map', set: { metering: 'manual', exposure: 0.2 }, from: { image: 'outlined.image' } },
    marked: {
      type: 'post-process',
      set: { effect: 'observer-marks', arg1: 1, arg2: 0.8, arg3: 8 },
      from: { image: 'mapTone.image', gbuffer: 'map.gbuffer' },
    },
    // What he sees.
    rasterize: { type: 'relativity-rasterize', from: { view: 'camera.view' } },
    lighting: { type: 'deferred-lighting', from: { gbuffer: 'rasterize.gbuffer' } },
    toneMap: { type: 'tone-map', from: { image: 'lighting.image' } },
    inset: {
      type: 'mix-color',
      set: { mode: 'inset', alpha: 0.36 },
      from: { below: 'marked.image', above: 'toneMap.image' },
    },
    smooth: { type: 'antialiasing', from: { image: 'inset.image' } },
    output: { type: 'output', from: { image: 'smooth.image' } },
  });
