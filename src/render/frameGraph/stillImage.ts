import {
  abs,
  ceil,
  Fn,
  float,
  floor,
  If,
  ivec2,
  Loop,
  max,
  min,
  screenCoordinate,
  texture,
  uniform,
  vec2,
  vec4,
} from 'three/tsl';
import {
  DataTexture,
  FloatType,
  NearestFilter,
  NoColorSpace,
  RGBAFormat,
  type TextureNode,
  Vector2,
  type WebGPURenderer,
} from 'three/webgpu';
import { fitStill, type StillPixels } from '../../scene/frameGraph/still.ts';
import type { Float, Int, Vec4 } from '../../shaders/types.ts';
import { dataTarget } from '../gbuffer/gbuffer.ts';
import { FullScreenPass } from '../gpu/fullScreenPass.ts';
import { IMAGE_RANGE } from '../gpu/lightRange.ts';

/** A still fitted into the picture. It is resampled into a target of its own only when the still or the picture's size changes. */
export class StillImage {
  readonly target = dataTarget(1, IMAGE_RANGE.type);
  private image: DataTexture;
  private readonly texels: TextureNode<'vec4'>;
  private readonly size = uniform(new Vector2());
  private readonly offset = uniform(new Vector2());
  private readonly scale = uniform(1);
  private readonly reach = uniform(1);
  private readonly pass: FullScreenPass;
  /** Key of the still that `image` holds. */
  private uploadedKey: string;
  /** Key of the still that `target` holds; empty if it must be drawn. */
  private drawnKey = '';

  constructor(still: StillPixels) {
    this.image = upload(still);
    this.uploadedKey = still.key;
    this.texels = texture(this.image);
    this.pass = new FullScreenPass(Fn(() => this.resampled())(), 'still');
  }

  setSize(width: number, height: number): void {
    this.target.setSize(width, height);
    this.drawnKey = '';
  }

  /** Draws the target if it is out of date. */
  update(renderer: WebGPURenderer, still: StillPixels): void {
    if (this.drawnKey === still.key) return;
    if (this.uploadedKey !== still.key) {
      this.image.dispose();
      this.image = upload(still);
      this.texels.value = this.image;
      this.uploadedKey = still.key;
    }
    const { width, height } = this.target;
    const { scale, reach, offset } = fitStill(still, width, height);
    this.size.value.set(still.width, still.height);
    this.offset.value.set(...offset);
    this.scale.value = scale;
    this.reach.value = reach;
    this.pass.render(renderer, this.target);
    this.drawnKey = still.key;
  }

  dispose(): void {
    this.pass.dispose();
    this.image.dispose();
    this.target.dispose();
  }

  /** As `stillImage` of reference/post/still.ts. */
  private resampled(): Vec4 {
    const place = floor(screenCoordinate).mul(this.scale).add(this.offset).toVar();
    const first = ivec2(max(ceil(place.sub(this.reach)), vec2(0))).toVar();
    const last = ivec2(min(floor(place.add(this.reach)), this.size.sub(1))).toVar();
    const weight = (pixel: Int, at: Float): Float => abs(float(pixel).sub(at)).div(this.reach).oneMinus();
    const sum = vec4(0).toVar();
    const total = float(0).toVar();
    const outside = place.x.lessThan(-0.5).or(place.x.greaterThan(this.size.x.sub(0.5)));
    If(outside.not(), () => {
      Loop({ start: first.y, end: last.y, type: 'int', condition: '<=' }, ({ i }: { i: Int }) => {
        // Nested loops use the same variable name.
        const row = i.toVar();
        const rowWeight = weight(row, place.y).toVar();
        Loop({ start: first.x, end: last.x, type: 'int', condition: '<=' }, ({ i: column }: { i: Int }) => {
          const product = weight(column, place.x).mul(rowWeight).toVar();
          sum.addAssign(this.texel(column, row).mul(product));
          total.addAssign(product);
        });
      });
    });
    return vec4(sum.rgb.div(max(total, 1e-6)), 1);
  }

  private texel(column: Int, row: Int): Vec4 {
    const texel = this.texels.load(ivec2(column, row));
    // Otherwise three.js multiplies the integer coordinates by the texture's matrix.
    texel.updateMatrix = false;
    return texel;
  }
}

/** Linear light as 32-bit floats, like all images of a frame graph. */
function upload({ width, height, pixels }: StillPixels): DataTexture {
  const data = new Float32Array(4 * width * height).fill(1);
  for (let i = 0; i < width * height; i++) data.set(pixels.subarray(3 * i, 3 * i + 3), 4 * i);
  const image = new DataTexture(data, width, height, RGBAFormat, FloatType);
  image.minFilter = NearestFilter;
  image.magFilter = NearestFilter;
  image.generateMipmaps = false;
  image.colorSpace = NoColorSpace;
  image.needsUpdate = true;
  return image;
}
