import { type Message, msg } from '../../../../../messages/message.ts';
import type { TextureWrap } from '../../../../../scene/types.ts';
import { decodeSrgb } from '../../../../../spectrum/display/srgb.ts';
import type { DiagnosticCode } from '../../../../diagnostics/diagnosticCodes.ts';
import { report } from '../../../diagnostics.ts';
import { numberOf, numbersOf, textOf } from '../../../layer/attributes.ts';
import type { PrimSpec } from '../../../layer/layer.ts';
import type { StageContext } from '../../context.ts';
import { isAnimated, type ResolvedInput, resolveInput, shaderId } from '../shaderInputs.ts';
import type { TextureLoader } from '../textureLoader.ts';
import { withTiles } from '../uvs.ts';
import { isColorSpace, storedAs, toLinear } from './colorSpaces.ts';
import {
  type Constant,
  computed,
  constant,
  type Expression,
  picked,
  scaled,
  sizeOf,
  type TexelField,
} from './expression.ts';
import { channelIndices, NODE_KINDS, PATTERN_MEANS } from './nodes.ts';
import { movedUv, place2d, rotatedUv, scaledUv, type UvAffine, uvOf, uvSource } from './placement.ts';

/** Maximum number of nodes from a surface to the end of a chain. */
const MAX_DEPTH = 128;
/** Maximum number of nodes of a material. */
const MAX_NODES = 4096;

/** A node, with what its id says. */
interface Node {
  readonly prim: PrimSpec;
  /** `multiply`, `image` … */
  readonly kind: string;
  /** Numbers of its result. */
  readonly size: number;
  /** A colour, to which colour spaces apply. */
  readonly isColor: boolean;
}

/** Evaluates the shading network of one material. */
export class ShadingNetwork {
  private readonly context: StageContext;
  private readonly textures: TextureLoader;
  private readonly done = new Map<string, Expression | undefined>();
  private readonly told = new Set<string>();
  private depth = 0;
  private nodes = 0;

  constructor(context: StageContext, textures: TextureLoader) {
    this.context = context;
    this.textures = textures;
  }

  /** Metres per unit of the stage. */
  get unit(): number {
    return this.context.unit;
  }

  /** The input of a shader; undefined if it is not written, or cannot be read. */
  async input(shader: PrimSpec, name: string): Promise<Expression | undefined> {
    return this.of(this.resolve(shader, name), shader);
  }

  /** What an input is; undefined if nothing that can be read. */
  async of(input: ResolvedInput, user: PrimSpec): Promise<Expression | undefined> {
    if (input.shader) return this.output(input.shader, input.output ?? 'out');
    const { value, colorSpace } = input;
    if (value?.type === 'bool') return constant(Number(value.data));
    const numbers = numbersOf(value);
    if (!numbers) {
      const number = numberOf(value);
      return number === undefined ? undefined : constant(number);
    }
    if (colorSpace === undefined) return constant(...numbers);
    if (!isColorSpace(colorSpace))
      this.tell('mtlx.node', user, msg`its colour space '${colorSpace}' is not known; it is taken as linear`);
    return constant(...toLinear(colorSpace, [...numbers]));
  }

  /** The text of an input. */
  text(shader: PrimSpec, name: string): string | undefined {
    return textOf(this.resolve(shader, name).value);
  }

  tell(code: DiagnosticCode, { path }: PrimSpec, message: Message): void {
    const key = `${path} ${message.template}`;
    if (this.told.has(key)) return;
    this.told.add(key);
    report(this.context, 'warning', code, path, message);
  }

  private resolve(shader: PrimSpec, name: string): ResolvedInput {
    return resolveInput(this.context.layer, shader, `inputs:${name}`, this.context.startCode);
  }

  private async output(prim: PrimSpec, output: string): Promise<Expression | undefined> {
    const key = `${prim.path}.${output}`;
    if (this.done.has(key)) return this.done.get(key);
    if (this.depth >= MAX_DEPTH || ++this.nodes > MAX_NODES) {
      this.tell(
        'usd.shader',
        prim,
        msg`its network has more than ${MAX_DEPTH} nodes in a row or ${MAX_NODES} in all; the rest is left out`,
      );
      return undefined;
    }
    // Nothing, for a node that leads back to itself.
    this.done.set(key, undefined);
    this.depth++;
    const found = await this.evaluate(nodeOf(prim, output), output);
    this.depth--;
    this.done.set(key, found);
    return found;
  }

  private async evaluate(node: Node, output: string): Promise<Expression | undefined> {
    const { prim, kind } = node;
    if (isAnimated(prim)) this.tell('usd.animated-material', prim, msg`it changes with time; it is held at the start`);
    if (PICTURES.test(kind)) return this.picture(node, output);
    if (kind === 'normalmap') return this.normals(prim, await this.input(prim, 'in'));
    const placed = await this.placement(node);
    if (placed) return placed;
    const vertex = await this.vertexValue(node);
    if (vertex) return vertex;
    const mean = PATTERN_MEANS.get(kind);
    if (mean !== undefined) {
      this.tell('mtlx.node', prim, msg`the pattern '${kind}' is not drawn; its mean is`);
      return constant(...Array.from({ length: node.size }, () => mean));
    }
    if (kind === 'swizzle') {
      const from = (await this.input(prim, 'in')) ?? constant(0);
      return picked(from, channelIndices(this.text(prim, 'channels') ?? '')) ?? this.unread(node);
    }
    return this.computedNode(node, output);
  }

  private async computedNode(node: Node, output: string): Promise<Expression | undefined> {
    const { prim, kind, size } = node;
    const known = NODE_KINDS.get(kind);
    if (!known) return this.unread(node);
    const args: Expression[] = [];
    for (const [name, fallback] of known.inputs) args.push((await this.input(prim, name)) ?? constant(fallback));
    const simple = affine(node, output, args);
    const found = simple ?? computed(args, size, known.compute(size, output));
    if (!found) {
      this.tell(
        'mtlx.node',
        prim,
        msg`the node '${kind}' mixes textures that are placed in different ways, or coordinates, which is not drawn`,
      );
      return undefined;
    }
    if (found.kind !== 'constant' || found.values.every(Number.isFinite)) return found;
    this.tell('mtlx.node', prim, msg`the node '${kind}' gives no finite value; 0 is drawn`);
    return constant(...found.values.map((x) => (Number.isFinite(x) ? x : 0)));
  }

  private unread({ prim, kind }: Node): undefined {
    const name = kind || shaderId(prim);
    this.tell('mtlx.node', prim, msg`the node '${name}' is not read; the input that it drives keeps its own value`);
  }

  /** A picture, by all nodes that look one up. */
  private async picture({ prim, kind, size, isColor }: Node, output: string): Promise<Expression | undefined> {
    const numbers = async (name: string): Promise<readonly number[] | undefined> => {
      const found = await this.input(prim, name);
      return found?.kind === 'constant' ? found.values : undefined;
    };
    const isPreview = kind === 'UsdUVTexture';
    const single = 'rgba'.indexOf(output);
    const wanted = isPreview
      ? output.length === 1 && single >= 0
        ? [single]
        : [0, 1, 2]
      : [0, 1, 2, 3].slice(0, size);
    const file = this.resolve(prim, 'file');
    const picture = textOf(file.value) ? await this.textures.file(file.value, prim.path) : undefined;
    if (!picture) {
      if (!textOf(file.value)) this.tell('usd.texture', prim, msg`the texture names no file`);
      const fallback = await numbers(isPreview ? 'fallback' : 'default');
      if (!fallback)
        return kind === 'gltf_normalmap' ? undefined : constant(...wanted.map((k) => (isPreview && k === 3 ? 1 : 0)));
      return constant(...wanted.map((k) => fallback[Math.min(k, fallback.length - 1)]));
    }
    const written = isPreview ? usdColorSpace(this.text(prim, 'sourceColorSpace')) : undefined;
    const auto = picture.looksLikeColor ? 'srgb_texture' : 'lin_rec709';
    const named = isColor || isPreview ? (written ?? file.colorSpace) : 'raw';
    const space = named ?? auto;
    if (!isColorSpace(space))
      this.tell('mtlx.node', prim, msg`its colour space '${space}' is not known; it is taken as linear`);
    const placed = await this.pictureUv(prim, kind, numbers);
    const { uv, sheared } = uvSource(placed);
    if (sheared) this.tell('usd.uv', prim, msg`its texture coordinates are sheared, which is not drawn`);
    const [wrapS, wrapT] = isPreview ? ['wrapS', 'wrapT'] : ['uaddressmode', 'vaddressmode'];
    const grid = {
      width: picture.width,
      height: picture.height,
      uv: picture.tiles ? withTiles(uv ?? { name: 'st' }, picture.tiles) : uv,
      wrapS: picture.tiles ? 'clamp' : wrapOf(this.text(prim, wrapS)),
      wrapT: picture.tiles ? 'clamp' : wrapOf(this.text(prim, wrapT)),
      filter: this.text(prim, 'filtertype') === 'closest' ? 'nearest' : 'linear',
    } as const;
    const texels = picture.numbers && named !== undefined ? { ...picture, data: picture.numbers } : picture;
    const looked = lookedUp(texels, textOf(file.value)!, space, grid);
    const one = picked(looked, wanted);
    if (isPreview) {
      const [scale, bias] = [(await numbers('scale')) ?? [1, 1, 1, 1], (await numbers('bias')) ?? [0, 0, 0, 0]];
      return (
        one &&
        scaled(
          one,
          wanted.map((k) => scale[k] ?? 1),
          wanted.map((k) => bias[k] ?? 0),
        )
      );
    }
    if (kind === 'gltf_normalmap') return one && this.normals(prim, one);
    if (kind === 'hextiledimage') this.tell('mtlx.node', prim, msg`'hextiledimage' is drawn as 'tiledimage'`);
    const factor = await numbers(kind === 'gltf_colorimage' ? 'color' : 'factor');
    const tinted = one && factor ? scaled(one, factor, [0]) : one;
    if (kind !== 'gltf_colorimage') return tinted;
    return tinted && picked(tinted, output === 'outa' ? [3] : [0, 1, 2]);
  }

  /** The coordinates at which a node looks a picture up. */
  private async pictureUv(
    prim: PrimSpec,
    kind: string,
    numbers: (name: string) => Promise<readonly number[] | undefined>,
  ): Promise<UvAffine> {
    const pair = async (name: string, fallback: number): Promise<readonly [number, number]> => {
      const found = await numbers(name);
      return [found?.[0] ?? fallback, found?.[1] ?? fallback];
    };
    const placed = await this.input(prim, kind === 'UsdUVTexture' ? 'st' : 'texcoord');
    if (placed && placed.kind !== 'placement')
      this.tell(
        'usd.uv',
        prim,
        msg`its texture coordinates are computed in a way that is not read; those of the mesh are used`,
      );
    const uv = placed?.kind === 'placement' ? placed.uv : uvOf('');
    if (kind === 'hextiledimage') return scaledUv(uv, await pair('tiling', 1));
    if (kind === 'tiledimage') {
      const [tiling, shift] = [await pair('uvtiling', 1), await pair('uvoffset', 0)];
      const [image, tile] = [await pair('realworldimagesize', 1), await pair('realworldtilesize', 1)];
      const moved = movedUv(scaledUv(uv, tiling), [-shift[0], -shift[1]]);
      return scaledUv(moved, [tile[0] / image[0], tile[1] / image[1]]);
    }
    if (!kind.startsWith('gltf_')) return uv;
    // glTF's transform, as MaterialX builds it of place2d: v downwards, counter-clockwise.
    const [scale, offset] = [await pair('scale', 1), await pair('offset', 0)];
    const pivot = (await numbers('pivot')) ?? [0, 1];
    const order = kind === 'gltf_colorimage' ? 1 : 0;
    return place2d(uv, {
      pivot: [pivot[0], pivot[1]],
      scale: [1 / scale[0], 1 / scale[1]],
      rotate: -((await numbers('rotate'))?.[0] ?? 0),
      offset: [-offset[0], offset[1]],
      operationorder: (await numbers('operationorder'))?.[0] ?? order,
    });
  }

  private async normals(prim: PrimSpec, encoded: Expression | undefined): Promise<Expression | undefined> {
    const scale = await this.input(prim, 'scale');
    const [x, y] = scale?.kind === 'constant' && !shaderId(prim).includes('gltf') ? scale.values : [1];
    if (encoded?.kind === 'constant' || encoded?.kind === 'texels')
      return { kind: 'normals', encoded, strength: [x, y ?? x] };
    return undefined;
  }

  /** Texture coordinates, and what is computed of them. */
  private async placement({ prim, kind, size }: Node): Promise<Expression | undefined> {
    if (kind === 'texcoord') {
      const index = await this.input(prim, 'index');
      const set = index?.kind === 'constant' ? index.values[0] : 0;
      return { kind: 'placement', uv: uvOf(set > 0 ? `st${set}` : '') };
    }
    if ((kind === 'geompropvalue' || kind === 'UsdPrimvarReader') && size === 2) {
      const name = this.text(prim, kind === 'geompropvalue' ? 'geomprop' : 'varname');
      return { kind: 'placement', uv: uvOf(name ?? '') };
    }
    if (!UV_NODES.has(kind)) return undefined;
    const first = UV_NODES.get(kind)!;
    // Sums and products may have the coordinates second.
    const turned = kind === 'multiply' || kind === 'add' ? await this.input(prim, 'in2') : undefined;
    const isTurned = turned?.kind === 'placement';
    const from = isTurned ? turned : await this.input(prim, first);
    const uv = from?.kind === 'placement' ? from.uv : undefined;
    if (!uv) return undefined;
    const pair = async (name: string, fallback: number): Promise<[number, number] | undefined> => {
      const found = (await this.input(prim, name)) ?? constant(fallback);
      return found.kind === 'constant' ? [found.values[0], found.values[1] ?? found.values[0]] : undefined;
    };
    const made = await this.placedBy(kind, uv, isTurned ? (_, fallback) => pair('in1', fallback) : pair);
    return made && { kind: 'placement', uv: made };
  }

  private async placedBy(
    kind: string,
    uv: UvAffine,
    pair: (name: string, fallback: number) => Promise<[number, number] | undefined>,
  ): Promise<UvAffine | undefined> {
    if (kind === 'place2d') {
      const [pivot, scale, offset] = [await pair('pivot', 0), await pair('scale', 1), await pair('offset', 0)];
      const [rotate, order] = [await pair('rotate', 0), await pair('operationorder', 0)];
      if (!pivot || !scale || !offset || !rotate || !order) return undefined;
      return place2d(uv, { pivot, scale, rotate: rotate[0], offset, operationorder: order[0] });
    }
    if (kind === 'UsdTransform2d') {
      const [scale, rotation, shift] = [
        await pair('scale', 1),
        await pair('rotation', 0),
        await pair('translation', 0),
      ];
      return scale && rotation && shift && movedUv(rotatedUv(scaledUv(uv, scale), rotation[0]), shift);
    }
    if (kind === 'dot' || kind === 'convert') return uv;
    if (kind === 'rotate2d') {
      const angle = await pair('amount', 0);
      return angle && rotatedUv(uv, -angle[0]);
    }
    const by = await pair('in2', kind === 'multiply' || kind === 'divide' ? 1 : 0);
    if (!by) return undefined;
    if (kind === 'multiply') return scaledUv(uv, by);
    if (kind === 'divide') return scaledUv(uv, [1 / by[0], 1 / by[1]]);
    return movedUv(uv, kind === 'add' ? by : [-by[0], -by[1]]);
  }

  /** A colour of the mesh's vertices. */
  private async vertexValue({ prim, kind, size }: Node): Promise<Expression | undefined> {
    const input = { geomcolor: '', geompropvalue: 'geomprop', UsdPrimvarReader: 'varname' }[kind];
    if (input === undefined) return undefined;
    const name = input === '' ? 'displayColor' : this.text(prim, input);
    const otherwise = await this.input(prim, kind === 'UsdPrimvarReader' ? 'fallback' : 'default');
    const fallback = otherwise?.kind === 'constant' ? otherwise.values : Array.from({ length: size }, () => 0);
    if (size >= 3 && name) return { kind: 'vertex', name, gain: Array.from({ length: size }, () => 1), fallback };
    this.tell('mtlx.node', prim, msg`a primvar drives a number of this material; its fallback is drawn`);
    return constant(...fallback);
  }
}

/** Nodes that look a picture up. */
const PICTURES = /^(image|tiledimage|hextiledimage|gltf_image|gltf_colorimage|gltf_normalmap|UsdUVTexture)$/;

/** Nodes that place coordinates, and their input. */
const UV_NODES = new Map([
  ['place2d', 'texcoord'],
  ['UsdTransform2d', 'in'],
  ['rotate2d', 'in'],
  ['dot', 'in'],
  ['convert', 'in'],
  ['multiply', 'in1'],
  ['divide', 'in1'],
  ['add', 'in1'],
  ['subtract', 'in1'],
]);

const SIZES: ReadonlyMap<string, number> = new Map([
  ['float', 1],
  ['integer', 1],
  ['boolean', 1],
  ['color3', 3],
  ['color4', 4],
  ['vector2', 2],
  ['vector3', 3],
  ['vector4', 4],
  // Of UsdPrimvarReader and of its outputs.
  ['float2', 2],
  ['float3', 3],
  ['float4', 4],
  ['vector', 3],
  ['point', 3],
  ['normal', 3],
]);

const ONE_NUMBER = /^(extract|separate[234]|dotproduct|magnitude|distance)$/;

/** `ND_multiply_color3FA` → multiply, 3 numbers; the longest name that is known counts. */
function nodeOf(prim: PrimSpec, output: string): Node {
  const id = shaderId(prim);
  const parts = id.replace(/^ND_(logical_)?/, '').split('_');
  let kind = '';
  for (let end = parts.length; end > 0 && kind === ''; end--) {
    const name = parts.slice(0, end).join('_');
    if (isKind(name)) kind = name;
  }
  if (kind === 'gltf_colorimage') return { prim, kind, size: 4, isColor: true };
  if (kind === 'gltf_normalmap') return { prim, kind, size: 3, isColor: false };
  const types = parts.map((part) => part.replace(/(FA|CF|VF|VV|I|B)$/, '')).filter((part) => SIZES.has(part));
  const type = types.at(-1) ?? '';
  const size = ONE_NUMBER.test(kind) || output.length === 1 ? 1 : (SIZES.get(type) ?? 3);
  return { prim, kind, size, isColor: type.startsWith('color') };
}

const isKind = (name: string): boolean =>
  NODE_KINDS.has(name) || PATTERN_MEANS.has(name) || PICTURES.test(name) || UV_NODES.has(name) || OTHERS.has(name);
const OTHERS = new Set(['normalmap', 'texcoord', 'geompropvalue', 'geomcolor', 'UsdPrimvarReader', 'swizzle']);

/** Computations that keep what a picture or a primvar is: sums, products, choices of channels. */
function affine({ kind, size }: Node, output: string, args: readonly Expression[]): Expression | undefined {
  const at = args.findIndex((arg) => arg.kind !== 'constant');
  if (at < 0 || args.some((arg, k) => k !== at && arg.kind !== 'constant')) return undefined;
  const from = args[at];
  const other = ((args[1 - at] as Constant | undefined)?.values ?? []).slice();
  if (kind === 'dot') return from;
  if (kind === 'extract' && at === 0) return picked(from, [Math.floor(other[0])]);
  if (/^separate/.test(kind)) return picked(from, channelIndices(output.slice(-1)));
  if (kind === 'convert' && sizeOf(from) >= size)
    return picked(
      from,
      Array.from({ length: size }, (_, k) => k),
    );
  if (kind === 'convert' && sizeOf(from) === 1)
    return picked(
      from,
      Array.from({ length: size }, () => 0),
    );
  if (sizeOf(from) !== size) return undefined;
  if (kind === 'multiply') return scaled(from, other, [0]);
  if (kind === 'divide' && at === 0)
    return scaled(
      from,
      other.map((x) => 1 / x),
      [0],
    );
  if (kind === 'add') return scaled(from, [1], other);
  if (kind === 'subtract')
    return at === 0
      ? scaled(
          from,
          [1],
          other.map((x) => -x),
        )
      : scaled(from, [-1], other);
  if (kind === 'invert' && at === 0) return scaled(from, [-1], other);
  return undefined;
}

const SRGB = Float64Array.from({ length: 256 }, (_, byte) => decodeSrgb(byte / 255));

/** The four channels of a picture in linear sRGB. */
function lookedUp(
  image: NonNullable<Awaited<ReturnType<TextureLoader['file']>>>,
  name: string,
  space: string,
  grid: TexelField['grid'],
): TexelField {
  const { data, width } = image;
  const stored = storedAs(space);
  const read = (x: number, y: number): readonly number[] => {
    const i = 4 * (y * width + x);
    if (stored === 'srgb') return [SRGB[data[i]], SRGB[data[i + 1]], SRGB[data[i + 2]], data[i + 3] / 255];
    return [data[i] / 255, data[i + 1] / 255, data[i + 2] / 255, data[i + 3] / 255];
  };
  const at = stored ? read : (x: number, y: number) => toLinear(space, read(x, y));
  const plain = { name, image, channels: [0, 1, 2, 3], scale: [1, 1, 1, 1], bias: [0, 0, 0, 0] };
  const picture = stored ?? (isColorSpace(space) ? undefined : 'linear');
  return { kind: 'texels', size: 4, grid, cost: 1, at, ...(picture && { picture: { ...plain, colorSpace: picture } }) };
}

const usdColorSpace = (written: string | undefined): string | undefined =>
  written === 'raw' ? 'raw' : written === 'sRGB' ? 'srgb_texture' : undefined;

function wrapOf(mode: string | undefined): TextureWrap {
  if (mode === 'clamp' || mode === 'mirror' || mode === 'black') return mode;
  return mode === 'constant' ? 'black' : 'repeat';
}
