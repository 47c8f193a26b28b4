import { listed, type Message, msg } from '../../../../messages/message.ts';
import { messageOf } from '../../../../messages/messageError.ts';
import type { MissingFile } from '../../../../scene/types.ts';
import type { FileContent } from '../../../files/rangedFile.ts';
import type { AssetFiles } from '../../assets/assetFiles.ts';
import type { Layer, PrimSpec } from '../../layer/layer.ts';
import { pseudoRoot } from '../../layer/primPaths.ts';
import { metadataNumber } from '../../layer/query.ts';

/** A loaded layer. */
export interface LoadedLayer {
  /** Its identifier among the stage's files. */
  readonly id: string;
  readonly layer: Layer;
  readonly root: PrimSpec;
  readonly codesPerSecond: number;
  /** The session layer, with the user's selections; it adds no prims. */
  readonly isSession: boolean;
}

/** Why a layer could not be loaded. */
export interface LayerError {
  readonly code: 'usd.missing-layer' | 'usd.unreadable-layer' | 'usd.too-many-layers';
  readonly message: Message;
  /** If it is missing. */
  readonly missing?: MissingFile;
}

/** Maximum number of layers of a scene. */
export const MAX_LAYERS = 4096;

export type ParseLayer = (content: FileContent, id: string) => Layer | Promise<Layer>;

/** The layers of a stage, each read once. `find` is synchronous: it returns `undefined` for a new layer, which is there after the next `load`. */
export class LayerStore {
  readonly files: AssetFiles;
  private readonly parse: ParseLayer;
  private readonly byId = new Map<string, LoadedLayer | LayerError>();
  private readonly byReference = new Map<string, LoadedLayer | LayerError>();
  private readonly wanted = new Map<string, readonly [anchor: string, asset: string]>();
  /** Number of prim and property specs in the layers. */
  specs = 0;

  constructor(files: AssetFiles, parse: ParseLayer) {
    this.files = files;
    this.parse = parse;
  }

  get isComplete(): boolean {
    return this.wanted.size === 0;
  }

  /** The layer `asset` relative to `anchor`. */
  find(anchor: string, asset: string): LoadedLayer | LayerError | undefined {
    const key = `${anchor}\n${asset}`;
    const found = this.byReference.get(key);
    if (!found) this.wanted.set(key, [anchor, asset]);
    return found;
  }

  /** Loads all requested layers. */
  async load(): Promise<void> {
    for (const [key, [anchor, asset]] of [...this.wanted]) {
      this.byReference.set(key, await this.open(anchor, asset));
      this.wanted.delete(key);
    }
  }

  private async open(anchor: string, asset: string): Promise<LoadedLayer | LayerError> {
    if (this.byId.size >= MAX_LAYERS)
      return {
        code: 'usd.too-many-layers',
        message: msg`@${asset}@ is layer ${MAX_LAYERS + 1} of the scene; so many are read`,
      };
    try {
      const found = await this.files.find(anchor, asset);
      if (found) return await this.layer(found.id, found.content);
    } catch (thrown) {
      return unreadable(asset, thrown);
    }
    const lookedFor = this.files.candidates(anchor, asset);
    const message = msg`@${asset}@ is not there (looked for ${listed(lookedFor)}); open the folder that holds it`;
    return { code: 'usd.missing-layer', message, missing: { name: asset, lookedFor } };
  }

  private async layer(file: string, content: FileContent): Promise<LoadedLayer | LayerError> {
    const { id, content: inside } = await this.files.layerIn(file, content);
    const known = this.byId.get(id);
    if (known) return known;
    const layer = await this.parsed(inside, id);
    this.byId.set(id, layer);
    return layer;
  }

  private async parsed(content: FileContent, id: string): Promise<LoadedLayer | LayerError> {
    try {
      return this.counted(loadedLayer(await this.parse(content, id), id));
    } catch (thrown) {
      return unreadable(id, thrown);
    }
  }

  private counted(layer: LoadedLayer): LoadedLayer {
    this.specs += specsIn(layer.root);
    return layer;
  }

  /** The root layer; throws if it is invalid. */
  async root(entry: string, content: FileContent): Promise<LoadedLayer> {
    const { id, content: inside } = await this.files.layerIn(entry, content);
    const root = this.counted(loadedLayer(await this.parse(inside, id), id));
    this.byId.set(id, root);
    return root;
  }
}

function specsIn({ children, properties, variantSets }: PrimSpec): number {
  let count = 1 + properties.size;
  for (const child of children.values()) count += specsIn(child);
  for (const variants of variantSets.values()) for (const variant of variants.values()) count += specsIn(variant);
  return count;
}

export const isLayerError = (found: LoadedLayer | LayerError): found is LayerError => 'code' in found;

const unreadable = (asset: string, thrown: unknown): LayerError => ({
  code: 'usd.unreadable-layer',
  message: msg`@${asset}@ cannot be read: ${messageOf(thrown)}`,
});

export function loadedLayer(layer: Layer, id: string, isSession = false): LoadedLayer {
  const number = (key: string): number | undefined => metadataNumber(layer.metadata, key);
  const codesPerSecond = number('timeCodesPerSecond') ?? number('framesPerSecond') ?? 24;
  return { id, layer, root: pseudoRoot(layer), codesPerSecond, isSession };
}
