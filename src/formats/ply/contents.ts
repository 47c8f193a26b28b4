import { type LocalizedText, type Message, msg } from '../../messages/message.ts';
import { decodeSrgb } from '../../spectrum/display/srgb.ts';
import { inputError } from '../diagnostics/inputError.ts';
import {
  type GrowableFloats,
  type GrowableIntegers,
  growableFloats,
  growableIntegers,
} from '../files/growableArray.ts';
import { MAX_CORNERS } from '../read/meshScene.ts';
import type { Element, PlyHeader, Property, ScalarType } from './header.ts';
import { minRowTypes, type PlyValueReader } from './valueReader.ts';

/** What a PLY holds of a mesh. Each value array has as many values as there are vertices, or faces. */
export interface PlyContents {
  readonly points: Float32Array;
  readonly normals?: Float32Array;
  readonly uvs?: Float32Array;
  /** Linear. */
  readonly colors?: Float32Array;
  readonly faceCounts: GrowableIntegers;
  readonly faceIndices: GrowableIntegers;
  /** 2 per corner; zeros where a face has none. */
  readonly cornerUvs?: GrowableFloats;
  /** Linear RGB per face. */
  readonly faceColors?: GrowableFloats;
}

const NAMES = {
  points: [['x', 'y', 'z']],
  normals: [
    ['nx', 'ny', 'nz'],
    ['normal_x', 'normal_y', 'normal_z'],
  ],
  uvs: [
    ['s', 't'],
    ['u', 'v'],
    ['texture_u', 'texture_v'],
    ['texture_s', 'texture_t'],
  ],
  colors: [
    ['red', 'green', 'blue'],
    ['r', 'g', 'b'],
    ['diffuse_red', 'diffuse_green', 'diffuse_blue'],
  ],
} as const;

/** Places among the properties of the first of these names that are all there. */
function placesOf({ properties }: Element, names: readonly (readonly string[])[]): number[] | undefined {
  const places = names.map((set) => set.map((name) => properties.findIndex((p) => p.name === name && !p.count)));
  return places.find((set) => set.every((place) => place >= 0));
}

const isIndices = ({ name, count }: Property): boolean => count !== undefined && /^vertex_ind(ices|ex)$/.test(name);

/** Reads all elements of a file, and keeps those that make a mesh. Throws an InputError that names byte or line and value. */
export function readContents(header: PlyHeader, values: PlyValueReader, entry: string): PlyContents {
  const vertices = header.elements.find(({ name }) => name === 'vertex');
  if (!vertices) throw inputError('ply.no-vertices', entry, msg`has no element vertex; it holds no mesh`);
  const reader = new ContentsReader(values, entry, vertices.rows);
  for (const element of header.elements) {
    if (element.properties.length === 0) continue;
    values.expect(() => msg`${element.rows} rows of ${element.name}`, element.rows, minRowTypes(element));
    if (element.name === 'vertex') reader.readVertices(element);
    else if (element.name === 'face') reader.readFaces(element);
    else if (element.name === 'tristrips') reader.readStrips(element);
    else
      for (let row = 0; row < element.rows; row++) {
        reader.skip(element.properties);
        values.endRow();
      }
  }
  return reader.contents();
}

class ContentsReader {
  private readonly values: PlyValueReader;
  private readonly entry: string;
  private readonly vertices: number;
  private readonly faceCounts = growableIntegers();
  private readonly faceIndices = growableIntegers();
  private perVertex: Omit<PlyContents, 'faceCounts' | 'faceIndices'> = { points: new Float32Array(0) };
  private cornerUvs: GrowableFloats | undefined;
  private faceColors: GrowableFloats | undefined;
  constructor(values: PlyValueReader, entry: string, vertices: number) {
    this.values = values;
    this.entry = entry;
    this.vertices = vertices;
  }

  contents(): PlyContents {
    return {
      ...this.perVertex,
      faceCounts: this.faceCounts,
      faceIndices: this.faceIndices,
      ...(this.cornerUvs && { cornerUvs: this.cornerUvs }),
      ...(this.faceColors && { faceColors: this.faceColors }),
    };
  }

  readVertices(element: Element): void {
    const { rows, properties } = element;
    const kinds = (['points', 'normals', 'uvs', 'colors'] as const).flatMap((kind) => {
      const places = placesOf(element, NAMES[kind]);
      return places ? [{ kind, places, values: new Float32Array(rows * places.length) }] : [];
    });
    if (kinds[0]?.kind !== 'points') throw this.error(msg`its vertices have no x, y and z`, this.entry);
    const row = new Float64Array(properties.length);
    for (let i = 0; i < rows; i++) {
      this.readRow(properties, row);
      this.values.endRow();
      for (const { kind, places, values } of kinds) {
        for (let k = 0; k < places.length; k++) {
          const { name, type } = properties[places[k]];
          const written = row[places[k]];
          values[i * places.length + k] = this.finite(
            kind === 'colors' ? linear(written, type) : written,
            name,
            'vertex',
            i,
          );
        }
      }
    }
    this.perVertex = Object.fromEntries(kinds.map(({ kind, values }) => [kind, values])) as unknown as PlyContents;
  }

  /** Scalars into `row`; lists are passed over. */
  private readRow(properties: readonly Property[], row: Float64Array): void {
    for (const [k, property] of properties.entries()) {
      if (property.count) this.skip([property]);
      else row[k] = this.values.next(property.type);
    }
  }

  skip(properties: readonly Property[]): void {
    for (const { type, count, name } of properties) {
      const length = count ? this.length(count, type, name) : 1;
      for (let i = 0; i < length; i++) this.values.next(type);
    }
  }

  readFaces(element: Element): void {
    const { rows, properties } = element;
    const indices = properties.find(isIndices);
    if (!indices) throw this.error(msg`its faces have no list vertex_indices`, this.entry);
    const colors = placesOf(element, NAMES.colors);
    if (colors) this.faceColors = growableFloats();
    if (properties.some(({ name, count }) => count && name === 'texcoord')) this.cornerUvs = growableFloats();
    const row = new Float64Array(properties.length);
    for (let face = 0; face < rows; face++) {
      let uvs: number[] = [];
      for (const [k, property] of properties.entries()) {
        if (property === indices) this.readFace(property, face);
        else if (property.count && property.name === 'texcoord') uvs = this.readList(property);
        else if (property.count) this.skip([property]);
        else row[k] = this.values.next(property.type);
      }
      this.values.endRow();
      if (this.cornerUvs) this.pushUvs(uvs, this.cornerUvs, face);
      for (const place of colors ?? []) {
        const value = linear(row[place], properties[place].type);
        this.faceColors?.push(this.finite(value, properties[place].name, 'face', face));
      }
    }
  }

  private readFace({ type, count, name }: Property, face: number): void {
    const corners = this.length(count!, type, name);
    if (corners > MAX_CORNERS)
      throw this.error(msg`face ${face} has ${corners} corners; at most ${MAX_CORNERS} are read`);
    for (let k = 0; k < corners; k++) this.faceIndices.push(this.vertex(type, 'face', face));
    this.faceCounts.push(corners);
  }

  /** As many uvs as the face has corners, whatever the file says. */
  private pushUvs(uvs: readonly number[], out: GrowableFloats, face: number): void {
    const corners = this.faceCounts.values()[face];
    for (let i = 0; i < 2 * corners; i++) out.push(this.finite(uvs[i] ?? 0, 'texcoord', 'face', face));
  }

  /** Strips of triangles, ended by −1, as Stanford's models have them. */
  readStrips({ rows, properties }: Element): void {
    for (let row = 0; row < rows; row++) {
      for (const property of properties) {
        if (isIndices(property)) this.readStrip(property, row);
        else this.skip([property]);
      }
      this.values.endRow();
    }
  }

  private readStrip({ type, count, name }: Property, row: number): void {
    const length = this.length(count!, type, name);
    let [a, b, isOdd] = [-1, -1, false];
    for (let i = 0; i < length; i++) {
      const c = this.vertex(type, 'strip', row, -1);
      if (c < 0) {
        [a, b, isOdd] = [-1, -1, false];
        continue;
      }
      if (a >= 0) {
        this.faceIndices.push(isOdd ? b : a, isOdd ? a : b, c);
        this.faceCounts.push(3);
        isOdd = !isOdd;
      }
      [a, b] = [b, c];
    }
  }

  private readList({ type, count, name }: Property): number[] {
    const out: number[] = [];
    for (let left = this.length(count!, type, name); left > 0; left--) out.push(this.values.next(type));
    return out;
  }

  private length(countType: ScalarType, type: ScalarType, name: string): number {
    const length = this.values.next(countType);
    if (!Number.isInteger(length) || length < 0) throw this.error(msg`a list ${name} has the length ${length}`);
    this.values.expect(() => msg`${length} values of ${name}`, length, [type]);
    return length;
  }

  private vertex(type: ScalarType, what: 'face' | 'strip', row: number, least = 0): number {
    const index = this.values.next(type);
    if (Number.isInteger(index) && index >= least && index < this.vertices) return index;
    const where = what === 'face' ? msg`face ${row}` : msg`strip ${row}`;
    throw this.error(msg`${where} names vertex ${index}; there are ${this.vertices}, counted from 0`);
  }

  private finite(value: number, name: string, element: 'vertex' | 'face', row: number): number {
    if (Number.isFinite(Math.fround(value))) return value;
    throw this.error(
      element === 'vertex' ? msg`${name} of vertex ${row} is ${value}` : msg`${name} of face ${row} is ${value}`,
    );
  }

  private error(message: Message, place: LocalizedText = msg`${this.entry}: ${this.values.place()}`): Error {
    return inputError('ply.value', place, msg`${message}; the file is damaged, export it again`);
  }
}

const FULL: Readonly<Partial<Record<ScalarType, number>>> = { uint8: 255, uint16: 65535, uint32: 2 ** 32 - 1 };

/** Colours are sRGB: whole numbers up to the greatest of their type, or 0 … 1. */
const linear = (value: number, type: ScalarType): number => decodeSrgb(Math.max(0, value / (FULL[type] ?? 1)));
