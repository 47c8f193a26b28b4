import { build, type NodeSketch } from './buildProject.ts';

const ABOUT = {
  title: "God's eye",
  lookFor:
    'From above, at one instant: everything is where it is now, as nobody sees it. The red train passes at 0.8 c and is 0.6 times as long as the yellow one, which is built alike and rests. The white figure is an observer; the rings around it are one light-second apart: what crosses the third ring now it will see in 3 s. Set View to Seen, and the camera to /Observer, to see what it sees: the train where it was, and stretched while it comes.',
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

/** A circle of a number of light-seconds around the observer: a disc darker than the inner one, a ring at its edge, and its number on the ground. */
const SECONDS = [1, 2, 3] as const;
const ZONES = [
  [0.07, 0.19, 0.33],
  [0.035, 0.11, 0.21],
  [0.018, 0.06, 0.125],
] as const;
const around = (seconds: (typeof SECONDS)[number]): Readonly<Record<string, NodeSketch>> => ({
  [`disc${seconds}`]: {
    type: 'cylinder',
    set: { name: `Zone${seconds}`, radius: seconds * C, height: 0.2 * (4 - seconds), segments: 192 },
  },
  [`zone${seconds}`]: {
    type: 'material',
    set: { color: ZONES[seconds - 1]!, roughness: 0.9 },
    from: { geometry: `disc${seconds}.geometry` },
  },
  [`ring${seconds}`]: {
    type: 'torus',
    set: { name: `LightSecond${seconds}`, ring: seconds * C, tube: 0.3, segments: 192, rings: 8 },
  },
  [`number${seconds}`]: {
    type: 'solid-text',
    set: { name: `Number${seconds}`, text: `${seconds} s`, size: 2, depth: 0.1 },
  },
  [`written${seconds}`]: {
    type: 'transform',
    set: { position: [-0.92 * (seconds * C - 2.6), 0.4, 0.4 * (seconds * C - 2.6)], rotation: [-90, 0, 0] },
    from: { geometry: `number${seconds}.geometry` },
  },
});
const rings: Readonly<Record<string, NodeSketch>> = Object.assign({}, ...SECONDS.map(around));

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
    ...rings,
    zones: { type: 'merge', from: { geometry: SECONDS.map((n) => `zone${n}.geometry`) } },
    shells: {
      type: 'merge',
      from: { geometry: SECONDS.flatMap((n) => [`ring${n}.geometry`, `written${n}.geometry`]) },
    },
    lightBlue: { type: 'material', set: { color: [0.55, 0.8, 1], glow: 1 }, from: { geometry: 'shells.geometry' } },
    ...tracks,
    body: { type: 'cylinder', set: { name: 'Figure', radius: 1.1, height: 3, pointed: true } },
    standing: { type: 'transform', set: { position: [0, 1.8, 0] }, from: { geometry: 'body.geometry' } },
    head: { type: 'sphere', set: { name: 'Head', radius: 0.7 } },
    upright: { type: 'transform', set: { position: [0, 3.3, 0] }, from: { geometry: 'head.geometry' } },
    figure: { type: 'merge', from: { geometry: ['standing.geometry', 'upright.geometry'] } },
    white: { type: 'material', set: { color: [0.9, 0.9, 0.85] }, from: { geometry: 'figure.geometry' } },
    ...train('Passing', [0.75, 0.07, 0.05], -NEAR, CONTRACTED),
    flight: { type: 'motion-uniform', set: { velocity: [0.8 * C, 0, 0], at: 3 } },
    express: {
      type: 'move',
      set: { authoredIn: 'rest' },
      from: { geometry: 'Passing.geometry', motion: 'flight.motion' },
    },
    ...train('Resting', [0.8, 0.6, 0.05], -FAR, 1),
    above: { type: 'camera', set: { name: 'Above', position: [5, 28, 31], target: [-0.5, 0, 0.5], fieldOfView: 47 } },
    own: { type: 'camera', set: { name: 'Observer', position: [0, 1.7, -1.4], target: [0, 1.2, -9], fieldOfView: 90 } },
    sun: { type: 'sun', set: { brightness: 2, direction: [-0.4, -0.8, -0.4] } },
    sky: { type: 'sky' },
    time: { type: 'time', set: { from: 0, to: 6, openAt: 3 } },
    scene: {
      type: 'scene',
      from: {
        geometry: ['above', 'own', 'stone', 'zones', 'tracks', 'lightBlue', 'white', 'express', 'Resting'].map(
          (id) => `${id}.geometry`,
        ),
        lights: ['sun.lights', 'sky.lights'],
        time: 'time.time',
      },
    },
    console: {
      type: 'relativity-console',
      set: { speedOfLight: C, view: 'simultaneity' },
      from: { scene: 'scene.scene' },
    },
    camera: { type: 'scene-camera', from: { relativity: 'console.relativity' } },
    rasterize: { type: 'relativity-rasterize', from: { view: 'camera.view' } },
    lighting: { type: 'deferred-lighting', from: { gbuffer: 'rasterize.gbuffer' } },
    outlined: { type: 'post-process', set: { effect: 'edge', arg2: 4, arg3: 1.5 }, from: { image: 'lighting.image' } },
    toneMap: { type: 'tone-map', set: { exposure: 0.7 }, from: { image: 'outlined.image' } },
    smooth: { type: 'antialiasing', from: { image: 'toneMap.image' } },
    output: { type: 'output', from: { image: 'smooth.image' } },
  });
