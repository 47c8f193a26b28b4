import { join } from 'node:path';
import react from '@vitejs/plugin-react';
import { defineConfig, type Plugin } from 'vite';
import { examples, namesOfThumbnails } from './scripts/page/examples.ts';
import { fonts } from './scripts/page/fonts.ts';
import { offline } from './scripts/page/offline.ts';
import { ownDockTheme } from './scripts/page/ownDockTheme.ts';
import { root } from './scripts/page/root.ts';
import { weigh, weights } from './scripts/page/weights.ts';

// The tests build the page too, and what is served should always be what people get.
process.env.NODE_ENV = 'production';

/** The page, and the page without a screen that the command line drives. Nothing inline: it runs under `script-src 'self'`. */
export default defineConfig({
  root: join(root, 'src/app'),
  base: './',
  publicDir: false,
  define: { THUMBNAILS: JSON.stringify(namesOfThumbnails()) },
  plugins: [react(), examples(), fonts(), ownDockTheme(), ...offline(), weigh(), weights()],
  worker: {
    format: 'es',
    plugins: () => [withoutGpu(), weigh()],
    // Few scenes have pictures of radiance; by itself the bundler puts their readers beside small modules that all scenes need.
    rolldownOptions: {
      output: { codeSplitting: { groups: [{ name: 'radiance', test: /formats\/image\/(exr|readExr|radiance\/)/ }] } },
    },
  },
  build: {
    outDir: join(root, 'dist/app'),
    emptyOutDir: true,
    target: 'es2022',
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 2000,
    rolldownOptions: {
      input: { index: join(root, 'src/app/index.html'), headless: join(root, 'src/app/headless.html') },
    },
  },
});

/** The page's workers draw nothing on a GPU: without this each of them would ship its own copy of three. */
function withoutGpu(): Plugin {
  return {
    name: 'slowlight-workers-without-gpu',
    load: (id) => (/pipelines\/\w+\.gpu\.ts$/.test(id) ? 'throw new Error("no worker draws on a GPU");' : undefined),
  };
}
