import type { Sketch } from './build.ts';

export type Sketches = Readonly<Record<string, Sketch>>;
type Vec3 = readonly [number, number, number];

/** Paints what a node gives. */
export const painted = (of: string, color: Vec3, more: NonNullable<Sketch['set']> = {}): Sketch => ({
  type: 'material',
  set: { color, ...more },
  from: { geometry: of },
});

/** Where simulations are looked at, and when. */
interface Looks {
  readonly eye: Vec3;
  readonly target: Vec3;
  readonly fieldOfView?: number;
  /** World times [s]. */
  readonly to: number;
  readonly openAt: number;
  /** The ground, where it is not the usual one. */
  readonly ground?: Sketches;
}

const STONE: Vec3 = [0.42, 0.4, 0.37];
const ROUGH = { roughness: 0.95 };
const GROUND: Sketches = {
  floor: { type: 'grid', set: { name: 'Ground', width: 60, length: 60, columns: 60, rows: 60 } },
  ground: painted('floor.geometry', STONE, ROUGH),
};

/** A ground that things fall on; its matter is `ground.matter`. */
export const solidGround = (set: NonNullable<Sketch['set']>): Sketches => ({
  floor: { type: 'grid', set: { name: 'Floor', width: 60, length: 60, columns: 60, rows: 60 } },
  stone: painted('floor.geometry', STONE, ROUGH),
  ground: { type: 'collider', set: { shape: 'plane', ...set }, from: { geometry: 'stone.geometry' } },
});

/** What all simulations stand on and are lit by, the eye, and what leads to the picture. `things`: outputs that are in the scene. */
export const seen = (
  things: readonly string[],
  { eye, target, fieldOfView = 40, to, openAt, ground = GROUND }: Looks,
): Sketches => ({
  ...ground,
  eye: { type: 'camera', set: { name: 'Eye', position: eye, target, fieldOfView } },
  sun: { type: 'sun', set: { brightness: 2.6, direction: [-0.45, -0.8, -0.42], color: [1, 0.95, 0.86] } },
  sky: { type: 'sky', set: { color: [0.5, 0.65, 0.9], brightness: 0.55 } },
  time: { type: 'time', set: { from: 0, to, openAt } },
  scene: {
    type: 'scene',
    from: {
      geometry: ['eye.geometry', ...things, ...(ground === GROUND ? ['ground.geometry'] : [])],
      lights: ['sun.lights', 'sky.lights'],
      time: 'time.time',
    },
  },
  console: { type: 'relativity-console', from: { scene: 'scene.scene' } },
  camera: { type: 'scene-camera', from: { relativity: 'console.relativity' } },
  rasterize: { type: 'relativity-rasterize', from: { view: 'camera.view' } },
  lighting: { type: 'deferred-lighting', from: { gbuffer: 'rasterize.gbuffer' } },
  toneMap: { type: 'tone-map', from: { image: 'lighting.image' } },
  output: { type: 'output', from: { image: 'toneMap.image' } },
});
