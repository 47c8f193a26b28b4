import { msg } from '../../../messages/message.ts';
import { inputError } from '../../diagnostics/inputError.ts';
import { type FileSource, normalizePath, resolvePath } from '../../files/fileSource.ts';
import { contentBytes, contentHead, type FileContent } from '../../files/rangedFile.ts';
import { IDENT_BYTES, isCrate } from '../crate/structure/bootstrap.ts';
import { isZip, openPackage, type UsdzPackage } from './usdz.ts';

/** Maximum nesting of packages. */
const MAX_NESTING = 4;

/**
 * The files that a stage is made of, by identifiers: `a/b.usda`, or `a/c.usdz[d/e.png]` inside a package. Paths are
 * relative to the folder of the FileSource.
 */
export class AssetFiles {
  private readonly source: FileSource;
  private readonly minRangedBytes: number;
  private readonly packages = new Map<string, UsdzPackage>();
  /** Folder of the root layer, searched last for paths that do not begin with `./`. */
  private searchFolder = '';

  /** Crates and packages of more than `minRangedBytes` bytes are read in parts, where the source can do that. */
  constructor(source: FileSource, entry: string, minRangedBytes = Number.POSITIVE_INFINITY) {
    this.source = source;
    this.minRangedBytes = minRangedBytes;
    this.searchFolder = entry;
  }

  /** The file's bytes; undefined where there is none. Throws an InputError where a package around it is damaged. */
  async read(id: string): Promise<Uint8Array | undefined> {
    const content = await this.content(id);
    return content && contentBytes(content);
  }

  /** The same; of a large crate or package what is needed to read parts of it. */
  async content(id: string): Promise<FileContent | undefined> {
    const { outer, inner } = splitId(id);
    if (inner !== undefined) return (await this.package(outer))?.files.get(inner);
    const ranged = this.minRangedBytes < Number.POSITIVE_INFINITY ? await this.source.open?.(outer) : undefined;
    if (
      ranged &&
      ranged.size > this.minRangedBytes &&
      (isZip(contentHead(ranged, 4)) || isCrate(contentHead(ranged, IDENT_BYTES)))
    )
      return ranged;
    return this.source.read(outer);
  }

  /** The layer that a file stands for: itself, or the first one of a package, which may be a package again. */
  async layerIn(id: string, content: FileContent): Promise<{ id: string; content: FileContent }> {
    if (!isZip(contentHead(content, 4))) return { id, content };
    const inner = `${id}[${this.opened(id, content).layer}]`;
    const inside = await this.content(inner);
    if (inside) return this.layerIn(inner, inside);
    throw inputError('usd.package', id, msg`packages are nested more than ${MAX_NESTING} deep in it`);
  }

  private async package(id: string): Promise<UsdzPackage | undefined> {
    if (id.split('[').length > MAX_NESTING) return undefined;
    const content = this.packages.has(id) ? NO_BYTES : await this.content(id);
    return content && this.opened(id, content);
  }

  private opened(id: string, content: FileContent): UsdzPackage {
    const found = this.packages.get(id) ?? openPackage(content, id);
    this.packages.set(id, found);
    return found;
  }

  /**
   * Where the asset that `anchor` calls `asset` may be, best first: beside the layer that names it; then, for a path
   * that does not begin with `./` or `../`, in the root of the layer's package or the root layer's folder.
   */
  candidates(anchor: string, asset: string): string[] {
    const [path, ...inner] = withoutArguments(asset).split('[');
    const inside = inner.map((part) => `[${normalizePath(part.replaceAll(']', ''))}`).join('');
    const ends = inside === '' ? '' : inside + ']'.repeat(inner.length);
    const { outer, inner: layer } = splitId(anchor);
    const searched = !/^\.{0,2}[/\\]/.test(path);
    const found =
      layer === undefined
        ? [resolvePath(outer, path), ...(searched ? [resolvePath(this.searchFolder, path)] : [])]
        : [resolvePath(layer, path), ...(searched ? [normalizePath(path)] : [])].map((p) => `${outer}[${p}]`);
    return [...new Set(found)].map((id) => id + ends);
  }

  /** The first existing candidate, with its bytes. */
  async findBytes(anchor: string, asset: string): Promise<{ id: string; bytes: Uint8Array } | undefined> {
    const found = await this.find(anchor, asset);
    return found && { id: found.id, bytes: contentBytes(found.content) };
  }

  /** The first existing candidate, with its contents. */
  async find(anchor: string, asset: string): Promise<{ id: string; content: FileContent } | undefined> {
    for (const id of this.candidates(anchor, asset)) {
      const content = await this.content(id);
      if (content) return { id, content };
    }
    return undefined;
  }
}

const NO_BYTES = new Uint8Array(0);

/** `a.usd:SDF_FORMAT_ARGS:x=y` → `a.usd`. */
const withoutArguments = (asset: string): string => asset.split(':SDF_FORMAT_ARGS:')[0];

/** `a[b[c]]` → `a[b]` and `c`; the inner part is missing where there is no package. */
function splitId(id: string): { outer: string; inner?: string } {
  const open = id.lastIndexOf('[');
  if (open < 0 || !id.endsWith(']')) return { outer: id };
  const depth = id.length - id.trimEnd().length + id.slice(open).split(']').length - 1;
  return { outer: id.slice(0, open) + ']'.repeat(depth - 1), inner: id.slice(open + 1, id.length - depth) };
}
