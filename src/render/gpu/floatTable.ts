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

/** A range of a table's texels. */
export interface TablePart extends Texels {
  /** Index of its first texel in the table. */
  readonly first: number;
  /** Writes from a texel of the part on; call the table's `upload` afterwards. */
  set(values: readonly number[], texel: number): void;
}

/** Texels of four floats in a texture of fixed width, read with `textureLoad`, which behaves the same on WebGPU and WebGL2. */
export class FloatTable implements Texels {
  private readonly widthBits: number;
  private readonly node: TextureNode<'vec4'>;
  private array: Float32Array<ArrayBuffer>;
  private texture: DataTexture;
  /** Texels that parts occupy. */
  private used = 0;

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

  /** Grows the table to at least this number of texels; keeps its contents. */
  reserve(texels: number): void {
    const rows = Math.max(1, Math.ceil(texels / (1 << this.widthBits)));
    if (rows <= this.texture.image.height) return;
    const grown = new Float32Array(4 * (nextPowerOfTwo(rows) << this.widthBits));
    grown.set(this.array);
    this.array = grown;
    this.replaceTexture(makeTexture(grown, 1 << this.widthBits));
  }

  /** Allocates this number of texels for one purpose: a shader has at most 16 textures, so not everything can have a table of its own. */
  part(texels: number): TablePart {
    const first = this.used;
    this.used += texels;
    this.reserve(this.used);
    return {
      first,
      texel: (index) => this.texel(index.add(int(first))),
      set: (values, texel) => {
        this.array.set(values, 4 * (first + texel));
      },
    };
  }

  /** Uses an array without copying it, `4 · width` floats per row. */
  adopt(array: Float32Array<ArrayBuffer>): void {
    this.array = array;
    this.replaceTexture(makeTexture(array, 1 << this.widthBits));
  }

  upload(): void {
    this.texture.needsUpdate = true;
  }

  /** Uploads some of the texels, as whole rows. */
  uploadTexels(renderer: WebGPURenderer, first: number, count: number): void {
    const width = 1 << this.widthBits;
    const [from, to] = [Math.floor(first / width), Math.ceil((first + count) / width)];
    if (to <= from) return;
    const uploader = new RowUploader();
    this.writeRows(renderer, from, this.array.subarray(4 * width * from, 4 * width * to), uploader);
    uploader.dispose();
  }

  /** Makes the table this number of rows that exist only on the GPU, with undefined contents, to be filled with `writeRows`. */
  allocateOnGpu(rows: number): void {
    const replacement = makeTexture(null, 1 << this.widthBits, rows);
    // Allocates the texture without copying anything into it.
    replacement.source.dataReady = false;
    this.array = new Float32Array(0);
    this.replaceTexture(replacement);
  }

  /** Copies whole rows to the GPU, from row `first` on. `uploader` can be reused for the same number of rows. */
  writeRows(
    renderer: WebGPURenderer,
    first: number,
    rows: Float32Array<ArrayBuffer>,
    uploader = new RowUploader(),
  ): void {
    renderer.copyTextureToTexture(
      uploader.texture(rows, 1 << this.widthBits),
      this.texture,
      null,
      new Vector3(0, first, 0),
    );
  }

  texel(index: Node<'int'>): Node<'vec4'> {
    const mask = int((1 << this.widthBits) - 1);
    const texel = this.node.load(ivec2(index.bitAnd(mask), index.shiftRight(int(this.widthBits))));
    // Otherwise three.js multiplies the integer coordinates by the texture's matrix at every fetch.
    texel.updateMatrix = false;
    return texel;
  }

  /** Frees the memory on the GPU; the next shader that reads the table uploads it again. */
  dispose(): void {
    this.texture.dispose();
  }

  private replaceTexture(replacement: DataTexture): void {
    this.texture.dispose();
    this.texture = replacement;
    this.node.value = replacement;
  }
}

/** The texture through which rows are copied to a table; created once for a fixed number of rows. */
export class RowUploader {
  private stagingTexture: DataTexture | undefined;

  texture(rows: Float32Array<ArrayBuffer>, width: number): DataTexture {
    this.stagingTexture ??= makeTexture(rows, width);
    this.stagingTexture.image.data = rows;
    this.stagingTexture.needsUpdate = true;
    return this.stagingTexture;
  }

  dispose(): void {
    this.stagingTexture?.dispose();
  }
}

function makeTexture(array: Float32Array<ArrayBuffer> | null, width: number, rows?: number): DataTexture {
  const dataTexture = new DataTexture(array, width, rows ?? array!.length / (4 * width), RGBAFormat, FloatType);
  dataTexture.minFilter = NearestFilter;
  dataTexture.magFilter = NearestFilter;
  dataTexture.generateMipmaps = false;
  dataTexture.needsUpdate = true;
  return dataTexture;
}

const nextPowerOfTwo = (n: number): number => 2 ** Math.ceil(Math.log2(n));
