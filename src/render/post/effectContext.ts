import {
  floor,
  ivec2,
  max,
  min,
  mix,
  normalize,
  screenCoordinate,
  textureLoad,
  textureSize,
  vec2,
  vec3,
} from 'three/tsl';
import type { Node, Texture, UniformNode, Vector4 } from 'three/webgpu';
import { unaberrate } from '../../shaders/kinematics/unaberrate.ts';
import type { Bool, Float, Vec2, Vec3, Vec4 } from '../../shaders/types.ts';
import type { TargetName } from '../gbuffer/surface.ts';
import { unpackNormals } from '../gbuffer/surfacePacking.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';

/** Where the surfaces of a picture are told of: `GBufferSpec`, or what stands for one. */
export interface GBufferTextures {
  texture(name: TargetName): Texture;
}

/** What an effect is made of. */
export interface EffectSources {
  readonly image: Texture;
  /** Where an effect reads it (`EFFECTS[id].reads`). */
  readonly buffer?: GBufferTextures;
  readonly uniforms: FrameUniforms;
  readonly args: UniformNode<'vec4', Vector4>;
  /** World time of the observer [s]. */
  readonly time: UniformNode<'float', number>;
}

/** A picture that is read texel by texel, by whole numbers from its top left corner; beyond its edges, its mirror image. */
export class EffectImage {
  readonly size: Vec2;
  private readonly texture: Texture;

  constructor(texture: Texture) {
    this.texture = texture;
    this.size = vec2(sizeOf(texture));
  }

  at(pixel: Vec2): Vec4 {
    return textureLoad(this.texture, ivec2(mirrored(pixel, this.size)));
  }
}

/** Its type does not tell what it is. */
const sizeOf = (texture: Texture) => textureSize(textureLoad(texture)) as unknown as Node<'ivec2'>;

/** `mirrored` of reference/post/effects/effectInput.ts, both ways: … 1 0 | 0 1 … n−1 | n−1 n−2 … */
function mirrored(pixel: Vec2, size: Vec2): Vec2 {
  const once = max(pixel, pixel.negate().sub(1));
  const twice = min(once, size.mul(2).sub(1).sub(once));
  return max(min(twice, size.sub(1)), vec2(0));
}

/** (1 − s) a + s b: exactly either of them at the ends, however much brighter the other is. */
export const mixExact = (a: Vec4, b: Vec4, share: Float): Vec4 => a.mul(share.oneMinus()).add(b.mul(share));

/** What an effect reads while it works on a pixel: as `GBufferReader` of reference/post/effects. Used within a shader function. */
export class EffectContext {
  readonly image: EffectImage;
  /** Of the target that is written. */
  readonly pixel: Vec2 = floor(screenCoordinate);
  readonly uniforms: FrameUniforms;
  private readonly sources: EffectSources;
  private readonly steps: ReadonlyMap<string, Texture>;
  private readonly images = new Map<Texture, EffectImage>();

  constructor(sources: EffectSources, steps: ReadonlyMap<string, Texture>) {
    this.sources = sources;
    this.steps = steps;
    this.uniforms = sources.uniforms;
    this.image = this.imageOf(sources.image);
  }

  get args(): readonly [Float, Float, Float, Float] {
    const { x, y, z, w } = this.sources.args;
    return [x, y, z, w];
  }

  get time(): Float {
    return this.sources.time;
  }

  /** What an earlier step has made. */
  stepImage(name: string): EffectImage {
    const texture = this.steps.get(name);
    if (!texture) throw new Error(`no step ${name} has gone before`);
    return this.imageOf(texture);
  }

  hasSurface(pixel: Vec2): Bool {
    return this.surface('object', pixel).x.greaterThan(0.5);
  }

  /** (whether anything is there: 1 or 0, apparent distance |Δx′| [m]) */
  depth(pixel: Vec2): Vec2 {
    const { x, y } = this.surface('object', pixel).toVar();
    return vec2(min(x, 1), y);
  }

  normal(pixel: Vec2): Vec3 {
    return unpackNormals(this.surface('normal', pixel)).normal;
  }

  /** Observer → event, world frame [m]. */
  event(pixel: Vec2): Vec3 {
    return this.surface('event', pixel).xyz;
  }

  /** Where this pixel looks in the world: unit, world frame. */
  direction(): Vec3 {
    const { u, gamma, boosted, orientation } = this.uniforms;
    const nPrime = normalize(orientation.mul(vec3(this.tangents(this.pixel), -1))).toVar();
    return normalize(mix(nPrime, unaberrate(nPrime, u, gamma), boosted));
  }

  /** tan of the angles off the axis, to the right and up, of a pixel of the picture. */
  tangents(pixel: Vec2): Vec2 {
    const across = pixel.add(0.5).div(this.image.size).mul(2).sub(1);
    const { halfTangents, frustumCenter } = this.uniforms;
    return vec2(across.x, across.y.negate()).mul(halfTangents).add(frustumCenter);
  }

  /** World time of the event after the observer's [s]. */
  emissionTime(pixel: Vec2): Float {
    return this.surface('event', pixel).w.mul(this.uniforms.secondsPerMetre);
  }

  /** (velocity of the surface, world frame, units of c; D) */
  motion(pixel: Vec2): Vec4 {
    return this.surface('motion', pixel);
  }

  object(pixel: Vec2): Float {
    return this.surface('object', pixel).x;
  }

  private surface(name: TargetName, pixel: Vec2): Vec4 {
    const { buffer } = this.sources;
    if (!buffer) throw new Error(`this effect reads the surfaces' ${name}, and was given none`);
    return this.imageOf(buffer.texture(name)).at(pixel);
  }

  private imageOf(texture: Texture): EffectImage {
    const picture = this.images.get(texture) ?? new EffectImage(texture);
    this.images.set(texture, picture);
    return picture;
  }
}
