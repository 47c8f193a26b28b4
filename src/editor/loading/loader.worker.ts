import { openScene } from '../../formats/open.ts';
import type { FileSource } from '../../formats/source.ts';
import type { LoadedScene } from '../../nodes/services.ts';
import { InputError } from '../../scene/types.ts';
import type { LoaderReply, SceneFiles, Stage } from './protocol.ts';
import { localSource, urlSource } from './sources.ts';
import { loadedScene } from './survey.ts';
import { transferables } from './transfer.ts';

/** Reads one scene off the main thread; its arrays are handed over, not copied. */
addEventListener('message', async ({ data }: MessageEvent<SceneFiles>) => {
  try {
    const loaded = await load(data);
    reply({ kind: 'done', loaded }, transferables(loaded));
  } catch (error) {
    const message = error instanceof Error ? error.message : String(error);
    reply({ kind: 'failed', message, diagnostic: error instanceof InputError ? error.diagnostic : undefined });
  }
});

async function load(request: SceneFiles): Promise<LoadedScene> {
  const progress = (stage: Stage, part: number) => reply({ kind: 'progress', stage, part });
  const source = sourceOf(request, (received, total) =>
    progress(received < total ? 'fetch' : 'parse', received / total),
  );
  return loadedScene(await openScene(source, request.entry));
}

function sourceOf(request: SceneFiles, report: (received: number, total: number) => void): FileSource {
  return request.kind === 'url' ? urlSource(request.base, report) : localSource(new Map(request.files));
}

const reply = (message: LoaderReply, transfer: ArrayBuffer[] = []): void => postMessage(message, { transfer });
