import type { NodeSketch } from './buildProject.ts';

export type NodeSketches = Readonly<Record<string, NodeSketch>>;
type Vec3 = readonly [number, number, number];

/** A material for the output of a node. */
export const withMaterial = (of: string, color: Vec3, more: NonNullable<NodeSketch['set']> = {}): NodeSketch => ({
  type: 'material',
  set: { color, ...more },
  from: { geometry: of },
});

/** Surroundings, camera and time range of a simulation. */
interface SimulationView {
  /** The surroundings with their light: a file of examples/sets. */
  readonly set: string;
  /** The prim that objects fall on, and its stiffness; its matter is `ground.matter`. */
  readonly floor?: { readonly which: string; readonly stiffness: number; readonly margin: number };
  /** Lights in addition to those of the set. */
  readonly lights?: readonly string[];
  readonly eye: Vec3;
  readonly target: Vec3;
  readonly fieldOfView?: number;
  /** World times [s]. */
  readonly to: number;
  readonly openAt: number;
}

/** The nodes that all simulations share: surroundings, light, camera and the render chain. `things`: outputs that are part of the scene. */
export const simulationScene = (
  things: readonly string[],
  { set, floor, lights = [], eye, target, fieldOfView = 40, to, openAt }: SimulationView,
): NodeSketches => ({
  place: { type: 'read', set: { source: `sets/${set}` } },
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
