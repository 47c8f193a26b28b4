import {
  abs,
  Discard,
  dot,
  Fn,
  floor,
  ivec2,
  max,
  mrt,
  property,
  screenCoordinate,
  screenSize,
  textureLoad,
  uniform,
  vec2,
} from 'three/tsl';
import { type Node, type RenderTarget, type Texture, Vector2, Vector3 } from 'three/webgpu';
import { frustumOf } from '../../scene/view/lenses/perspectiveLens.ts';
import type { PixelRect } from '../../scene/view/pictureViews.ts';
import type { DeferredPass } from '../deferredPass.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import type { PassCache } from '../gpu/passCache.ts';
import type { SamplePosition } from '../post/resolve/pixelSamples.ts';
import type { PictureFace } from './pictureFaces.ts';
import { isInPicture, panoramicDirection } from './pixelDirection.ts';

/** Share of a face's width by which neighbours overlap, so that rounding leaves no pixel between them. */
const OVERLAP = 1e-6;

/** Copies to the pixels of a picture what the faces show: each is that of the nearest sample of the face that its direction is on. Nothing is averaged. */
export class FaceGatherer {
  private readonly uniforms: FrameUniforms;
  private readonly passes: PassCache;
  /** On the camera's axes. */
  private readonly forward = uniform(new Vector3());
  private readonly right = uniform(new Vector3());
  private readonly up = uniform(new Vector3());
  /** Half the width and height of the face at distance 1. */
  private readonly halfTangents = uniform(new Vector2(1, 1));
  /** Its size [px]. */
  private readonly texels = uniform(new Vector2(1, 1));
  /** Of the sample within the face's pixels, right and down [px]. */
  private readonly position = uniform(new Vector2());
  /** The pixels that may show the face; absent: all. */
  private rect: PixelRect | undefined;

  constructor(uniforms: FrameUniforms, passes: PassCache) {
    this.uniforms = uniforms;
    this.passes = passes;
  }

  /** Sets the face that is gathered from; `position`: of its sample within the pixels. */
  setFace({ axes, lens, size, rect }: PictureFace, [dx, dy]: SamplePosition): void {
    const { forward, right, up } = axes;
    const { tanX, tanY } = frustumOf(lens, size.width, size.height);
    this.forward.value.set(...forward);
    this.right.value.set(...right);
    this.up.value.set(...up);
    this.halfTangents.value.set(tanX, tanY);
    this.texels.value.set(size.width, size.height);
    this.rect = rect;
    this.position.value.set(dx, dy);
  }

  /** Gathers the G-buffer and some of its lights. `over`: keeps what other faces have given. */
  gather(from: DeferredPass, to: DeferredPass, lights: readonly number[], over: boolean): void {
    to.buffer.passes.forEach(({ names, target }) => {
      this.run(
        names.map((name) => from.buffer.texture(name)),
        names,
        target,
        over,
      );
    });
    for (const light of lights) this.run([from.light(light).texture], undefined, to.light(light), over);
  }

  private run(
    textures: readonly Texture[],
    names: readonly string[] | undefined,
    target: RenderTarget,
    over: boolean,
  ): void {
    const key = `face ${textures[0].id} ${target.texture.id}`;
    const { rect } = this;
    this.passes.run(key, () => this.copied(textures, names), target, { over, ...(rect && { rect }) });
  }

  /** The texels of the face's textures that this pixel shows; nothing where it shows another face. */
  private copied(textures: readonly Texture[], names: readonly string[] | undefined): Node {
    const others = textures.slice(1).map((_, i) => property('vec4', `face_${i}`));
    const first = Fn(() => {
      const texel = this.texelHere().toVar();
      others.forEach((kept, i) => {
        kept.assign(textureLoad(textures[i + 1], texel));
      });
      return textureLoad(textures[0], texel);
    })();
    if (!names) return first;
    return mrt(Object.fromEntries(names.map((name, i) => [name, i === 0 ? first : others[i - 1]])));
  }

  private texelHere(): Node<'ivec2'> {
    const { forward, right, up, halfTangents, texels, position, uniforms } = this;
    const { jitter, lens } = uniforms;
    const down = screenCoordinate.div(screenSize).mul(2).sub(1).toVar();
    const place = vec2(down.x, down.y.negate()).add(jitter).toVar();
    Discard(isInPicture(place, lens).not());
    const n = panoramicDirection(place, lens).toVar();
    const depth = dot(n, forward).toVar();
    const aside = vec2(dot(n, right), dot(n, up)).div(halfTangents).toVar();
    Discard(depth.mul(1 + OVERLAP).lessThan(max(abs(aside.x), abs(aside.y))));
    const on = vec2(aside.x, aside.y.negate()).div(depth).add(1).mul(0.5).mul(texels).sub(position);
    return ivec2(floor(on).clamp(0, texels.sub(1)));
  }
}
