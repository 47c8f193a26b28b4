import {
  abs,
  clamp,
  dFdx,
  dFdy,
  dot,
  Fn,
  float,
  floor,
  ivec2,
  length,
  max,
  min,
  mix,
  pow,
  screenCoordinate,
  screenSize,
  select,
  sqrt,
  textureLoad,
  transpose,
  uniform,
  vec2,
  vec3,
  vec4,
} from 'three/tsl';
import { type Texture, type TextureNode, Vector3 } from 'three/webgpu';
import { ontoLightCone } from '../../../shaders/emission/ontoLightCone.ts';
import { dopplerFactor } from '../../../shaders/kinematics/dopplerFactor.ts';
import { fullVelocity } from '../../../shaders/kinematics/fullVelocity.ts';
import { unaberrate } from '../../../shaders/kinematics/unaberrate.ts';
import { ontoShallowCone } from '../../../shaders/shallowCone/ontoShallowCone.ts';
import type { ShallowObserver } from '../../../shaders/shallowCone/shallowObserver.ts';
import type { Bool, Float, Vec2, Vec3, Vec4 } from '../../../shaders/types.ts';
import type { GBuffer } from '../../gbuffer/gbuffer.ts';
import { observerPosition, type SpacetimeProjection } from '../../geometry/vertexStage.ts';
import type { FrameUniforms } from '../../gpu/frameUniforms.ts';
import { frustumDirection } from '../../gpu/fullScreenPass.ts';
import type { PreviousView } from './previousView.ts';

/*
 * Temporal antialiasing (docs/adr/0012-antialiasing.md): each picture has one sample per pixel, at a different position in it, and is blended with the history,
 * fetched from where the same material points were seen in the previous picture. That place needs no second solution of the vertices: a point moves
 * straight on from the event that is seen now, for as long as two pictures are apart, and so meets the previous light cone in closed form.
 * The constants were chosen by `npm run bench -- antialiasing`.
 */

/** A new picture has a weight of at least 1/(1 + MAX_HISTORY). */
const MAX_HISTORY = 12;
/** The history is clipped to this many standard deviations about the mean of the neighbourhood, */
const CLIP_DEVIATIONS = 1.25;
/** plus this many times its recent error: where that is large, detail is finer than pixels, and clipping would flicker. */
const INSTABILITY_GAIN = 1;
/** Weight of the newest error in the recent error. */
const INSTABILITY_DECAY = 1 / 6;
/** Tolerances of nearness, relative and in terms of the neighbourhood's range: what was nearer by more occluded what is seen now. */
const [RELATIVE_SLACK, SLOPE] = [0.03, 0.1];
/** Where the picture is magnified the history lacks detail: its weight falls with this power of the area ratio. */
const MAGNIFICATION_POWER = 5;
/** Where D changes brightness the history shows another light: its weight falls with this power of the ratio of Doppler factors. */
const DOPPLER_POWER = 60;
/** Sharpness of the reconstruction filter while there is little history [1/px²]. Source: Karis 2014, "High quality temporal supersampling". */
const FILTER_SHARPNESS = 2.3;
/** Pictures of history from which on a sample is not filtered. */
const FILTERED_FRAMES = 6;

const NEIGHBORS = [-1, 0, 1].flatMap((y) => [-1, 0, 1].map((x) => [x, y] as const));
const isInner = (k: number): boolean => k === 1 || k === 2;
/** 4 × 4 texels without the corners. */
const SPLINE_TEXELS = [0, 1, 2, 3].flatMap((y) =>
  [0, 1, 2, 3].flatMap((x) => (isInner(x) || isInner(y) ? [[x, y] as const] : [])),
);
const CORNERS = [0, 1].flatMap((y) => [0, 1].map((x) => [x, y] as const));

export interface TemporalSources {
  /** This picture and the previous one: YCoCg of display light, linear, and 1/|Δx′| [1/m], 0 where there is no surface. */
  readonly current: TextureNode;
  readonly previous: TextureNode;
  /** YCoCg of the mean of earlier pictures; the fourth channel holds their number, and in its fraction the recent error of luma. */
  readonly history: TextureNode;
  readonly buffer: GBuffer;
  readonly uniforms: FrameUniforms;
  readonly previousView: PreviousView;
  readonly filter: ReconstructionFilter;
  readonly projection: SpacetimeProjection;
}

/** Weights of 3 × 3 samples in the reconstruction at the centre of the middle pixel, as products of a column's and a row's weight. */
export class ReconstructionFilter {
  readonly columns = uniform(new Vector3());
  readonly rows = uniform(new Vector3());

  /** Sample position relative to the pixel's centre, right and down [px]. */
  setJitter(dx: number, dy: number): void {
    const weight = (distance: number): number => Math.exp(-FILTER_SHARPNESS * distance ** 2);
    this.columns.value.set(weight(dx - 1), weight(dx), weight(dx + 1));
    this.rows.value.set(weight(dy - 1), weight(dy), weight(dy + 1));
  }
}

const clampedTexel = (of: Texture | TextureNode, at: Vec2): Vec4 =>
  textureLoad(of, ivec2(clamp(at, vec2(0.5), screenSize.sub(0.5)))).toVar();

/** The new history, as `TemporalSources.history`. */
export const temporalResolve = (sources: TemporalSources): Vec4 =>
  Fn(() => {
    const { history, previousView } = sources;
    const around = neighborhoodOf(sources);
    const { shift, nearness, brightnessRatio } = reproject(
      sources,
      screenCoordinate.add(around.nearest.xy),
      around.nearest.w,
    );
    const from = screenCoordinate.add(shift.mul(vec2(0.5, -0.5)).mul(screenSize)).toVar();
    const counter = clampedTexel(history, from).w.toVar();
    const recentError = counter.fract().toVar();
    const mean = catmullRom(history, from).toVar();
    const previous = previousSampleAt(sources, from);
    const usable = isInside(from)
      .and(previousView.isValid.greaterThan(0.5))
      .and(wasOccluded(previous.nearest, nearness, around).not());
    const weight = brightnessRatio.mul(pow(minification(from), MAGNIFICATION_POWER));
    const count = select(usable, min(floor(counter), MAX_HISTORY).mul(weight), 0).toVar();

    const sample = mix(around.filtered, around.own, min(count.div(FILTERED_FRAMES), 1)).toVar();
    const clipped = clipToNeighborhood(mean, around.mean, around.spread.add(recentError.mul(INSTABILITY_GAIN)));
    // A sample equal to the previous one is no flicker: the lighting has changed, as where a shadow moves away.
    const error = min(abs(around.own.x.sub(mean.x)), abs(around.own.x.sub(previous.luma)));
    const newError = mix(recentError, error, INSTABILITY_DECAY).min(0.95);
    const hasHistory = count.greaterThan(0.5);
    return vec4(
      mix(sample, clipped, count.div(count.add(1))),
      floor(count.add(1.5)).add(select(hasHistory, newError, 0)),
    );
  })();

interface Neighborhood {
  readonly own: Vec3;
  /** The picture at the pixel's centre, reconstructed from the 3 × 3 samples. */
  readonly filtered: Vec3;
  readonly mean: Vec3;
  readonly spread: Vec3;
  /** Offset of the pixel with the nearest surface [px], and its 1/|Δx′|. */
  readonly nearest: Vec4;
  /** The least 1/|Δx′|. */
  readonly farthest: Float;
}

function neighborhoodOf({ current, filter }: TemporalSources): Neighborhood {
  const own = clampedTexel(current, screenCoordinate);
  const [columns, rows] = [filter.columns, filter.rows].map(({ x, y, z }) => [x, y, z]);
  const [sum, squares, filtered] = [vec4(0).toVar(), vec3(0).toVar(), vec4(0).toVar()];
  const nearest = vec4(0, 0, 0, -1).toVar();
  const farthest = float(1e9).toVar();
  for (const [x, y] of NEIGHBORS) {
    const texel = x === 0 && y === 0 ? own : clampedTexel(current, screenCoordinate.add(vec2(x, y)));
    const weight = columns[x + 1].mul(rows[y + 1]);
    sum.addAssign(vec4(texel.xyz, 1));
    squares.addAssign(texel.xyz.mul(texel.xyz));
    filtered.addAssign(vec4(texel.xyz, 1).mul(weight));
    nearest.assign(select(texel.w.greaterThan(nearest.w), vec4(x, y, 0, texel.w), nearest));
    farthest.assign(min(farthest, texel.w));
  }
  const mean = sum.xyz.div(NEIGHBORS.length).toVar();
  const variance = max(squares.div(NEIGHBORS.length).sub(mean.mul(mean)), 0);
  return {
    own: own.xyz,
    filtered: filtered.xyz.div(filtered.w),
    mean,
    spread: sqrt(variance).mul(CLIP_DEVIATIONS),
    nearest,
    farthest,
  };
}

/** Moves a colour towards the neighbourhood's mean until it is within its spread. Source: Salvi 2016, "An excursion in temporal supersampling". */
function clipToNeighborhood(color: Vec3, mean: Vec3, spread: Vec3): Vec3 {
  const difference = color.sub(mean).toVar();
  const ratio = abs(difference).div(max(spread, 1e-5)).toVar();
  return mean.add(difference.div(max(max(ratio.x, max(ratio.y, ratio.z)), 1)));
}

interface Reprojection {
  /** From its place in this picture to that in the previous one [half-pictures]. */
  readonly shift: Vec2;
  /** 1/|Δx′| in the previous picture [1/m], 0 of the background. */
  readonly nearness: Float;
  /** 1 where D is the same in both pictures, less where it has changed brightness. */
  readonly brightnessRatio: Float;
}

/** Where the surface at a pixel was in the previous picture; `near`: its 1/|Δx′|. */
function reproject(
  { buffer, uniforms, previousView, projection }: TemporalSources,
  pixel: Vec2,
  near: Float,
): Reprojection {
  const hasSurface = near.greaterThan(0);
  const v = clampedTexel(buffer.texture('motion'), pixel).xyz.toVar();
  const velocity = select(hasSurface, fullVelocity(v), vec4(0, 0, 0, 1)).toVar();
  // The background is at rest, and so far away that the observer's displacement does not matter, nor the camera's.
  const n = frustumDirection(uniforms).toVar();
  const sky = SKY_DIRECTION[projection.place](n, uniforms.u, uniforms.gamma);
  const now = select(hasSurface, clampedTexel(buffer.texture('event'), pixel), vec4(sky, -1)).toVar();
  const passed = now.add(select(hasSurface, previousView.displacement, vec4(0))).toVar();
  const previousEvent = PREVIOUS_EVENT[projection.event](passed, velocity, previousView.observer).toVar();

  const [p, q] = [
    observerPosition(now.xyz, projection.place, uniforms).sub(select(hasSurface, uniforms.vantage, vec3(0))),
    observerPosition(previousEvent.xyz, projection.place, previousView.observer)
      .sub(select(hasSurface, previousView.observer.vantage, vec3(0)))
      .toVar(),
  ];
  const here = projected(transpose(uniforms.orientation).mul(p), uniforms);
  const D = dopplerFactor(now.xyz, uniforms.u, uniforms.gamma, velocity).toVar();
  const previousD = dopplerFactor(
    previousEvent.xyz,
    previousView.observer.u,
    previousView.observer.gamma,
    velocity,
  ).toVar();
  return {
    shift: projected(previousView.toCamera.mul(q), previousView).sub(here),
    nearness: select(hasSurface, max(length(q), 1e-4).reciprocal(), 0).toVar(),
    brightnessRatio: pow(min(D.div(previousD), previousD.div(D)), uniforms.boostLight.mul(DOPPLER_POWER)),
  };
}

/** Where a point is in the picture: −1 … 1. */
function projected(
  inCamera: Vec3,
  { halfTangents, frustumCenter }: Pick<FrameUniforms, 'halfTangents' | 'frustumCenter'>,
): Vec2 {
  const p = inCamera.toVar();
  return p.xy.div(max(p.z.negate(), 1e-20)).div(halfTangents).sub(frustumCenter.div(halfTangents));
}

/** The direction in the world of the sky seen in the direction n′. */
const SKY_DIRECTION: Readonly<Record<SpacetimeProjection['place'], (nPrime: Vec3, u: Vec3, gamma: Float) => Vec3>> = {
  apparent: (nPrime, u, gamma) => unaberrate(nPrime, u, gamma),
  contracted: (nPrime) => nPrime,
  shallow: (nPrime) => nPrime,
  plain: (nPrime) => nPrime,
};

/** The event at which a point, which passes `event` with `velocity`, is on the hypersurface of the previous picture. */
const PREVIOUS_EVENT: Readonly<
  Record<SpacetimeProjection['event'], (event: Vec4, velocity: Vec4, previous: ShallowObserver) => Vec4>
> = {
  emission: (event, velocity) => ontoLightCone(event, velocity),
  newtonEmission: (event, velocity) => ontoLightCone(event, velocity),
  slice: (event, velocity, { u, gamma }) => ontoSlice(event, velocity, u.div(gamma)),
  newtonSlice: (event, velocity, { u, gamma }) => ontoSlice(event, velocity, u.div(gamma)),
  shallow: (event, velocity, previous) => ontoShallowCone(event, velocity, previous),
  now: (event, velocity) => ontoSlice(event, velocity, vec3(0)),
};

/** As `ontoLightCone`, onto the slice of simultaneity of the frame with velocity β. docs/physics.md §5.2. */
function ontoSlice(event: Vec4, velocity: Vec4, beta: Vec3): Vec4 {
  const later = dot(beta, event.xyz)
    .sub(event.w)
    .div(float(1).sub(dot(beta, velocity.xyz)));
  return event.add(vec4(velocity.xyz, 1).mul(later));
}

const isInside = ({ x, y }: Vec2): Bool =>
  x.greaterThan(0).and(y.greaterThan(0)).and(x.lessThan(screenSize.x)).and(y.lessThan(screenSize.y));

interface PreviousSample {
  /** Of the previous picture's samples. */
  readonly luma: Float;
  /** The greatest 1/|Δx′| there. */
  readonly nearest: Float;
}

function previousSampleAt({ previous }: TemporalSources, from: Vec2): PreviousSample {
  const corner = floor(from.sub(0.5)).add(0.5).toVar();
  const f = from.sub(corner).toVar();
  const [a, b, c, d] = CORNERS.map(([x, y]) => clampedTexel(previous, corner.add(vec2(x, y))));
  return {
    luma: mix(mix(a.x, b.x, f.x), mix(c.x, d.x, f.x), f.y),
    nearest: max(max(a.w, b.w), max(c.w, d.w)),
  };
}

/** Whether something nearer hid it in the previous picture. */
function wasOccluded(nearest: Float, nearness: Float, around: Neighborhood): Bool {
  const slack = around.nearest.w.sub(around.farthest).mul(SLOPE).add(around.nearest.w.mul(RELATIVE_SLACK));
  return nearest.sub(nearness).greaterThan(slack);
}

/** Area of a pixel in the previous picture over its area now, at most 1. */
function minification(from: Vec2): Float {
  const [x, y] = [dFdx(from).toVar(), dFdy(from).toVar()];
  return min(abs(x.x.mul(y.y).sub(x.y.mul(y.x))), 1);
}

/**
 * A Catmull-Rom spline of 4 × 4 texels without its corners (Jimenez 2016, "Filmic SMAA"), clamped to the range of the nearest four: its undershoot
 * beside moving edges would otherwise accumulate to black lines. Texels are loaded one by one, for filtering is slow on a software GPU.
 */
function catmullRom(of: TextureNode, at: Vec2): Vec3 {
  const middle = floor(at.sub(0.5)).add(0.5).toVar();
  const f = at.sub(middle).toVar();
  const weights = [
    f.mul(f.mul(f.mul(-0.5).add(1)).sub(0.5)),
    f.mul(f).mul(f.mul(1.5).sub(2.5)).add(1),
    f.mul(f.mul(f.mul(-1.5).add(2)).add(0.5)),
    f.mul(f).mul(f.mul(0.5).sub(0.5)),
  ].map((weight): Vec2 => weight.toVar());
  const sum = vec4(0).toVar();
  const inner: Vec3[] = [];
  for (const [x, y] of SPLINE_TEXELS) {
    const texel = clampedTexel(of, middle.add(vec2(x - 1, y - 1))).xyz;
    sum.addAssign(vec4(texel, 1).mul(weights[x].x.mul(weights[y].y)));
    if (isInner(x) && isInner(y)) inner.push(texel);
  }
  const [least, most] = [min, max].map((extreme) => inner.reduce((a, b): Vec3 => extreme(a, b)));
  return clamp(sum.xyz.div(sum.w), least, most);
}
