import { writeFileSync } from 'node:fs';
import type { Plugin, ResolvedConfig } from 'vite';

/** By file of the page, by part: code before it is minified [characters]. */
const sizes: Record<string, Record<string, number>> = {};

/** Notes of which packages and folders each file of the page consists; of the page's and of the workers' files. */
export function weigh(): Plugin {
  return {
    name: 'slowlight-weigh',
    generateBundle(_, bundle) {
      for (const chunk of Object.values(bundle)) {
        if (chunk.type !== 'chunk') continue;
        const parts: Record<string, number> = {};
        sizes[chunk.fileName] = parts;
        for (const [id, { renderedLength }] of Object.entries(chunk.modules)) {
          const part = partOf(id);
          parts[part] = (parts[part] ?? 0) + renderedLength;
        }
      }
    },
  };
}

/** Writes that beside the page, `dist/app.weights.json`, for the test that says what made the page heavier. */
export function weights(): Plugin {
  let config: ResolvedConfig;
  return {
    name: 'slowlight-weights',
    configResolved: (resolved) => {
      config = resolved;
    },
    closeBundle: () => writeFileSync(`${config.build.outDir}.weights.json`, JSON.stringify(sizes)),
  };
}

/** A package, all packages of an organization, or a folder of ours. */
function partOf(id: string): string {
  const [, name] = /node_modules\/(@?[^/]+)\/(?!.*node_modules\/)/.exec(id) ?? /\/(src\/\w+)\//.exec(id) ?? [];
  return name ?? 'bundler';
}
