import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Plugin } from 'vite';
import { VitePWA } from 'vite-plugin-pwa';
import { root } from './root.ts';

/** Icons of the installed program: `npm run pictures -- icons`. */
const ICONS = ['icon-192.png', 'icon-512.png', 'icon-maskable-512.png'];

/** The icons of the installed program. */
function icons(): Plugin {
  return {
    name: 'slowlight-icons',
    generateBundle() {
      for (const file of ICONS)
        this.emitFile({
          type: 'asset',
          fileName: `icons/${file}`,
          source: readFileSync(join(root, 'src/app/icons', file)),
        });
    },
  };
}

/** The page without a network, and as an installed program: docs/adr/0056-offline.md. */
export function offline(): Plugin[] {
  const kept = VitePWA({
    strategies: 'injectManifest',
    srcDir: '.',
    filename: 'serviceWorker.ts',
    injectRegister: false,
    injectManifest: {
      globPatterns: ['**/*'],
      // What the command line opens, and typefaces of solid letters, which are read from the network when they are met.
      globIgnores: ['headless.html', 'assets/headless-*', 'fonts/**', 'serviceWorker.js'],
      dontCacheBustURLsMatching: /^assets\//,
      maximumFileSizeToCacheInBytes: 2 ** 23,
      rollupFormat: 'iife',
      // The build of the worker says no more than that of the page.
      buildPlugins: { vite: [{ name: 'slowlight-quiet-worker', config: () => ({ logLevel: 'error' }) }] },
    },
    manifest: {
      name: 'Slowlight',
      short_name: 'Slowlight',
      description: 'See special relativity as it truly looks.',
      lang: 'en',
      categories: ['education', 'graphics'],
      start_url: './',
      scope: './',
      display: 'standalone',
      background_color: '#1b2029',
      theme_color: '#1b2029',
      icons: ICONS.map((file) => ({
        src: `icons/${file}`,
        sizes: file.replace(/\D+(\d+).*/, '$1x$1'),
        type: 'image/png',
        purpose: file.includes('maskable') ? 'maskable' : 'any',
      })),
    },
  });
  return [icons(), ...kept];
}
