import { clamp, dot, float, floor, If, int, ivec2, Loop, max, normalize, sqrt, texture, vec3 } from 'three/tsl';
import type { Texture } from 'three/webgpu';
import type { Float, Int, Vec3, Vec4 } from '../../shaders/types.ts';
import { LAYER_TEXELS } from './layer.ts';
import type { LayerTable } from './layerTable.ts';

/** An event on a surface that may be in shadow. */
export interface Receiver {
  /** Observer → event [m], and c(t − t_o) [m of light]. */
  readonly dx: Vec3;
  readonly time: Float;
  /** Unit, in the rest frame. */
  readonly normal: Vec3;
  /** (v, 1 − v²); undefined where all things rest. */
  readonly velocity: Vec4 | undefined;
}

/** Says which share of a sun's light comes to an event. */
export interface Shadowing {
  /** undefined of a sun without shadows; `sun`: its place in the environment. */
  share(sun: number | undefined, receiver: Receiver): Float | undefined;
}

/** How far an event is lifted off its surface [texels]: always, and where light comes along the surface; the filter reaches over 1 texel. */
const LIFT = [0.4, 1.5] as const;

/** Normal of the surface as it is at one moment of the world: n∥ → γ n∥ of that of the rest frame. */
export function sliceNormal({ normal, velocity }: Pick<Receiver, 'normal' | 'velocity'>): Vec3 {
  if (!velocity) return normal;
  const gamma = float(1)
    .div(sqrt(clamp(velocity.w, 1e-12, 1)))
    .toVar();
  const along = gamma.mul(gamma).div(gamma.add(1)).mul(dot(velocity.xyz, normal));
  return normalize(normal.add(velocity.xyz.mul(along)));
}

type Rows = readonly [Vec4, Vec4, Vec4, Vec4, Vec4];

export const readRows = (layers: LayerTable, layer: Int): Rows => {
  const first = layer.mul(int(LAYER_TEXELS)).toVar();
  const [across, up, height, time, tile] = [0, 1, 2, 3, 4].map((k) => layers.texel(first.add(int(k))).toVar());
  return [across, up, height, time, tile];
};

/** Texel and height of an event on a layer (`layerTexels`). */
export const onLayer = ([across, up, height, time]: Rows, dx: Vec3, at: Float): Vec3 =>
  vec3(dot(across.xyz, dx).add(across.w), dot(up.xyz, dx).add(up.w), dot(height.xyz, dx).add(height.w)).add(
    time.xyz.mul(at),
  );

/** Whether the filter finds all its texels on the layer's tile. */
function isInside([, , , , tile]: Rows, place: Vec3) {
  const local = place.xy.sub(tile.xy).toVar();
  const end = tile.z.sub(2);
  return local.x.greaterThan(2).and(local.y.greaterThan(2)).and(local.x.lessThan(end)).and(local.y.lessThan(end));
}

/** The share of light that passes the occluders of a layer: a box of a texel's size round the place, so that edges are smooth. */
function passing(map: Texture, place: Vec3): Float {
  const corner = floor(place.xy.sub(0.5)).toVar();
  const part = place.xy.sub(0.5).sub(corner).toVar();
  const first = ivec2(corner).toVar();
  const weights = (x: Float): readonly Float[] => [x.oneMinus(), x];
  const [columns, rows] = [weights(part.x), weights(part.y)];
  // A texel without an occluder is 0.
  const height = max(place.z, 0).toVar();
  const held = float(0).toVar();
  rows.forEach((down, j) => {
    columns.forEach((along, i) => {
      const texel = texture(map).load(first.add(ivec2(i, j)));
      // Else three multiplies the whole numbers by the texture's matrix at every fetch.
      texel.updateMatrix = false;
      const found = texel.x;
      held.addAssign(found.greaterThan(height).select(down.mul(along), float(0)));
    });
  });
  return held.oneMinus();
}

/** The event off its surface, as far as texels of the layer are wide. */
function lifted([, , height, time, tile]: Rows, { dx, normal }: { dx: Vec3; normal: Vec3 }): Vec3 {
  const cosine = clamp(dot(height.xyz, normal).div(tile.w), 0, 1).toVar();
  const sine = sqrt(cosine.mul(cosine).oneMinus());
  return dx.add(normal.mul(time.w.mul(sine.mul(LIFT[1]).add(LIFT[0]))));
}

/** The share that passes all that rests: from the finest of `count` layers which holds the event. */
export function passingResting(
  map: Texture,
  layers: LayerTable,
  first: number,
  count: number,
  receiver: { dx: Vec3; time: Float; normal: Vec3 },
): Float {
  const { dx, time } = receiver;
  const chosen = int(-1).toVar();
  for (let k = count - 1; k >= 0; k--) {
    const rows = readRows(layers, int(first + k));
    If(isInside(rows, onLayer(rows, dx, time)), () => {
      chosen.assign(int(first + k));
    });
  }
  const share = float(1).toVar();
  If(chosen.greaterThanEqual(0), () => {
    const rows = readRows(layers, chosen);
    const place = onLayer(rows, lifted(rows, receiver), time).toVar();
    share.assign(passing(map, place));
  });
  return share;
}

/** The share that passes what moves: `count` layers, each of one body. */
export function passingMoving(
  map: Texture,
  layers: LayerTable,
  first: Int,
  count: Int,
  receiver: { dx: Vec3; time: Float; normal: Vec3 },
): Float {
  const { time } = receiver;
  const share = float(1).toVar();
  Loop({ start: int(0), end: count, type: 'int', condition: '<' }, ({ i }) => {
    const rows = readRows(layers, first.add(int(i)));
    const place = onLayer(rows, lifted(rows, receiver), time).toVar();
    If(isInside(rows, place).and(place.z.lessThan(1)), () => {
      share.mulAssign(passing(map, place));
    });
  });
  return share;
}
