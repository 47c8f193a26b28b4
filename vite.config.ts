import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import react from '@vitejs/plugin-react';
import { defineConfig, type Plugin } from 'vite';
import { VitePWA } from 'vite-plugin-pwa';
import type { Example } from './src/editor/loading/examples.ts';
import { FONTS, fontFile } from './src/formats/font/glyphs.ts';
import { readLayer } from './src/formats/usd/readLayer.ts';
import { hintsOf } from './src/formats/usd/schema/slowlightAttributes.ts';

// The tests build the page too, and what is served should always be what people get.
process.env.NODE_ENV = 'production';

const root = fileURLToPath(new URL('.', import.meta.url));
const examplesFolder = join(root, 'examples');
/** The order of the gallery: from what everybody knows to what needs a thought. Others follow by name. */
const GALLERY = [
  'street',
  'dice',
  'wheel',
  'starfield',
  'lamps',
  'sphere',
  'lattice',
  'prism',
  'sunset',
  'hall',
  'saturn',
  'gallery',
  'ladder',
  'cubes',
  'arcade',
  'boxes',
  'drops',
  'plain',
  'rush',
  'captured',
  'texture-cube',
  'texture-hall',
  'texture-interior',
  'clocks-around',
  'boxes-892',
  'boxes-949',
  'boxes-968',
  'comparison',
  'layers',
  'lesson',
  'gods-eye',
  'letters',
  'truth',
  'workshop',
];
/** Icons of the installed program: `npm run pictures -- icons`. */
const ICONS = ['icon-192.png', 'icon-512.png', 'icon-maskable-512.png'];
const SCENES = ['.usda', '.usdc'];
const isProject = (file: string): boolean => file.endsWith('.slowlight.json');
const SHIPPED = [...SCENES, '.png', '.webp', '.exr', '.mp4'];

/** The page, and the page without a screen that the command line drives. Nothing inline: it runs under `script-src 'self'`. */
export default defineConfig({
  root: join(root, 'src/app'),
  base: './',
  publicDir: false,
  define: { THUMBNAILS: JSON.stringify(namesOfThumbnails()) },
  plugins: [react(), examples(), fonts(), icons(), ownDockTheme(), ...offline()],
  worker: {
    format: 'es',
    plugins: () => [withoutGpu()],
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

/** Ships examples/ beside the page, with an index of what to look for, taken from the scenes' own hints. */
function examples(): Plugin {
  return {
    name: 'slowlight-examples',
    generateBundle() {
      const files = filesIn(examplesFolder, '').filter((file) => SHIPPED.includes(extname(file)) || isProject(file));
      for (const file of files) {
        const source = readFileSync(join(examplesFolder, file));
        this.emitFile({ type: 'asset', fileName: `examples/${file}`, source });
      }
      const scenes = files.filter((file) => !file.includes('/') && SCENES.includes(extname(file)));
      const shown = [...scenes.map(describe), ...files.filter(isProject).map(describeProject)];
      const index = shown.sort((a, b) => placeOf(a) - placeOf(b));
      this.emitFile({ type: 'asset', fileName: 'examples/index.json', source: JSON.stringify(index) });
    },
  };
}

/** Ships the fonts of solid letters beside the page, which reads the files that it needs; and their licences. */
function fonts(): Plugin {
  return {
    name: 'slowlight-fonts',
    generateBundle() {
      for (const { name, weight } of FONTS) {
        const folder = join(root, 'node_modules/@fontsource', name);
        const subsets = Object.keys(JSON.parse(readFileSync(join(folder, 'unicode.json'), 'utf8')));
        const files = subsets.map((subset) => fontFile({ name, weight }, subset));
        for (const file of ['LICENSE', 'unicode.json', ...files])
          this.emitFile({ type: 'asset', fileName: `fonts/${name}/${file}`, source: readFileSync(join(folder, file)) });
      }
    },
  };
}

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
function offline(): Plugin[] {
  return VitePWA({
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
}

/** Themes of the dock, and parts that this page's dock does not have: floating groups, pane views, pinned and grouped tabs, menus of tabs. */
const UNUSED_OF_DOCK =
  /dockview-theme-|\.dv-(?:pane|pinned|debug|floating-titlebar|resize-container|edge-peek|context-menu|tab-group-chip)/;

/** Dockview ships all its themes and parts in one sheet; the page has a theme of its own, and few of the parts. */
function ownDockTheme(): Plugin {
  return {
    name: 'slowlight-own-dock-theme',
    transform(code, id) {
      if (!/dockview\.css/.test(id)) return undefined;
      const rules = code.match(/[^{}]*\{(?:[^{}]|\{[^{}]*\})*\}/g) ?? [];
      const isUnused = (rule: string): boolean =>
        rule
          .replace(/\/\*.*?\*\//gs, '')
          .split('{')[0]!
          .split(',')
          .every((selector) => UNUSED_OF_DOCK.test(selector));
      return rules.filter((rule) => !isUnused(rule)).join('');
    },
  };
}

function filesIn(folder: string, prefix: string): string[] {
  if (!existsSync(folder)) return [];
  return readdirSync(folder, { withFileTypes: true })
    .sort((a, b) => (a.name < b.name ? -1 : 1))
    .flatMap((entry) =>
      entry.isDirectory() ? filesIn(join(folder, entry.name), `${prefix}${entry.name}/`) : [prefix + entry.name],
    );
}

function describe(file: string): Example {
  const name = file.slice(0, -extname(file).length);
  const { title = name, lookFor = '' } = hintsOf(readLayer(readFileSync(join(examplesFolder, file)), file));
  return { source: `examples/${file}`, name, title, lookFor, ...thumbnailOf(name) };
}

function describeProject(file: string): Example {
  const name = file.replace('.slowlight.json', '');
  const { title = name, lookFor = '' } = JSON.parse(readFileSync(join(examplesFolder, file), 'utf8'));
  return { source: `examples/${file}`, name, title, lookFor, ...thumbnailOf(name) };
}

function thumbnailOf(name: string): Pick<Example, 'thumbnail'> {
  const thumbnail = `thumbnails/${name}.webp`;
  return existsSync(join(examplesFolder, thumbnail)) ? { thumbnail: `examples/${thumbnail}` } : {};
}

function namesOfThumbnails(): readonly string[] {
  return filesIn(join(examplesFolder, 'thumbnails'), '').map((file) => file.slice(0, -extname(file).length));
}

const placeOf = ({ name }: Example): number => (GALLERY.includes(name) ? GALLERY.indexOf(name) : GALLERY.length);
