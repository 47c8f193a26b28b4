import { int, ivec2, texture } from 'three/tsl';
import {
  DataTexture,
  FloatType,
  NearestFilter,
  type Node,
  RGBAFormat,
  type TextureNode,
  Vector3,
  type WebGPURenderer,
} from 'three/webgpu';

/** Texels of four floats, as shaders read them. */
export interface Texels {
  texel(index: Node<'int'>): Node<'vec4'>;
}

/** Texels of a table that belong together. */
export interface TablePart extends Texels {
  /** Place in the table. */
  readonly first: number;
  /** Writes from a texel of the part on; then call the table's `upload`. */
  set(values: readonly number[], texel: number): void;
}

/** Texels of four floats in a texture of fixed width: read with `textureLoad`, which is the same on WebGPU and WebGL2. */
export class FloatTable implements Texels {
  private readonly widthBits: number;
  private readonly node: TextureNode<'vec4'>;
  private array: Float32Array<ArrayBuffer>;
  private texture: DataTexture;
  /** Texels of parts. */
  private taken = 0;

  /** `width`: a power of two. */
  constructor(width: number) {
    this.widthBits = Math.log2(width);
    this.array = new Float32Array(4 << this.widthBits);
    this.texture = makeTexture(this.array, width);
    this.node = texture(this.texture);
  }

  /** Four floats per texel; write here, then call `upload`. */
  get values(): Float32Array {
    return this.array;
  }
  get bytes(): number {
    return this.array.byteLength;
  }

  /** Makes room for so many texels; what was written before is kept. */
  reserve(texels: number): void {
    const rows = Math.max(1, Math.ceil(texels / (1 << this.widthBits)));
    if (rows <= this.texture.image.height) return;
    const grown = new Float32Array(4 * (nextPowerOfTwo(rows) << this.widthBits));
    grown.set(this.array);
    this.array = grown;
    this.replaceTexture(makeTexture(grown, 1 << this.widthBits));
  }

  /** So many texels more, for one thing: a shader has no more than 16 textures, so that not each thing can have its own. */
  part(texels: number): TablePart {
    const first = this.taken;
    this.taken += texels;
    this.reserve(this.taken);
    return {
      first,
      texel: (index) => this.texel(index.add(int(first))),
      set: (values, texel) => {
        this.array.set(values, 4 * (first + texel));
      },
    };
  }

  /** Takes an array as it is, `4 · width` floats per row. */
  adopt(array: Float32Array<ArrayBuffer>): void {
    this.array = array;
    this.replaceTexture(makeTexture(array, 1 << this.widthBits));
  }

  upload(): void {
    this.texture.needsUpdate = true;
  }

  /** From now on the table is so many rows on the GPU alone, nothing in them yet, to be filled with `writeRows`. */
  allocateOnGpu(rows: number): void {
    const made = makeTexture(null, 1 << this.widthBits, rows);
    // Room is made for it, and nothing is copied there.
    made.source.dataReady = false;
    this.array = new Float32Array(0);
    this.replaceTexture(made);
  }

  /** Copies whole rows, as `values` has them, to the GPU, from row `first` on. `by` may be used again for as many rows. */
  writeRows(renderer: WebGPURenderer, first: number, rows: Float32Array<ArrayBuffer>, by = new RowUploader()): void {
    renderer.copyTextureToTexture(by.texture(rows, 1 << this.widthBits), this.texture, null, new Vector3(0, first, 0));
  }

  texel(index: Node<'int'>): Node<'vec4'> {
    const mask = int((1 << this.widthBits) - 1);
    const texel = this.node.load(ivec2(index.bitAnd(mask), index.shiftRight(int(this.widthBits))));
    // Else three multiplies the whole numbers by the texture's matrix at every fetch.
    texel.updateMatrix = false;
    return texel;
  }

  dispose(): void {
    this.texture.dispose();
  }

  private replaceTexture(made: DataTexture): void {
    this.texture.dispose();
    this.texture = made;
    this.node.value = made;
  }
}

/** The texture by which rows come to a table; made once for rows of one number. */
export class RowUploader {
  private made: DataTexture | undefined;

  texture(rows: Float32Array<ArrayBuffer>, width: number): DataTexture {
    this.made ??= makeTexture(rows, width);
    this.made.image.data = rows;
    this.made.needsUpdate = true;
    return this.made;
  }

  dispose(): void {
    this.made?.dispose();
  }
}

function makeTexture(array: Float32Array<ArrayBuffer> | null, width: number, rows?: number): DataTexture {
  const made = new DataTexture(array, width, rows ?? array!.length / (4 * width), RGBAFormat, FloatType);
  made.minFilter = NearestFilter;
  made.magFilter = NearestFilter;
  made.generateMipmaps = false;
  made.needsUpdate = true;
  return made;
}

const nextPowerOfTwo = (n: number): number => 2 ** Math.ceil(Math.log2(n));
