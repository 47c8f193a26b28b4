import { int, ivec2, texture } from 'three/tsl';
import { DataTexture, FloatType, NearestFilter, type Node, RGBAFormat, type TextureNode } from 'three/webgpu';

/** Texels of four floats in a texture of fixed width: read with `textureLoad`, which is the same on WebGPU and WebGL2. */
export class FloatTable {
  private readonly widthBits: number;
  private readonly node: TextureNode<'vec4'>;
  private array: Float32Array<ArrayBuffer>;
  private texture: DataTexture;

  /** `width`: a power of two. */
  constructor(width: number) {
    this.widthBits = Math.log2(width);
    this.array = new Float32Array(4 << this.widthBits);
    this.texture = this.makeTexture();
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
    this.replaceTexture();
  }

  /** Takes an array as it is, `4 · width` floats per row. */
  adopt(array: Float32Array<ArrayBuffer>): void {
    this.array = array;
    this.replaceTexture();
  }

  upload(): void {
    this.texture.needsUpdate = true;
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

  private replaceTexture(): void {
    this.texture.dispose();
    this.texture = this.makeTexture();
    this.node.value = this.texture;
  }

  private makeTexture(): DataTexture {
    const width = 1 << this.widthBits;
    const made = new DataTexture(this.array, width, this.array.length / (4 * width), RGBAFormat, FloatType);
    made.minFilter = NearestFilter;
    made.magFilter = NearestFilter;
    made.generateMipmaps = false;
    made.needsUpdate = true;
    return made;
  }
}

const nextPowerOfTwo = (n: number): number => 2 ** Math.ceil(Math.log2(n));
