import { decodeSrgb } from '../../spectrum/display/srgb.ts';
import {
  type GrowableFloats,
  type GrowableIntegers,
  growableFloats,
  growableIntegers,
} from '../files/growableArray.ts';
import { MAX_CORNERS } from '../read/meshScene.ts';
import { lineError, numberOf, type ObjStatement } from './context.ts';

/** Most objects and groups, and most materials, of one file. */
export const MAX_PARTS = 2 ** 16;
/** The smoothing group of faces that are flat. */
export const FLAT = 0;

/** Faces that are shown as one object. */
export interface ObjPart {
  readonly name: string;
  /** Corners per face. */
  readonly counts: GrowableIntegers;
  /** Three for each corner: its point, uv and normal, from 0; −1 where it has none. */
  readonly corners: GrowableIntegers;
  /** Smoothing group of each face; 0: flat. */
  readonly smoothing: GrowableIntegers;
  /** Place in `ObjGeometry.materials` for each face. */
  readonly materials: GrowableIntegers;
}

/** The kinds of number triples in a file. */
type ObjAttribute = 'point' | 'uv' | 'normal';

/** What a corner names, in words. */
const NAMED: Readonly<Record<ObjAttribute, (index: number | string) => string>> = {
  point: (index) => `point ${index}`,
  uv: (index) => `uv ${index}`,
  normal: (index) => `normal ${index}`,
};

/** The place of the next slash; the end where there is none. */
function slashOf(word: string, from: number): number {
  const at = word.indexOf('/', from);
  return at < 0 ? word.length : at;
}

/** All that an .obj says of its shapes, line by line. */
export class ObjGeometry {
  readonly file: string;
  /** 3 per point. */
  readonly points: GrowableFloats = growableFloats();
  /** As written, 3 per point, up to the last point that has a colour. */
  readonly colors: GrowableFloats = growableFloats();
  /** 2 per uv. */
  readonly uvs: GrowableFloats = growableFloats();
  /** 3 per normal. */
  readonly normals: GrowableFloats = growableFloats();
  private readonly materialIndices = new Map<string, number>();
  private readonly partsByKey = new Map<string, ObjPart>();
  private readonly highest = {
    point: { index: -1, line: 0 },
    uv: { index: -1, line: 0 },
    normal: { index: -1, line: 0 },
  };
  private brightest = 0;
  private object = '';
  private group = '';
  private smoothing = FLAT;
  private material = '';
  private part: ObjPart | undefined;
  constructor(file: string) {
    this.file = file;
  }

  /** Names in the order in which faces ask for them; empty for those that ask for none. */
  get materials(): readonly string[] {
    return [...this.materialIndices.keys()];
  }

  get parts(): readonly ObjPart[] {
    return [...this.partsByKey.values()];
  }

  /** `v x y z [w]` or `v x y z r g b`. */
  addPoint({ line, words }: ObjStatement): void {
    const at = (k: number): number => numberOf(this.file, line, words[k]);
    this.points.push(at(0), at(1), at(2));
    if (words.length < 6) return;
    // What came before without a colour is white.
    while (this.colors.length < this.points.length - 3) this.colors.push(1, 1, 1);
    const color = [at(words.length - 3), at(words.length - 2), at(words.length - 1)];
    this.colors.push(color[0], color[1], color[2]);
    this.brightest = Math.max(this.brightest, ...color);
  }

  /** A colour of a point in linear light. Most programs write 0 … 1 in sRGB; what goes beyond is taken as 0 … 255. */
  linear(value: number): number {
    return decodeSrgb(Math.max(0, this.brightest > 1 ? value / 255 : value));
  }

  addUv({ line, words }: ObjStatement): void {
    const v = words.length > 1 ? numberOf(this.file, line, words[1]) : 0;
    this.uvs.push(numberOf(this.file, line, words[0]), v);
  }

  addNormal({ line, words }: ObjStatement): void {
    const at = (k: number): number => numberOf(this.file, line, words[k]);
    this.normals.push(at(0), at(1), at(2));
  }

  setObject(name: string): void {
    this.object = name;
    this.group = '';
    this.part = undefined;
  }

  setGroup(name: string): void {
    this.group = name;
    this.part = undefined;
  }

  setMaterial(name: string): void {
    this.material = name;
  }

  /** `s 1`, `s off`. */
  setSmoothing({ line, words }: ObjStatement): void {
    this.smoothing = words[0] === 'off' ? FLAT : numberOf(this.file, line, words[0]) | 0;
  }

  /** `f 1/2/3 4//5 −1 …` */
  addFace({ line, words }: ObjStatement): void {
    if (words.length < 3 || words.length > MAX_CORNERS) {
      const message = `a face has ${words.length} corners; from 3 to ${MAX_CORNERS} are read`;
      throw lineError(this.file, line, 'obj.face', message);
    }
    const part = this.partFor(line);
    part.counts.push(words.length);
    part.smoothing.push(this.smoothing);
    part.materials.push(this.materialPlace(line));
    for (const word of words) this.addCorner(part, line, word);
  }

  private materialPlace(line: number): number {
    const known = this.materialIndices.get(this.material);
    if (known !== undefined) return known;
    if (this.materialIndices.size >= MAX_PARTS)
      throw lineError(this.file, line, 'obj.too-many', `there are more than ${MAX_PARTS} materials`);
    this.materialIndices.set(this.material, this.materialIndices.size);
    return this.materialIndices.size - 1;
  }

  private addCorner(part: ObjPart, line: number, word: string): void {
    // A list of the three for each corner would take twice as long.
    const first = slashOf(word, 0);
    const second = slashOf(word, first + 1);
    const point = word.slice(0, first);
    const uv = word.slice(first + 1, second);
    const normal = word.slice(second + 1);
    part.corners.push(
      this.place('point', line, word, point, this.points.length / 3),
      uv ? this.place('uv', line, word, uv, this.uvs.length / 2) : -1,
      normal ? this.place('normal', line, word, normal, this.normals.length / 3) : -1,
    );
  }

  /** An index counts from 1, or back from the last one so far. */
  private place(list: ObjAttribute, line: number, word: string, text: string, count: number): number {
    const index = Number(text);
    const place = index < 0 ? count + index : index - 1;
    if (!Number.isInteger(index) || index === 0 || place < 0 || place >= 2 ** 31) {
      const message = `the corner ${word} names ${NAMED[list](text || '(none)')}; indices count from 1, or back from −1, and there are ${count} so far`;
      throw lineError(this.file, line, 'obj.index', message);
    }
    // What is named may stand further down in the file.
    const highest = this.highest[list];
    if (place > highest.index) {
      highest.index = place;
      highest.line = line;
    }
    return place;
  }

  /** Throws where a face named a point, uv or normal that never came. */
  checkIndices(): void {
    const counts = { point: this.points.length / 3, uv: this.uvs.length / 2, normal: this.normals.length / 3 };
    for (const list of ['point', 'uv', 'normal'] as const) {
      const { index, line } = this.highest[list];
      if (index < counts[list]) continue;
      const message = `a face names ${NAMED[list](index + 1)} of ${counts[list]}; the file is cut off or damaged, export it again`;
      throw lineError(this.file, line, 'obj.index', message);
    }
  }

  private partFor(line: number): ObjPart {
    if (this.part) return this.part;
    const name = [this.object, this.group].filter((part) => part !== '').join('_');
    const known = this.partsByKey.get(name);
    if (!known && this.partsByKey.size >= MAX_PARTS) {
      throw lineError(
        this.file,
        line,
        'obj.too-many',
        `there are more than ${MAX_PARTS} objects and groups; join some`,
      );
    }
    this.part = known ?? {
      name,
      counts: growableIntegers(),
      corners: growableIntegers(),
      smoothing: growableIntegers(),
      materials: growableIntegers(),
    };
    this.partsByKey.set(name, this.part);
    return this.part;
  }
}
