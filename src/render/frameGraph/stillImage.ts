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
  HalfFloatType,
  NearestFilter,
  NoColorSpace,
  RGBAFormat,
  type TextureNode,
  Vector2,
  type WebGPURenderer,
} from 'three/webgpu';
import { toHalf } from '../../math/half.ts';
import { fitStill, type StillPixels } from '../../scene/frameGraph/still.ts';
import type { Float, Int, Vec4 } from '../../shaders/types.ts';
import { dataTarget } from '../gbuffer/gbuffer.ts';
import { FullScreenPass } from '../gpu/fullScreenPass.ts';

/** The largest half float. */
const MAX_HALF = 65504;

/** A still as it lies in a picture: drawn into a target of its own when it or the picture's size is another, not with every frame. */
export class StillImage {
  readonly target = dataTarget(1, HalfFloatType);
  private image: DataTexture;
  private readonly texels: TextureNode<'vec4'>;
  private readonly size = uniform(new Vector2());
  private readonly offset = uniform(new Vector2());
  private readonly scale = uniform(1);
  private readonly reach = uniform(1);
  private readonly pass: FullScreenPass;
  /** Of what the image is. */
  private uploadedKey: string;
  /** Of what the target is; empty: nothing yet. */
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

  /** Brings the target up to date. */
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

  /** `fitted` of reference/post/still.ts. */
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
        // Loops within loops count with one name.
        const row = i.toVar();
        const high = weight(row, place.y).toVar();
        Loop({ start: first.x, end: last.x, type: 'int', condition: '<=' }, ({ i: column }: { i: Int }) => {
          const share = weight(column, place.x).mul(high).toVar();
          sum.addAssign(this.texel(column, row).mul(share));
          total.addAssign(share);
        });
      });
    });
    return vec4(sum.rgb.div(max(total, 1e-6)), 1);
  }

  private texel(column: Int, row: Int): Vec4 {
    const texel = this.texels.load(ivec2(column, row));
    // Else three multiplies the whole numbers by the texture's matrix.
    texel.updateMatrix = false;
    return texel;
  }
}

/** Light as half floats, as all images of a plan are. */
function upload({ width, height, pixels }: StillPixels): DataTexture {
  const data = new Uint16Array(4 * width * height);
  for (let i = 0; i < width * height; i++) {
    for (let k = 0; k < 3; k++) data[4 * i + k] = toHalf(Math.min(pixels[3 * i + k], MAX_HALF));
    data[4 * i + 3] = toHalf(1);
  }
  const made = new DataTexture(data, width, height, RGBAFormat, HalfFloatType);
  made.minFilter = NearestFilter;
  made.magFilter = NearestFilter;
  made.generateMipmaps = false;
  made.colorSpace = NoColorSpace;
  made.needsUpdate = true;
  return made;
}
