import { msg } from '../../messages/message.ts';
import { InputError, type Texture } from '../../scene/types.ts';
import { missingTexture } from '../diagnostics/missingFiles.ts';
import { resolvePath } from '../files/fileSource.ts';
import { type DecodedImage, decodeImage } from '../image/decodeImage.ts';
import type { ObjContext, ObjStatement } from './context.ts';
import { numberOf } from './context.ts';
import type { UvPlacement } from './meshes.ts';

/** A texture reference of a material. */
export interface TextureReference {
  /** Path of the .mtl. */
  readonly file: string;
  readonly line: number;
  readonly material: string;
  readonly name: string;
  readonly clamp: boolean;
  readonly uvs?: UvPlacement;
}

/** Options of texture maps with their maximum number of arguments; only -s, -o and -clamp are used. */
const OPTIONS: ReadonlyMap<string, number> = new Map([
  ['-s', 3],
  ['-o', 3],
  ['-t', 3],
  ['-mm', 2],
  ['-clamp', 1],
  ['-blendu', 1],
  ['-blendv', 1],
  ['-cc', 1],
  ['-boost', 1],
  ['-texres', 1],
  ['-bm', 1],
  ['-imfchan', 1],
  ['-type', 1],
]);

/** Parses `map_Kd -s 2 2 1 -clamp on bark brown.png`. */
export function parseTextureReference(file: string, material: string, { line, words }: ObjStatement): TextureReference {
  const options = new Map<string, readonly string[]>();
  let at = 0;
  while (at < words.length && OPTIONS.has(words[at])) {
    const [option, first] = [words[at], at + 1];
    at = first;
    // One to three numbers, or one word; the last word is always part of the name.
    while (at < words.length - 1 && at - first < OPTIONS.get(option)! && (at === first || isNumber(words[at]))) at++;
    options.set(option, words.slice(first, at));
  }
  const name = words.slice(at).join(' ');
  const ref = { file, line, material, name, clamp: options.get('-clamp')?.[0] === 'on' };
  const uvs = placementOf(file, line, options);
  return uvs ? { ...ref, uvs } : ref;
}

const isNumber = (word: string): boolean => word !== '' && Number.isFinite(Number(word));

function placementOf(
  file: string,
  line: number,
  options: ReadonlyMap<string, readonly string[]>,
): UvPlacement | undefined {
  if (!options.has('-s') && !options.has('-o')) return undefined;
  const pair = (option: string, otherwise: number): [number, number] => {
    const args = options.get(option) ?? [];
    const number = (k: number): number => (args[k] === undefined ? otherwise : numberOf(file, line, args[k]));
    return [number(0), number(1)];
  };
  return { scale: pair('-s', 1), offset: pair('-o', 0) };
}

/** Reads and caches textures. */
export class ObjTextureLoader {
  private readonly context: ObjContext;
  private readonly images = new Map<string, Promise<DecodedImage | undefined>>();
  constructor(context: ObjContext) {
    this.context = context;
  }

  /** Undefined, with a warning, if the file is missing. */
  image(ref: TextureReference): Promise<DecodedImage | undefined> {
    const key = `${ref.file}\n${ref.name}`;
    const image = this.images.get(key) ?? this.load(ref);
    this.images.set(key, image);
    return image;
  }

  async texture(
    ref: TextureReference | undefined,
    colorSpace: Texture['colorSpace'] = 'srgb',
  ): Promise<Texture | undefined> {
    const image = ref && (await this.image(ref));
    return image && this.textureOf(ref, image, colorSpace);
  }

  textureOf(
    { name, clamp }: TextureReference,
    image: DecodedImage,
    colorSpace: Texture['colorSpace'] = 'srgb',
  ): Texture {
    const wrap = clamp ? 'clamp' : 'repeat';
    return { name, ...image, colorSpace, filter: 'linear', wrapS: wrap, wrapT: wrap };
  }

  private async load({ file, line, material, name }: TextureReference): Promise<DecodedImage | undefined> {
    const what = msg`${file}: line ${line}`;
    // Files copied from another machine often contain its absolute paths.
    const places = [...new Set([resolvePath(file, name), resolvePath(file, name.replace(/^.*[\\/]/, ''))])];
    for (const path of places) {
      const bytes = await this.context.source.read(path);
      if (!bytes) continue;
      try {
        return decodeImage(bytes, path);
      } catch (thrown) {
        if (!(thrown instanceof InputError)) throw thrown;
        this.context.notes.add('warning', 'file.unreadable-texture', what, msg`${thrown.text}; shown without it`);
        return undefined;
      }
    }
    const { code, message, missing } = missingTexture(name, places);
    this.context.notes.add('warning', code, msg`${what}, material ${material}`, message, { missing });
    return undefined;
  }
}
