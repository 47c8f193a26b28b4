import {
  abs,
  clamp,
  cos,
  cross,
  dot,
  Fn,
  float,
  floor,
  If,
  ivec2,
  length,
  max,
  min,
  mod,
  normalize,
  screenCoordinate,
  select,
  sin,
  textureLoad,
  vec2,
  vec3,
  vec4,
} from 'three/tsl';
import { fullVelocity } from '../../shaders/kinematics/fullVelocity.ts';
import type { Bool, Float, Vec2, Vec3, Vec4 } from '../../shaders/types.ts';
import type { GBuffer } from '../gbuffer/gbuffer.ts';
import type { SpacetimeProjection } from '../geometry/vertexStage.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { OcclusionSlice } from './occlusionSlice.ts';
import { type GBufferPoint, type RestFrameView, restFrameViewOf } from './restFrameView.ts';

/** Pixels of the picture per texel, along each side. */
export const DOWNSAMPLING = 2;
/** Samples on each side of a slice. */
const STEPS_PER_SIDE = 6;
/** Farthest sample, in heights of the picture. */
const MAX_REACH = 0.75;
/** Assumed thickness of occluders along the line of sight, relative to their distance: thin poles then do not occlude half of the wall behind them. */
const RELATIVE_THICKNESS = 0.8;
/** Fraction of the radius over which the thickness fades to 0 at its end. */
const FADE_FRACTION = 1 / 3;

/** Inputs of the passes of this folder. */
export interface OcclusionView {
  readonly uniforms: FrameUniforms;
  /** Size of the G-buffer [px]. */
  readonly size: Vec2;
  /** Occluders farther away than this are ignored [m]. */
  readonly radius: Float;
  readonly place: SpacetimeProjection['place'];
  /** Whether any object moves. */
  readonly moving: boolean;
}

/** (unoccluded fraction of the sky, weighted by the cosine; apparent distance [m], 0 where there is no surface) */
export const openness = (buffer: GBuffer, view: OcclusionView): Vec4 =>
  Fn(() => {
    const { uniforms, size, place } = view;
    const cell = floor(screenCoordinate).toVar();
    const pixel = min(cell.mul(DOWNSAMPLING), size.sub(1)).toVar();
    const read = reader(buffer, view);
    const point = read(pixel);
    const open = float(1).toVar();
    const apparent = float(0).toVar();
    If(hasSurface(point), () => {
      const restView = restFrameViewOf(point, place, uniforms);
      const V = normalize(restView.position).negate().toVar();
      const normal = facetNormal(restView, pixel, V, (at) => read(at, false));
      const up = uniforms.orientation.mul(vec3(0, 1, 0));
      const right = normalize(cross(V, up)).toVar();
      const { turn, shift } = samplePattern(cell);
      const T = right
        .mul(cos(turn))
        .add(cross(right, V).mul(sin(turn)))
        .toVar();
      const slice = new OcclusionSlice(V, T, cross(T, V).toVar(), normal);
      const projectAlong = restView.projectAlong(T);
      apparent.assign(length(projectAlong(float(0))));
      marchSlice(view, { point, restView, slice, projectAlong, apparent, shift }, read);
      open.assign(slice.occludedShare.oneMinus());
    });
    return vec4(open, apparent, 0, 1);
  })();

type GBufferSampler = (pixel: Vec2, moving?: boolean) => GBufferPoint;

const hasSurface = ({ event }: GBufferPoint): Bool => dot(event.xyz, event.xyz).greaterThan(0);

function reader(buffer: GBuffer, view: OcclusionView): GBufferSampler {
  const last = view.size.sub(1);
  return (pixel, moving = view.moving) => {
    const at = ivec2(clamp(pixel, vec2(0), last)).toVar();
    const event = textureLoad(buffer.texture('event'), at).toVar();
    if (!moving) return { event };
    const motion = textureLoad(buffer.texture('motion'), at).toVar();
    return { event, velocity: fullVelocity(motion.xyz).toVar() };
  };
}

/** A direction and an offset per texel, all different within 4 × 4 texels. Source: Jimenez et al. 2016. */
function samplePattern(cell: Vec2): { turn: Float; shift: Float } {
  const [x, y] = [mod(cell.x, 4).toVar(), mod(cell.y, 4).toVar()];
  return {
    turn: mod(x.add(y), 4)
      .mul(4)
      .add(x)
      .mul(Math.PI / 16)
      .toVar(),
    shift: mod(y.sub(x).add(4), 4).div(4).toVar(),
  };
}

/** The geometric normal at a pixel: with interpolated or mapped normals, surfaces would occlude themselves. */
function facetNormal(restView: RestFrameView, pixel: Vec2, V: Vec3, read: GBufferSampler): Vec3 {
  const neighbour = (x: number, y: number) => {
    const other = read(pixel.add(vec2(x, y)));
    const offset = restView.comovingOffset(other.event).toVar();
    const square = dot(offset, offset).toVar();
    return { offset, square: select(hasSurface(other).and(square.greaterThan(0)), square, 1e30).toVar() };
  };
  const nearer = (x: number, y: number): Vec3 => {
    const [before, after] = [neighbour(-x, -y), neighbour(x, y)];
    return select(before.square.lessThan(after.square), before.offset.negate(), after.offset);
  };
  const normal = normalize(cross(nearer(0, 1), nearer(1, 0))).toVar();
  return select(dot(normal, V).lessThan(0), normal.negate(), normal).toVar();
}

interface HorizonMarch {
  readonly point: GBufferPoint;
  readonly restView: RestFrameView;
  readonly slice: OcclusionSlice;
  readonly projectAlong: (rho: Float) => Vec3;
  readonly apparent: Float;
  readonly shift: Float;
}

/** Adds the occluders on both sides of a slice, sampled at distances that grow quadratically. */
function marchSlice(
  view: OcclusionView,
  { restView, slice, projectAlong, apparent, shift }: HorizonMarch,
  read: GBufferSampler,
): void {
  const { uniforms, size, radius } = view;
  const { orientation, halfTangents, frustumCenter, jitter } = uniforms;
  const center = frustumCenter.div(halfTangents).add(jitter).toVar();
  const height = apparent.mul(halfTangents.y).mul(2).toVar();
  const farthest = min(radius, height.mul(MAX_REACH)).toVar();
  const least = height
    .mul(DOWNSAMPLING * 0.75)
    .div(size.y)
    .toVar();
  for (const side of [-1, 1] as const)
    for (let k = 0; k < STEPS_PER_SIDE; k++) {
      const t = shift.add(k).div(STEPS_PER_SIDE).toVar();
      const rho = max(farthest.mul(t.mul(t)), least.mul(k + 1)).mul(side);
      const camera = projectAlong(rho).mul(orientation).toVar();
      const ndc = camera.xy.div(halfTangents.mul(camera.z.negate())).sub(center).toVar();
      const inside = camera.z.lessThan(0).and(max(abs(ndc.x), abs(ndc.y)).lessThan(1));
      const other = read(floor(vec2(ndc.x.add(1), ndc.y.oneMinus()).mul(0.5).mul(size)));
      const front = restView.retardedOffset(other).toVar();
      const far = length(front).toVar();
      const fade = clamp(far.div(radius).oneMinus().div(FADE_FRACTION), 0, 1);
      const back = front.sub(slice.V.mul(far.mul(fade).mul(RELATIVE_THICKNESS))).toVar();
      slice.occlude(front, back, side, select(inside.and(hasSurface(other)), 1, 0));
    }
}
