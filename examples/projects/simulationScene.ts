import type { NodeSketch } from './buildProject.ts';

export type NodeSketches = Readonly<Record<string, NodeSketch>>;
type Vec3 = readonly [number, number, number];

/** Paints what a node gives. */
export const withMaterial = (of: string, color: Vec3, more: NonNullable<NodeSketch['set']> = {}): NodeSketch => ({
  type: 'material',
  set: { color, ...more },
  from: { geometry: of },
});

/** Where simulations are looked at, and when. */
interface SimulationView {
  /** The place about them, with its light: a file of examples/sets. */
  readonly set: string;
  /** What of it things fall on, and how hard it is; its matter is `ground.matter`. */
  readonly floor?: { readonly which: string; readonly stiffness: number; readonly margin: number };
  /** What shines but is not in the set. */
  readonly lights?: readonly string[];
  readonly eye: Vec3;
  readonly target: Vec3;
  readonly fieldOfView?: number;
  /** World times [s]. */
  readonly to: number;
  readonly openAt: number;
}

/** What all simulations stand in and are lit by, the eye, and what leads to the picture. `things`: outputs that are in the scene. */
export const simulationScene = (
  things: readonly string[],
  { set, floor, lights = [], eye, target, fieldOfView = 40, to, openAt }: SimulationView,
): NodeSketches => ({
  place: { type: 'read', set: { source: `sets/${set}.usda` } },
  ...(floor && {
    ground: { type: 'collider', set: { shape: 'plane', ...floor }, from: { geometry: 'place.geometry' } },
  }),
  eye: { type: 'camera', set: { name: 'Eye', position: eye, target, fieldOfView } },
  time: { type: 'time', set: { from: 0, to, openAt } },
  scene: {
    type: 'scene',
    from: {
      geometry: ['eye.geometry', ...things, floor ? 'ground.rest' : 'place.geometry'],
      lights,
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
