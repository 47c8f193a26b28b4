import { float, int, ivec2, texture, uniform, vec2 } from 'three/tsl';
import {
  ClampToEdgeWrapping,
  DataTexture,
  HalfFloatType,
  LinearFilter,
  RGBAFormat,
  type TextureNode,
  Vector2,
} from 'three/webgpu';
import type { Float, Int, Vec4 } from '../types.ts';

/** Rows of RGBA half floats, `width` texels each. */
export interface HalfTexels {
  /** 4 halves per texel, row after row. */
  readonly data: Uint16Array;
  /** Texels of a row. */
  readonly width: number;
}

/** A table of the atlas in a shader. */
export interface HalfTable {
  /** Bilinear sample; (0.5, 0.5) is the centre of the first texel. Coordinates must stay within the centres of the outermost texels, because other tables adjoin. */
  sampleLinear(x: Float, y: Float): Vec4;
  /** The texel at an index that counts row after row. */
  load(index: Int): Vec4;
}

/** Position of a table in the atlas [texels]. */
interface AtlasRegion {
  readonly x: number;
  readonly y: number;
}

/** A row of tables side by side, as high as the first of them. */
interface Shelf {
  readonly y: number;
  readonly height: number;
  used: number;
}

/** Width of the texture, and of the widest table [texels]. */
const ATLAS_WIDTH = 512;

/**
 * All half-float tables of a scene in one texture, because a device may allow only 16 per shader. Tables are created lazily, also while a
 * shader that reads them is being built.
 */
export class HalfAtlas {
  private readonly shelves: Shelf[] = [];
  private readonly tables = new Map<string, HalfTable & { readonly place: AtlasRegion }>();
  private texture = makeTexture(new Uint16Array(4 * ATLAS_WIDTH), 1);
  private readonly node: TextureNode<'vec4'> = texture(this.texture);
  /** 1/(width, height) */
  private readonly scale = uniform(new Vector2(1 / ATLAS_WIDTH, 1));

  /** The table of this name, created on first use; at most `ATLAS_WIDTH` wide. */
  table(name: string, make: () => HalfTexels): HalfTable {
    const table = this.tables.get(name) ?? this.add(make());
    this.tables.set(name, table);
    return table;
  }

  /** Gives a table other texels, as many as it has; nothing if there is no such table. */
  replace(name: string, texels: HalfTexels): void {
    const table = this.tables.get(name);
    if (table) this.write(table.place, texels);
  }

  dispose(): void {
    this.texture.dispose();
  }

  private add(texels: HalfTexels): HalfTable & { readonly place: AtlasRegion } {
    const { data, width } = texels;
    const place = this.reserve(width, data.length / (4 * width));
    this.write(place, texels);
    return { ...this.reader(place, width), place };
  }

  private write(place: AtlasRegion, { data, width }: HalfTexels): void {
    const height = data.length / (4 * width);
    const all = this.texture.image.data as Uint16Array;
    for (let row = 0; row < height; row++)
      all.set(data.subarray(4 * width * row, 4 * width * (row + 1)), 4 * (ATLAS_WIDTH * (place.y + row) + place.x));
    this.texture.needsUpdate = true;
  }

  private reader({ x: left, y: top }: AtlasRegion, width: number): HalfTable {
    const read = (texel: TextureNode<'vec4'>): Vec4 => {
      // Otherwise three multiplies coordinates by the texture's matrix at every fetch.
      texel.updateMatrix = false;
      return texel.toVar();
    };
    return {
      // An explicit level, because neighbouring fragments may not execute this fetch.
      sampleLinear: (x, y) => read(this.node.sample(vec2(x.add(left), y.add(top)).mul(this.scale)).level(float(0))),
      load: (index) => {
        const row = index.div(int(width)).toVar();
        return read(this.node.load(ivec2(index.sub(row.mul(int(width))).add(int(left)), row.add(int(top)))));
      },
    };
  }

  /** Reserves a region on the first shelf with room, or on a new one. */
  private reserve(width: number, height: number): AtlasRegion {
    let shelf = this.shelves.find((each) => each.height >= height && each.used + width <= ATLAS_WIDTH);
    if (!shelf) {
      const last = this.shelves.at(-1);
      shelf = { y: last ? last.y + last.height : 0, height, used: 0 };
      this.shelves.push(shelf);
      this.grow(shelf.y + height);
    }
    const place = { x: shelf.used, y: shelf.y };
    shelf.used += width;
    return place;
  }

  private grow(height: number): void {
    const all = new Uint16Array(4 * ATLAS_WIDTH * height);
    all.set(this.texture.image.data as Uint16Array);
    this.texture.dispose();
    this.texture = makeTexture(all, height);
    this.node.value = this.texture;
    this.scale.value.set(1 / ATLAS_WIDTH, 1 / height);
  }
}

function makeTexture(data: Uint16Array<ArrayBuffer>, height: number): DataTexture {
  const made = new DataTexture(data, ATLAS_WIDTH, height, RGBAFormat, HalfFloatType);
  made.minFilter = LinearFilter;
  made.magFilter = LinearFilter;
  made.wrapS = ClampToEdgeWrapping;
  made.wrapT = ClampToEdgeWrapping;
  made.generateMipmaps = false;
  made.needsUpdate = true;
  return made;
}
