import {
  abs,
  clamp,
  Discard,
  dot,
  Fn,
  float,
  floor,
  If,
  int,
  inverseSqrt,
  ivec2,
  Loop,
  length,
  max,
  min,
  mix,
  mrt,
  normalize,
  pow,
  property,
  screenSize,
  select,
  textureLoad,
  uniform,
  vec2,
  vec3,
  vec4,
} from 'three/tsl';
import { AlwaysDepth, NoBlending, NodeMaterial, QuadMesh, Vector3, type WebGPURenderer } from 'three/webgpu';
import type { Vec3 as Vector } from '../../math/vec3.ts';
import { CUBE_FACES } from '../../scene/view/lenses/cubeFaces.ts';
import { boost } from '../../shaders/kinematics/boost.ts';
import { dopplerFactor } from '../../shaders/kinematics/dopplerFactor.ts';
import { fullVelocity } from '../../shaders/kinematics/fullVelocity.ts';
import { unaberrate } from '../../shaders/kinematics/unaberrate.ts';
import type { Bool, Float, Int, Vec2, Vec3, Vec4 } from '../../shaders/types.ts';
import type { GBuffer } from '../gbuffer/gbuffer.ts';
import type { TargetName } from '../gbuffer/surface.ts';
import { packNormals, unpackNormals } from '../gbuffer/surfacePacking.ts';
import type { SpacetimeProjection } from '../geometry/vertexStage.ts';
import { FAR, logarithmicDepthOf, NEAR } from '../gpu/depth.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { frustumDirection } from '../gpu/fullScreenPass.ts';

/** Columns and rows of faces. */
export const ATLAS_GRID = [3, 2] as const;
/** (v, 1 − v²) */
const AT_REST = vec4(0, 0, 0, 1);
/** Most texels across that the colours of a pixel are the mean of; of a wider footprint as many are taken, at equal distances. */
const MAX_TAPS = 4;

/** Where a pixel's direction is on the atlas. */
interface AtlasPlace {
  /** Unit direction at rest, and the forward axis of its face. */
  readonly direction: Vec3;
  readonly forward: Vec3;
  /** On the face, from its top left corner [texels]. */
  readonly on: Vec2;
  /** Of the face's corner in the atlas [texels]. */
  readonly corner: Vec2;
  /** Side of the pixel's part of the sky [texels]. */
  readonly footprint: Float;
}

interface WarpPass {
  readonly quad: QuadMesh;
  readonly material: NodeMaterial;
}

/**
 * Fills G-buffers from an atlas of faces at rest: the direction of each pixel, unaberrated, meets the same surface at the same event; only D and the
 * apparent distance are another observer's. The place is interpolated on the plane of the surface (1/depth is linear on a face), colours are filtered over the
 * pixel's footprint, both only within the surface that most of the four nearest texels show, by their weights: so outlines run from texel to texel, not in steps.
 */
export class CaptureWarp {
  private readonly atlas: GBuffer;
  private readonly uniforms: FrameUniforms;
  private readonly side = uniform(1);
  /** How far the observer has moved since the capture [m]. */
  private readonly moved = uniform(new Vector3());
  /** By target and placement. */
  private readonly passes = new Map<string, WarpPass>();

  constructor(atlas: GBuffer, uniforms: FrameUniforms) {
    this.atlas = atlas;
    this.uniforms = uniforms;
  }

  run(renderer: WebGPURenderer, to: GBuffer, side: number, moved: Vector, place: SpacetimeProjection['place']): void {
    this.side.value = side;
    this.moved.value.set(...moved);
    renderer.setMRT(null);
    for (const { names, target } of to.passes) {
      const key = `${target.texture.id} ${place}`;
      const pass = this.passes.get(key) ?? this.makePass(names, place, renderer.reversedDepthBuffer);
      this.passes.set(key, pass);
      renderer.setRenderTarget(target);
      pass.quad.render(renderer);
    }
  }

  dispose(): void {
    for (const { material } of this.passes.values()) material.dispose();
  }

  /** three.js evaluates the depth before the outputs: it finds all of them. */
  private makePass(names: readonly TargetName[], place: SpacetimeProjection['place'], reversed: boolean): WarpPass {
    const outputs = names.map((name) => property('vec4', `warp_${name}`));
    const material = new NodeMaterial();
    material.name = `capture ${names[0]} ${place}`;
    material.depthNode = Fn(() => {
      const { uniforms } = this;
      const seen = frustumDirection(uniforms).toVar();
      const values = this.targetValues(this.placeOf(seen, place), place);
      for (const [i, name] of names.entries()) outputs[i]!.assign(values[name]);
      const distance = values.object.y;
      if (!reversed) return logarithmicDepthOf(distance);
      const ahead = distance.mul(dot(seen, uniforms.orientation.mul(vec3(0, 0, -1))));
      return float(FAR)
        .div(ahead)
        .sub(1)
        .mul(NEAR / (FAR - NEAR));
    })();
    material.fragmentNode = mrt(Object.fromEntries(names.map((name, i) => [name, outputs[i]!])));
    material.depthFunc = AlwaysDepth;
    material.depthTest = true;
    material.depthWrite = true;
    material.blending = NoBlending;
    return { quad: new QuadMesh(material), material };
  }

  /** `seen`: unit, in the observer's frame. */
  private placeOf(seen: Vec3, place: SpacetimeProjection['place']): AtlasPlace {
    const { u, gamma, halfTangents, orientation, footprint } = this.uniforms;
    const isBoosted = place === 'apparent';
    const direction = normalize(isBoosted ? unaberrate(seen, u, gamma) : seen).toVar();
    const [aside, forward, face] = [vec2(0).toVar(), vec3(0).toVar(), float(0).toVar()];
    const depth = float(-1).toVar();
    CUBE_FACES.forEach((axes, k) => {
      const along = dot(direction, vec3(...axes.forward)).toVar();
      If(along.greaterThan(depth), () => {
        depth.assign(along);
        forward.assign(vec3(...axes.forward));
        aside.assign(vec2(dot(direction, vec3(...axes.right)), dot(direction, vec3(...axes.up))));
        face.assign(k);
      });
    });
    const { side } = this;
    // A face has a texel more at each side than its square.
    const texelsPerTangent = side.sub(2).mul(0.5).toVar();
    const on = vec2(aside.x, aside.y.negate()).div(depth).mul(texelsPerTangent).add(side.mul(0.5)).toVar();
    const row = floor(face.add(0.5).div(ATLAS_GRID[0])).toVar();
    // Square roots of solid angles: of a pixel, at rest D times as wide, and of a texel.
    const axis = dot(seen, orientation.mul(vec3(0, 0, -1)));
    const pixel = pow(axis, 1.5).mul(halfTangents.y.mul(2)).div(screenSize.y).mul(footprint);
    const doppler = isBoosted ? dopplerFactor(direction, u, gamma, AT_REST) : float(1);
    const texel = pow(depth, 1.5).div(texelsPerTangent);
    return {
      direction,
      forward,
      on,
      corner: vec2(face.sub(row.mul(ATLAS_GRID[0])), row)
        .mul(side)
        .toVar(),
      footprint: pixel.mul(doppler).div(texel).toVar(),
    };
  }

  /** Discards pixels without a surface. */
  private targetValues(at: AtlasPlace, place: SpacetimeProjection['place']): Record<TargetName, Vec4> {
    const { u, gamma, boostLight } = this.uniforms;
    const neighbours = this.neighbours(at);
    const { texel, among } = shownSurface(neighbours);
    const nearest = this.reader(at, texel);
    const object = nearest('object').toVar();
    Discard(object.x.lessThan(0.5));
    const sums = interpolated(neighbours, among, at.forward);
    const depth = sums.weight.div(max(sums.nearness, 1e-30));
    const dx = at.direction
      .mul(depth.div(dot(at.direction, at.forward)))
      .sub(this.moved)
      .toVar();
    const distance = length(dx).toVar();
    const velocity = sums.velocity.div(sums.weight).toVar();
    const D = mix(1, dopplerFactor(dx, u, gamma, fullVelocity(velocity)), boostLight);
    const apparent = place === 'apparent' ? distance.mul(dopplerFactor(dx, u, gamma, AT_REST)) : distance;
    return {
      ...this.filteredColors(at, object.x, nearest),
      normal: packNormals(normalize(sums.normal), sums.invisible.div(sums.weight)),
      object: vec4(object.x, apparent, 0, 1),
      event: vec4(dx, distance.negate()),
      motion: vec4(velocity, D),
    };
  }

  private neighbours(at: AtlasPlace): readonly Neighbour[] {
    const first = floor(at.on.sub(0.5)).toVar();
    const share = at.on.sub(0.5).sub(first).toVar();
    return NEIGHBOURS.map(([dx, dy]) => {
      const texel = first.add(vec2(dx, dy)).toVar();
      const read = this.reader(at, texel);
      const { normal, invisible } = unpackNormals(read('normal').toVar());
      const velocity = read('motion').xyz.toVar();
      return {
        texel,
        weight: (dx ? share.x : share.x.oneMinus()).mul(dy ? share.y : share.y.oneMinus()).toVar(),
        object: read('object').x.toVar(),
        event: read('event').toVar(),
        velocity,
        gamma: inverseSqrt(fullVelocity(velocity).w).toVar(),
        normal: normal.toVar(),
        invisible: invisible.toVar(),
      };
    });
  }

  /** Base colour and emission, the means of the texels under the footprint, at least one texel wide; codes beside them are the nearest texel's. */
  private filteredColors(at: AtlasPlace, object: Float, nearest: TexelReader): { base: Vec4; emissive: Vec4 } {
    const base = nearest('base').toVar();
    const emissive = nearest('emissive').toVar();
    const width = max(at.footprint, 1).toVar();
    const taps = min(width, MAX_TAPS).toVar();
    const stride = width.div(taps).toVar();
    const low = at.on.div(stride).sub(taps.mul(0.5)).toVar();
    const first = floor(low).toVar();
    const [sum, weights] = [vec3(0).toVar(), float(0).toVar()];
    const [glow, glowing] = [vec3(0).toVar(), float(0).toVar()];
    const count = int(taps.ceil()).toVar();
    const cells = count.add(1).mul(count.add(1));
    Loop({ start: int(0), end: cells, type: 'int', condition: '<' }, ({ i }: { i: Int }) => {
      const row = i.div(count.add(1)).toVar();
      const column = i.sub(row.mul(count.add(1)));
      const cell = first.add(vec2(float(column), float(row))).toVar();
      const covered = min(cell.add(1), low.add(taps)).sub(max(cell, low)).toVar();
      const weight = max(covered.x, 0).mul(max(covered.y, 0)).toVar();
      const read = this.reader(at, floor(cell.add(0.5).mul(stride)));
      If(weight.greaterThan(0).and(isSame(read('object').x, object)), () => {
        sum.addAssign(read('base').rgb.mul(weight));
        weights.addAssign(weight);
        const emission = read('emissive').toVar();
        If(isPlain(emission), () => {
          glow.addAssign(emission.rgb.mul(weight));
          glowing.addAssign(weight);
        });
      });
    });
    const color = select(weights.greaterThan(0), sum.div(max(weights, 1e-6)), base.rgb);
    const isMean = isPlain(emissive).and(glowing.greaterThan(0));
    const emission = select(isMean, glow.div(max(glowing, 1e-6)), emissive.rgb);
    return { base: vec4(color, base.w), emissive: vec4(emission, emissive.w) };
  }

  /** Reads a texel of a face; beyond its sides the last ones. */
  private reader({ corner }: AtlasPlace, texel: Vec2): TexelReader {
    const at = ivec2(corner.add(clamp(texel, vec2(0), vec2(this.side.sub(1))))).toVar();
    return (name) => textureLoad(this.atlas.texture(name), at);
  }
}

type TexelReader = (name: TargetName) => Vec4;

const isSame = (a: Float, b: Float): Bool => abs(a.sub(b)).lessThan(0.5);

const NEIGHBOURS = [
  [0, 0],
  [1, 0],
  [0, 1],
  [1, 1],
] as const;

/** One of the four nearest texels, with its bilinear weight. */
interface Neighbour {
  readonly texel: Vec2;
  readonly weight: Float;
  readonly object: Float;
  /** (Δx, cΔt) from the observer's event at the capture */
  readonly event: Vec4;
  readonly velocity: Vec3;
  readonly gamma: Float;
  /** In its rest frame. */
  readonly normal: Vec3;
  readonly invisible: Vec2;
}

/** Sine of the greatest angle between a surface and the way to a neighbour on it: beyond it there is an edge, or nothing, between them. */
const SMOOTH = 0.5;

/** Whether the way from `a` to `b`, at rest with `a`, runs along its surface. */
function leadsAlong(a: Neighbour, b: Neighbour): Bool {
  const way = boost(b.event.sub(a.event), a.velocity.mul(a.gamma), a.gamma).xyz.toVar();
  return abs(dot(way, a.normal)).lessThanEqual(length(way).mul(SMOOTH));
}

/** The texel that stands for the surface with the greatest weight, the nearest of those that show it; `among`: 1 for each of these. */
function shownSurface(neighbours: readonly Neighbour[]): { texel: Vec2; among: readonly Float[] } {
  const alike = neighbours.map((a, i) =>
    neighbours.map((b, j) => {
      if (j <= i) return float(i === j ? 1 : 0);
      const isOne = isSame(a.object, b.object).and(leadsAlong(a, b)).and(leadsAlong(b, a));
      return select(isOne, float(1), float(0)).toVar();
    }),
  );
  const rows = neighbours.map((_, i) => neighbours.map((__, j) => alike[Math.min(i, j)]![Math.max(i, j)]!));
  const best = float(-1).toVar();
  const texel = vec2(0).toVar();
  const among = neighbours.map(() => float(0).toVar());
  for (const [i, row] of rows.entries()) {
    const weights = row.map((one, j) => one.mul(neighbours[j]!.weight));
    const support = weights.reduce((sum, weight) => sum.add(weight));
    const score = support.add(neighbours[i]!.weight.mul(OWN_WEIGHT)).toVar();
    If(score.greaterThan(best), () => {
      best.assign(score);
      texel.assign(neighbours[i]!.texel);
      for (const [j, one] of row.entries()) among[j]!.assign(one);
    });
  }
  return { texel, among };
}
/** Decides between texels of one surface only. */
const OWN_WEIGHT = 1e-3;

/** Sums over the texels of a surface, weighted linearly. `nearness`: 1/depth [1/m]. */
function interpolated(neighbours: readonly Neighbour[], among: readonly Float[], forward: Vec3) {
  const sums = {
    weight: float(0).toVar(),
    nearness: float(0).toVar(),
    velocity: vec3(0).toVar(),
    normal: vec3(0).toVar(),
    invisible: vec2(0).toVar(),
  };
  for (const [i, { weight: bilinear, event, velocity, normal, invisible }] of neighbours.entries()) {
    const weight = bilinear.mul(among[i]!).toVar();
    If(weight.greaterThan(0), () => {
      sums.weight.addAssign(weight);
      sums.nearness.addAssign(weight.div(max(dot(event.xyz, forward), 1e-20)));
      sums.velocity.addAssign(velocity.mul(weight));
      sums.normal.addAssign(normal.mul(weight));
      sums.invisible.addAssign(invisible.mul(weight));
    });
  }
  return sums;
}

/** Whether an emission is a colour, and not a code (`packEmission`). */
const isPlain = ({ x, y, z }: Vec4): Bool => min(x, min(y, z)).greaterThanEqual(0);
