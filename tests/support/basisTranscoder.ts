import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { runInThisContext } from 'node:vm';
import type { DecodedImage } from '../../src/formats/image/decodeImage.ts';

/** What is used of Basis Universal's transcoder, by its authors, which three.js ships. */
interface BasisModule {
  initializeBasis(): void;
  KTX2File: new (
    bytes: Uint8Array,
  ) => {
    isValid(): boolean;
    getWidth(): number;
    getHeight(): number;
    startTranscoding(): boolean;
    getImageTranscodedSizeInBytes(level: number, layer: number, face: number, format: number): number;
    transcodeImage(
      out: Uint8Array,
      level: number,
      layer: number,
      face: number,
      format: number,
      unused: number,
      channel0: number,
      channel1: number,
    ): boolean;
    close(): void;
    delete(): void;
  };
}
type MakeBasis = (options: { readonly wasmBinary: Uint8Array }) => Promise<BasisModule>;

const RGBA32 = 13;
const folder = join(dirname(createRequire(import.meta.url).resolve('three')), '../examples/jsm/libs/basis');
let loaded: Promise<BasisModule> | undefined;

async function load(): Promise<BasisModule> {
  const script = readFileSync(join(folder, 'basis_transcoder.js'), 'utf8');
  // A script for pages and for CommonJS.
  const run = runInThisContext(`(function (require, __dirname) { ${script}; return BASIS; })`);
  const make: MakeBasis = run(createRequire(import.meta.url), folder);
  const module = await make({ wasmBinary: readFileSync(join(folder, 'basis_transcoder.wasm')) });
  module.initializeBasis();
  return module;
}

/** A KTX 2.0 picture as the transcoder decodes it to RGBA; undefined if it refuses. */
export async function transcode(bytes: Uint8Array): Promise<DecodedImage | undefined> {
  loaded ??= load();
  const { KTX2File } = await loaded;
  const file = new KTX2File(bytes);
  try {
    if (!file.isValid() || !file.startTranscoding()) return undefined;
    const [width, height] = [file.getWidth(), file.getHeight()];
    const data = new Uint8Array(file.getImageTranscodedSizeInBytes(0, 0, 0, RGBA32));
    return file.transcodeImage(data, 0, 0, 0, RGBA32, 0, -1, -1) ? { width, height, data } : undefined;
  } finally {
    file.close();
    file.delete();
  }
}
