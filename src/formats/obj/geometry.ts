import { type LocalizedText, type Message, msg } from '../../messages/message.ts';
import { decodeSrgb } from '../../spectrum/display/srgb.ts';
import type { DiagnosticLog } from '../diagnostics/diagnosticLog.ts';
import {
  type GrowableFloats,
  type GrowableIntegers,
  growableFloats,
  growableIntegers,
} from '../files/growableArray.ts';
import { MAX_CORNERS } from '../read/meshScene.ts';
import { lineError, numberOf, type ObjStatement } from './context.ts';

/** Maximum number of objects and groups, and of materials, per file. */
export const MAX_PARTS = 2 ** 16;
/** Smoothing group of flat faces. */
export const FLAT = 0;

/** The faces of one scene object. */
export interface ObjPart {
  readonly name: string;
  /** Corners per face. */
  readonly counts: GrowableIntegers;
  /** Per corner the indices of its point, uv and normal, from 0; −1 if absent. */
  readonly corners: GrowableIntegers;
  /** Smoothing group of each face; 0: flat. */
  readonly smoothing: GrowableIntegers;
  /** Index in `ObjGeometry.materials` per face. */
  readonly materials: GrowableIntegers;
}

/** Vertex attributes that corners refer to. */
type ObjAttribute = 'point' | 'uv' | 'normal';

/** An index in words, for messages. */
const NAMED: Readonly<Record<ObjAttribute, (index: number | LocalizedText) => Message>> = {
  point: (index) => msg`point ${index}`,
  uv: (index) => msg`uv ${index}`,
  normal: (index) => msg`normal ${index}`,
};

/** Position of the next slash, or the length. */
function slashOf(word: string, from: number): number {
  const at = word.indexOf('/', from);
  return at < 0 ? word.length : at;
}

/** Collects the geometry statements of an .obj. */
export class ObjGeometry {
  readonly file: string;
  /** 3 per point. */
  readonly points: GrowableFloats = growableFloats();
  /** As authored, 3 per point, up to the last point that has a colour. */
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

  /** Material names in order of first use by a face; the empty string for faces without `usemtl`. */
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
    // Earlier points without a colour are white.
    while (this.colors.length < this.points.length - 3) this.colors.push(1, 1, 1);
    const color = [at(words.length - 3), at(words.length - 2), at(words.length - 1)];
    this.colors.push(color[0], color[1], color[2]);
    this.brightest = Math.max(this.brightest, ...color);
  }

  /** Converts a point colour to linear light. Most programs write sRGB 0 … 1; if any value exceeds 1, all are 0 … 255. */
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
      const message = msg`a face has ${words.length} corners; from 3 to ${MAX_CORNERS} are read`;
      throw lineError(this.file, line, 'obj.face', message);
    }
    const part = this.partFor(line);
    part.counts.push(words.length);
    part.smoothing.push(this.smoothing);
    part.materials.push(this.materialIndex(line));
    for (const word of words) this.addCorner(part, line, word);
  }

  private materialIndex(line: number): number {
    const existing = this.materialIndices.get(this.material);
    if (existing !== undefined) return existing;
    if (this.materialIndices.size >= MAX_PARTS)
      throw lineError(this.file, line, 'obj.too-many', msg`there are more than ${MAX_PARTS} materials`);
    this.materialIndices.set(this.material, this.materialIndices.size);
    return this.materialIndices.size - 1;
  }

  private addCorner(part: ObjPart, line: number, word: string): void {
    // Not `split`, which takes twice as long.
    const first = slashOf(word, 0);
    const second = slashOf(word, first + 1);
    const point = word.slice(0, first);
    const uv = word.slice(first + 1, second);
    const normal = word.slice(second + 1);
    part.corners.push(
      this.indexOf('point', line, word, point, this.points.length / 3),
      uv ? this.indexOf('uv', line, word, uv, this.uvs.length / 2) : -1,
      normal ? this.indexOf('normal', line, word, normal, this.normals.length / 3) : -1,
    );
  }

  /** Index from 0 of an OBJ index, which counts from 1 or, if negative, backwards from the last element so far. */
  private indexOf(list: ObjAttribute, line: number, word: string, text: string, count: number): number {
    const written = Number(text);
    const index = written < 0 ? count + written : written - 1;
    if (!Number.isInteger(written) || written === 0 || index < 0 || index >= 2 ** 31) {
      const message = msg`the corner ${word} names ${NAMED[list](text || msg`(none)`)}; indices count from 1, or back from −1, and there are ${count} so far`;
      throw lineError(this.file, line, 'obj.index', message);
    }
    // Elements may be defined after the face; `checkIndices` verifies the highest.
    const highest = this.highest[list];
    if (index > highest.index) {
      highest.index = index;
      highest.line = line;
    }
    return index;
  }

  /** Throws if a face refers to a point that the file does not define; a uv or normal that it does not define is reported and taken as absent. */
  checkIndices(notes: DiagnosticLog): void {
    const { point, uv, normal } = this.highest;
    const count = this.points.length / 3;
    if (point.index >= count) {
      const message = msg`a face names ${NAMED.point(point.index + 1)} of ${count}; the file is cut off or damaged, export it again`;
      throw lineError(this.file, point.line, 'obj.index', message);
    }
    this.dropMissing(uv, 'uv', 1, this.uvs.length / 2, notes);
    this.dropMissing(normal, 'normal', 2, this.normals.length / 3, notes);
  }

  /** `place`: of the index among a corner's three. */
  private dropMissing(
    { index, line }: { readonly index: number; readonly line: number },
    list: ObjAttribute,
    place: number,
    count: number,
    notes: DiagnosticLog,
  ): void {
    if (index < count) return;
    let dropped = 0;
    for (const { corners } of this.partsByKey.values()) {
      const values = corners.values();
      for (let i = place; i < values.length; i += 3) {
        if (values[i] < count) continue;
        values[i] = -1;
        dropped++;
      }
    }
    const message = msg`a face names ${NAMED[list](index + 1)} of ${count}; corners that name one that is not there (${dropped}) are shown as without`;
    notes.add('warning', 'obj.missing-attribute', msg`line ${line}`, message);
  }

  private partFor(line: number): ObjPart {
    if (this.part) return this.part;
    const name = [this.object, this.group].filter((part) => part !== '').join('_');
    const existing = this.partsByKey.get(name);
    if (!existing && this.partsByKey.size >= MAX_PARTS) {
      throw lineError(
        this.file,
        line,
        'obj.too-many',
        msg`there are more than ${MAX_PARTS} objects and groups; join some`,
      );
    }
    this.part = existing ?? {
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
