import { build, type Sketch } from './build.ts';

const ABOUT = {
  title: "God's eye",
  lookFor:
    'From above, at one instant: everything is where it is now, as nobody sees it. The red train passes at 0.8 c and is 0.6 times as long as the yellow one, which is built alike and rests. The blue figure is an observer; the rings around it are one light-second apart: what crosses the third ring now it will see in 3 s. Set View to Seen, and the camera to /Observer, to see what it sees: the train where it was, and stretched while it comes.',
};

/** [m/s] */
const C = 10;
const LENGTH = 3;
const GAP = 0.6;
/** At 0.8 c: √(1 − 0.8²). */
const CONTRACTED = 0.6;

/** Wagons in a row along x at a distance from the observer. Each contracts by itself when it moves; `part`: how far from one another they are then, of that at rest. */
const train = (
  name: string,
  color: readonly [number, number, number],
  z: number,
  part: number,
): Readonly<Record<string, Sketch>> => ({
  [`${name}Wagon`]: { type: 'box', set: { name, width: LENGTH, height: 1.6, depth: 1.6 } },
  [`${name}Row`]: {
    type: 'instances',
    set: { countX: 5, countZ: 1, spacing: [part * (LENGTH + GAP), 0, 0] },
    from: { geometry: `${name}Wagon.geometry` },
  },
  [`${name}Paint`]: { type: 'material', set: { color, roughness: 0.5 }, from: { geometry: `${name}Row.geometry` } },
  [name]: { type: 'transform', set: { position: [0, 0.8, z] }, from: { geometry: `${name}Paint.geometry` } },
});

const rings: Readonly<Record<string, Sketch>> = Object.fromEntries(
  [1, 2, 3].map((seconds): [string, Sketch] => [
    `ring${seconds}`,
    { type: 'torus', set: { name: `LightSecond${seconds}`, ring: seconds * C, tube: 0.1, rings: 8 } },
  ]),
);

/** A train that passes an observer, as it is at one instant: seen from above by an eye that light does not keep waiting. */
export const godsEye = () =>
  build(ABOUT, {
    ground: { type: 'grid', set: { name: 'Ground', width: 160, length: 120, columns: 40, rows: 30 } },
    stone: {
      type: 'material',
      set: { color: [0.3, 0.31, 0.33], roughness: 0.9 },
      from: { geometry: 'ground.geometry' },
    },
    ...rings,
    shells: { type: 'merge', from: { geometry: Object.keys(rings).map((id) => `${id}.geometry`) } },
    lightBlue: { type: 'material', set: { color: [0.5, 0.75, 1], glow: 0.6 }, from: { geometry: 'shells.geometry' } },
    body: { type: 'cylinder', set: { name: 'Figure', radius: 0.9, height: 2.4, pointed: true } },
    standing: { type: 'transform', set: { position: [0, 1.2, 0] }, from: { geometry: 'body.geometry' } },
    blue: { type: 'material', set: { color: [0.05, 0.2, 0.8] }, from: { geometry: 'standing.geometry' } },
    ...train('Passing', [0.75, 0.07, 0.05], -9, CONTRACTED),
    flight: { type: 'motion-uniform', set: { velocity: [0.8 * C, 0, 0], at: 3 } },
    express: {
      type: 'move',
      set: { authoredIn: 'rest' },
      from: { geometry: 'Passing.geometry', motion: 'flight.motion' },
    },
    ...train('Resting', [0.8, 0.6, 0.05], -13, 1),
    above: { type: 'camera', set: { name: 'Above', position: [0, 42, 29], target: [0, 0, -1], fieldOfView: 46 } },
    own: { type: 'camera', set: { name: 'Observer', position: [0, 1.7, -1.4], target: [0, 1.2, -9], fieldOfView: 90 } },
    sun: { type: 'sun', set: { brightness: 2, direction: [-0.4, -0.8, -0.4] } },
    sky: { type: 'sky' },
    time: { type: 'time', set: { from: 0, to: 6, openAt: 3 } },
    scene: {
      type: 'scene',
      from: {
        geometry: ['above', 'own', 'stone', 'lightBlue', 'blue', 'express', 'Resting'].map((id) => `${id}.geometry`),
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
    toneMap: { type: 'tone-map', from: { image: 'lighting.image' } },
    output: { type: 'output', from: { image: 'toneMap.image' } },
  });
