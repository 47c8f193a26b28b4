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
import { unaberrate } from '../../../shaders/kinematics/unaberrate.ts';
import type { Bool, Float, Vec2, Vec3, Vec4 } from '../../../shaders/types.ts';
import type { GBuffer } from '../../gbuffer/gbuffer.ts';
import { observerPosition, type SpacetimeProjection } from '../../geometry/vertexStage.ts';
import type { FrameUniforms } from '../../gpu/frameUniforms.ts';
import { pixelDirection } from '../../gpu/fullScreenPass.ts';
import type { PreviousView } from './previousView.ts';

/*
 * Antialiasing over time: each picture has one sample per pixel, at another place in it, and is blended with the mean of those before, fetched
 * from where the same points of matter were seen then. That place needs no second solution of the vertices: a point runs straight on from the
 * event that is seen of it now, as long as two pictures are apart, and so meets the light cone of the eye before in closed form.
 * How much and what of the past counts was chosen by `npm run bench -- antialiasing`.
 */

/** A new picture counts for at least 1/(1 + MOST). */
const MAX_HISTORY = 12;
/** The past may be so many standard deviations of what is around now away from its mean, */
const CLIP_DEVIATIONS = 1.25;
/** and farther by so many times what it has lately been off by: where that is much, pixels are too coarse to tell what is there. */
const INSTABILITY_GAIN = 1;
/** So quickly is that forgotten. */
const INSTABILITY_DECAY = 1 / 6;
/** Of nearness, relative and against what is around: what was nearer than that stood before what is seen now. */
const [ASIDE, SLOPE] = [0.03, 0.1];
/** What grows is not known so finely from before: its weight falls with this power of the area. */
const MAGNIFICATION_POWER = 5;
/** What changes its brightness with D is another light than before: so falls its weight with D. */
const DOPPLER_POWER = 60;
/** Sharpness of the filter over neighbours while there is little past [1/px²]. Source: Karis 2014, "High quality temporal supersampling". */
const FILTER_SHARPNESS = 2.3;
/** Pictures after which a sample stands for itself. */
const FILTERED_FRAMES = 6;

const AROUND = [-1, 0, 1].flatMap((y) => [-1, 0, 1].map((x) => [x, y] as const));
/** Of 4 × 4 texels, without the corners. */
const isInner = (k: number): boolean => k === 1 || k === 2;
const PLACES = [0, 1, 2, 3].flatMap((y) =>
  [0, 1, 2, 3].flatMap((x) => (isInner(x) || isInner(y) ? [[x, y] as const] : [])),
);
const CORNERS = [0, 1].flatMap((y) => [0, 1].map((x) => [x, y] as const));

export interface TemporalSources {
  /** This picture and the one before: YCoCg of display light, linear, and 1/|Δx′| [1/m], 0 where no surface is. */
  readonly current: TextureNode;
  readonly previous: TextureNode;
  /** The mean of those before, and in the fourth how many they count for, and in its fraction how far off the past has lately been. */
  readonly history: TextureNode;
  readonly buffer: GBuffer;
  readonly uniforms: FrameUniforms;
  readonly previousView: PreviousView;
  readonly filter: ReconstructionFilter;
  readonly projection: SpacetimeProjection;
}

/** What the samples in three columns and three rows of pixels count for at the centre of the middle one: their products, wherever in their pixels they are. */
export class ReconstructionFilter {
  readonly columns = uniform(new Vector3());
  readonly rows = uniform(new Vector3());

  /** From the pixels' centres, right and down [px]. */
  setJitter(dx: number, dy: number): void {
    const weight = (away: number): number => Math.exp(-FILTER_SHARPNESS * away ** 2);
    this.columns.value.set(weight(dx - 1), weight(dx), weight(dx + 1));
    this.rows.value.set(weight(dy - 1), weight(dy), weight(dy + 1));
  }
}

/** Luma and two differences of colour. */
export const toYCoCg = ({ x: r, y: g, z: b }: Vec3): Vec3 =>
  vec3(r.add(b).mul(0.25).add(g.mul(0.5)), r.sub(b).mul(0.5), g.mul(0.5).sub(r.add(b).mul(0.25)));
export const fromYCoCg = ({ x: y, y: co, z: cg }: Vec3): Vec3 => vec3(y.add(co).sub(cg), y.add(cg), y.sub(co).sub(cg));

const clampedTexel = (of: Texture | TextureNode, at: Vec2): Vec4 =>
  textureLoad(of, ivec2(clamp(at, vec2(0.5), screenSize.sub(0.5)))).toVar();

/** The next mean, as `TemporalSources.history`. */
export const temporalResolve = (sources: TemporalSources): Vec4 =>
  Fn(() => {
    const { history, previousView: before } = sources;
    const around = neighborhoodOf(sources);
    const { shift, nearness, brightnessRatio } = reproject(
      sources,
      screenCoordinate.add(around.nearest.xy),
      around.nearest.w,
    );
    const from = screenCoordinate.add(shift.mul(vec2(0.5, -0.5)).mul(screenSize)).toVar();
    const memory = clampedTexel(history, from).w.toVar();
    const unrest = memory.fract().toVar();
    const then = catmullRom(history, from).toVar();
    const former = previousSampleAt(sources, from);
    const usable = isInside(from)
      .and(before.isValid.greaterThan(0.5))
      .and(wasOccluded(former.nearest, nearness, around).not());
    const worth = brightnessRatio.mul(pow(minification(from), MAGNIFICATION_POWER));
    const count = select(usable, min(floor(memory), MAX_HISTORY).mul(worth), 0).toVar();

    const sample = mix(around.filtered, around.own, min(count.div(FILTERED_FRAMES), 1)).toVar();
    const kept = clipToNeighborhood(then, around.mean, around.spread.add(unrest.mul(INSTABILITY_GAIN)));
    // What was the same a moment ago does not flicker: another light has come, as where a shadow goes.
    const wrong = min(abs(around.own.x.sub(then.x)), abs(around.own.x.sub(former.luma)));
    const off = mix(unrest, wrong, INSTABILITY_DECAY).min(0.95);
    const known = count.greaterThan(0.5);
    return vec4(mix(sample, kept, count.div(count.add(1))), floor(count.add(1.5)).add(select(known, off, 0)));
  })();

interface Neighborhood {
  readonly own: Vec3;
  /** The picture at the pixel's centre, from the samples about it. */
  readonly filtered: Vec3;
  readonly mean: Vec3;
  readonly spread: Vec3;
  /** Where the nearest surface is of those in the pixels around, and its 1/|Δx′|. */
  readonly nearest: Vec4;
  /** The least 1/|Δx′| around. */
  readonly farthest: Float;
}

function neighborhoodOf({ current, filter }: TemporalSources): Neighborhood {
  const own = clampedTexel(current, screenCoordinate);
  const [columns, rows] = [filter.columns, filter.rows].map(({ x, y, z }) => [x, y, z]);
  const [sum, squares, filtered] = [vec4(0).toVar(), vec3(0).toVar(), vec4(0).toVar()];
  const nearest = vec4(0, 0, 0, -1).toVar();
  const farthest = float(1e9).toVar();
  for (const [x, y] of AROUND) {
    const texel = x === 0 && y === 0 ? own : clampedTexel(current, screenCoordinate.add(vec2(x, y)));
    const share = columns[x + 1].mul(rows[y + 1]);
    sum.addAssign(vec4(texel.xyz, 1));
    squares.addAssign(texel.xyz.mul(texel.xyz));
    filtered.addAssign(vec4(texel.xyz, 1).mul(share));
    nearest.assign(select(texel.w.greaterThan(nearest.w), vec4(x, y, 0, texel.w), nearest));
    farthest.assign(min(farthest, texel.w));
  }
  const mean = sum.xyz.div(AROUND.length).toVar();
  const variance = max(squares.div(AROUND.length).sub(mean.mul(mean)), 0);
  return {
    own: own.xyz,
    filtered: filtered.xyz.div(filtered.w),
    mean,
    spread: sqrt(variance).mul(CLIP_DEVIATIONS),
    nearest,
    farthest,
  };
}

/** Towards the mean of the surroundings, until it is within their spread. Source: Salvi 2016, "An excursion in temporal supersampling". */
function clipToNeighborhood(color: Vec3, mean: Vec3, spread: Vec3): Vec3 {
  const away = color.sub(mean).toVar();
  const over = abs(away).div(max(spread, 1e-5)).toVar();
  return mean.add(away.div(max(max(over.x, max(over.y, over.z)), 1)));
}

interface Reprojection {
  /** From where it is in this picture to where it was in the one before [half-pictures]. */
  readonly shift: Vec2;
  /** 1/|Δx′| then [1/m], 0 of what is behind everything. */
  readonly nearness: Float;
  /** 1 where it was seen with the same D, and less where its brightness has changed. */
  readonly brightnessRatio: Float;
}

/** What is seen at a pixel, in the picture before; `near`: its 1/|Δx′|. */
function reproject(
  { buffer, uniforms, previousView: before, projection }: TemporalSources,
  pixel: Vec2,
  near: Float,
): Reprojection {
  const there = near.greaterThan(0);
  const v = clampedTexel(buffer.texture('motion'), pixel).xyz.toVar();
  const speed = length(v).toVar();
  const velocity = select(there, vec4(v, speed.oneMinus().mul(speed.add(1))), vec4(0, 0, 0, 1)).toVar();
  // The background is at rest, and so far away that the observer's displacement does not matter.
  const n = pixelDirection(uniforms).toVar();
  const sky = SKY_DIRECTION[projection.place](n, uniforms.u, uniforms.gamma);
  const now = select(there, clampedTexel(buffer.texture('event'), pixel), vec4(sky, -1)).toVar();
  const passed = now.add(select(there, before.displacement, vec4(0))).toVar();
  const then = PREVIOUS_EVENT[projection.event](passed, velocity, before).toVar();

  const [p, q] = [
    observerPosition(now.xyz, projection.place, uniforms),
    observerPosition(then.xyz, projection.place, before).toVar(),
  ];
  const here = projected(transpose(uniforms.orientation).mul(p), uniforms);
  const D = dopplerFactor(now.xyz, uniforms.u, uniforms.gamma, velocity).toVar();
  const formerD = dopplerFactor(then.xyz, before.u, before.gamma, velocity).toVar();
  return {
    shift: projected(before.toCamera.mul(q), before).sub(here),
    nearness: select(there, max(length(q), 1e-4).reciprocal(), 0).toVar(),
    brightnessRatio: pow(min(D.div(formerD), formerD.div(D)), uniforms.boostLight.mul(DOPPLER_POWER)),
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
  plain: (nPrime) => nPrime,
};

/** The event at which a point, which passes `event` with `velocity`, is on the hypersurface of the previous picture. */
const PREVIOUS_EVENT: Readonly<
  Record<SpacetimeProjection['event'], (event: Vec4, velocity: Vec4, previous: PreviousView) => Vec4>
> = {
  emission: (event, velocity) => ontoLightCone(event, velocity),
  newton: (event, velocity) => ontoLightCone(event, velocity),
  slice: (event, velocity, { u, gamma }) => ontoSlice(event, velocity, u.div(gamma)),
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
  /** As it was sampled in the picture before. */
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

/** Whether something stood before it then. */
function wasOccluded(nearest: Float, nearness: Float, around: Neighborhood): Bool {
  const slack = around.nearest.w.sub(around.farthest).mul(SLOPE).add(around.nearest.w.mul(ASIDE));
  return nearest.sub(nearness).greaterThan(slack);
}

/** Area in the picture before over that of a pixel now, at most 1. */
function minification(from: Vec2): Float {
  const [x, y] = [dFdx(from).toVar(), dFdy(from).toVar()];
  return min(abs(x.x.mul(y.y).sub(x.y.mul(y.x))), 1);
}

/**
 * A Catmull-Rom spline of 4 × 4 texels without its corners (Jimenez 2016, "Filmic SMAA"), and never outside of the nearest four: from picture to
 * picture its undershoot beside edges that move would grow to black lines. Texels are fetched, for a software GPU takes long to filter.
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
  for (const [x, y] of PLACES) {
    const texel = clampedTexel(of, middle.add(vec2(x - 1, y - 1))).xyz;
    sum.addAssign(vec4(texel, 1).mul(weights[x].x.mul(weights[y].y)));
    if (isInner(x) && isInner(y)) inner.push(texel);
  }
  const [least, most] = [min, max].map((extreme) => inner.reduce((a, b): Vec3 => extreme(a, b)));
  return clamp(sum.xyz.div(sum.w), least, most);
}
