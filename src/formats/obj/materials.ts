import { listed, msg } from '../../messages/message.ts';
import { makeMaterial } from '../../scene/defaults.ts';
import type { Material, Texture } from '../../scene/types.ts';
import { resolvePath } from '../files/fileSource.ts';
import { channelMean, withAlphaFrom } from '../image/imageChannels.ts';
import { lineError, numberOf, type ObjContext, type ObjStatement } from './context.ts';
import type { UvPlacement } from './meshes.ts';
import { statements } from './statements.ts';
import { ObjTextureLoader, parseTextureReference, type TextureReference } from './textures.ts';

/** A material as authored in an .mtl. */
interface MtlMaterial {
  readonly file: string;
  readonly name: string;
  readonly numbers: ReadonlyMap<string, readonly number[]>;
  readonly pictures: ReadonlyMap<string, TextureReference>;
}

/** A material with the placement of its textures. */
export interface ReadMaterial {
  readonly material: Material;
  readonly uvs?: UvPlacement;
}

/** Maximum number of .mtl names in a file. */
export const MAX_FILES = 1000;
/** Maximum number of materials per .mtl. */
export const MAX_MATERIALS = 2 ** 16;
const COLORS = ['Kd', 'Ks', 'Ke'];
const SCALARS = ['Ns', 'Ni', 'd', 'Tr', 'Pr', 'Pm'];
const SHOWN_PICTURES = ['map_Kd', 'map_Ke', 'map_d', 'map_Pr', 'map_Pm', 'norm'];
/** Unsupported statements that affect the appearance; each is reported once. */
const LEFT_OUT = /^(map_|bump$|disp$|decal$|refl$|Tf$|Pc$|Pcr$|Ps$|aniso$|anisor$)/i;

/** The materials of .mtl files by name; reports missing files with the paths that were tried. */
export class ObjMaterialLibrary {
  private readonly context: ObjContext;
  private readonly pictures: ObjTextureLoader;
  private readonly written = new Map<string, MtlMaterial>();
  private readonly files: string[] = [];
  private named = 0;
  constructor(context: ObjContext) {
    this.context = context;
    this.pictures = new ObjTextureLoader(context);
  }

  /** `mtllib a.mtl b.mtl`. The format does not say whether names may contain spaces: the whole line is tried first. */
  async load({ line, words, rest }: ObjStatement): Promise<void> {
    this.named += words.length;
    if (this.named > MAX_FILES) {
      throw lineError(
        this.context.entry,
        line,
        'obj.too-many',
        msg`more than ${MAX_FILES} files of materials are named`,
      );
    }
    if (await this.loadFile(rest)) return;
    const missing: string[] = [];
    for (const name of words.length > 1 ? words : []) if (!(await this.loadFile(name))) missing.push(name);
    const names = words.length > 1 ? missing : [rest];
    for (const name of names) {
      const { entry, notes } = this.context;
      const message = msg`the materials ${name} are not there (looked for ${resolvePath(entry, name)}); put them beside it, or open the folder that holds both`;
      const missing = { name, lookedFor: [resolvePath(entry, name)] };
      notes.add('warning', 'file.missing-materials', msg`line ${line}`, message, { missing });
    }
  }

  private async loadFile(name: string): Promise<boolean> {
    const file = resolvePath(this.context.entry, name);
    if (this.files.includes(file)) return true;
    const bytes = name === '' ? undefined : await this.context.source.read(file);
    if (!bytes) return false;
    this.files.push(file);
    for (const material of readMtl(bytes, file, this.context)) this.written.set(material.name, material);
    return true;
  }

  /** The material of a name; light grey, with a warning, if no file defines it. */
  async read(name: string): Promise<ReadMaterial> {
    const written = this.written.get(name);
    if (written) return convert(written, this.pictures);
    if (name !== '') {
      const where = this.files.length > 0 ? listed(this.files) : msg`no materials were found`;
      this.context.notes.add(
        'warning',
        'obj.missing-material',
        name,
        msg`no such material (${where}); it is shown light grey`,
      );
    }
    return { material: makeMaterial({ name: name || 'default' }) };
  }
}

/** Parses an .mtl. Throws an InputError with the line of an invalid number. */
function readMtl(bytes: Uint8Array, file: string, { notes }: ObjContext): MtlMaterial[] {
  const out: MtlMaterial[] = [];
  let numbers = new Map<string, readonly number[]>();
  let pictures = new Map<string, TextureReference>();
  for (const statement of statements(bytes, file)) {
    const { line, keyword, words, rest } = statement;
    if (keyword === 'newmtl') {
      if (out.length >= MAX_MATERIALS)
        throw lineError(file, line, 'obj.too-many', msg`there are more than ${MAX_MATERIALS} materials`);
      [numbers, pictures] = [new Map(), new Map()];
      out.push({ file, name: rest, numbers, pictures });
    } else if (COLORS.includes(keyword)) {
      if (words[0] === 'spectral' || words[0] === 'xyz')
        notes.add('warning', 'obj.color', msg`${file}: line ${line}`, msg`${keyword} ${words[0]} is not read`);
      else numbers.set(keyword, colorOf(file, statement));
    } else if (SCALARS.includes(keyword)) numbers.set(keyword, [scalarOf(file, statement)]);
    else if (SHOWN_PICTURES.includes(keyword))
      pictures.set(keyword, parseTextureReference(file, out.at(-1)?.name ?? '', statement));
    else if (LEFT_OUT.test(keyword)) {
      notes.add('info', 'obj.ignored', msg`material ${out.at(-1)?.name ?? ''}`, msg`${keyword} of it is left out`);
    }
  }
  return out;
}

/** A colour; one number stands for all three. */
function colorOf(file: string, { line, words }: ObjStatement): readonly number[] {
  const r = numberOf(file, line, words[0]);
  return words.length < 3 ? [r, r, r] : [r, numberOf(file, line, words[1]), numberOf(file, line, words[2])];
}

/** `d -halo 0.5` is read as `d 0.5`. */
const scalarOf = (file: string, { line, words }: ObjStatement): number =>
  numberOf(file, line, words.filter((w) => w !== '-halo')[0]);

async function convert({ name, numbers, pictures }: MtlMaterial, loader: ObjTextureLoader): Promise<ReadMaterial> {
  const [r, g, b] = numbers.get('Kd') ?? (pictures.has('map_Kd') ? [1, 1, 1] : [0.8, 0.8, 0.8]);
  const emissive = numbers.get('Ke') ?? (pictures.has('map_Ke') ? [1, 1, 1] : [0, 0, 0]);
  const ior = scalar(numbers, 'Ni');
  const baseColorTexture = await baseTexture(pictures, loader);
  const emissiveTexture = await loader.texture(pictures.get('map_Ke'));
  const numbered = (keyword: string) => loader.texture(pictures.get(keyword), 'linear');
  const normals = await numbered('norm');
  const uvs = SHOWN_PICTURES.map((keyword) => pictures.get(keyword)).find(Boolean)?.uvs;
  const material = makeMaterial({
    name,
    baseColor: [r, g, b],
    ...(baseColorTexture && { baseColorTexture }),
    emissive: [emissive[0], emissive[1], emissive[2]],
    ...(emissiveTexture && { emissiveTexture }),
    ...channelOf('roughness', await numbered('map_Pr'), numbers, 'Pr'),
    ...channelOf('metallic', await numbered('map_Pm'), numbers, 'Pm'),
    ...(normals && { normalTexture: { texture: normals, strength: [1, 1] } }),
    opacity: clamped(scalar(numbers, 'd') ?? 1 - (scalar(numbers, 'Tr') ?? 0)),
    // Many programs write 1 or 0 for an unset value.
    ...(ior !== undefined && ior > 1 && { ior }),
  });
  return uvs ? { material, uvs } : { material };
}

/** A number, or the red channel of its texture times the number. */
function channelOf(
  what: 'roughness' | 'metallic',
  texture: Texture | undefined,
  numbers: ReadonlyMap<string, readonly number[]>,
  keyword: 'Pr' | 'Pm',
): Partial<Material> {
  if (!texture) return { [what]: what === 'roughness' ? roughnessOf(numbers) : clamped(scalar(numbers, 'Pm') ?? 0) };
  const scale = clamped(scalar(numbers, keyword) ?? 1);
  return { [what]: scale * channelMean(texture, 0), [`${what}Texture`]: { texture, channel: 0, scale, bias: 0 } };
}

const scalar = (numbers: ReadonlyMap<string, readonly number[]>, name: string): number | undefined =>
  numbers.get(name)?.[0];
const clamped = (x: number): number => Math.min(1, Math.max(0, x));

/**
 * Roughness: Pr if given, else from the Blinn–Phong exponent n = Ns by the width of its lobe, roughness⁴ = 2 / (n + 2)
 * (Walter et al. 2007, eq. for Blinn–Phong's α_b, with α = roughness²); 1 if Ks is black.
 */
function roughnessOf(numbers: ReadonlyMap<string, readonly number[]>): number {
  const authored = scalar(numbers, 'Pr');
  if (authored !== undefined) return clamped(authored);
  if (numbers.get('Ks')?.every((x) => x === 0)) return 1;
  const exponent = scalar(numbers, 'Ns');
  return exponent === undefined ? 0.6 : clamped((2 / (Math.max(0, exponent) + 2)) ** 0.25);
}

/** The colour texture with the opacity texture as its alpha. */
async function baseTexture(
  pictures: ReadonlyMap<string, TextureReference>,
  loader: ObjTextureLoader,
): Promise<Texture | undefined> {
  const [color, opacity] = [pictures.get('map_Kd'), pictures.get('map_d')];
  const alpha = opacity && (await loader.image(opacity));
  if (!alpha) return loader.texture(color);
  const merged = withAlphaFrom(color && (await loader.image(color)), alpha, 0);
  return loader.textureOf(color ?? opacity, merged);
}
