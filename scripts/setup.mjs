// Prerequisites of `npm start`, `npm test` and `npm run bench`. Uses only Node's built-in modules, because it runs before
// `npm ci`. Every step checks first whether it is needed, so that repeated runs are fast.
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { delimiter, join, relative, sep } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('..', import.meta.url));
const at = (...parts) => join(root, ...parts);
export const say = (text) => console.log(`\x1b[2m·\x1b[0m ${text}`);

export class SetupError extends Error {}

/** Runs a program in the project folder with its output displayed; throws if it fails. */
export function run(command, args, options = {}) {
  const done = spawnSync(command, args, { cwd: root, stdio: 'inherit', ...options });
  if (done.error) throw new SetupError(`${command} could not be started: ${done.error.message}`);
  if (done.status !== 0)
    throw new SetupError(`\`${command} ${args.join(' ')}\` failed (exit ${done.status ?? done.signal}).`);
}

/** Runs a program silently; returns its output, or undefined if it is missing or fails. */
function ask(command, args) {
  const done = spawnSync(command, args, { cwd: root, encoding: 'utf8' });
  return done.error || done.status !== 0 ? undefined : done.stdout;
}

export function onPath(name) {
  const folders = (process.env.PATH ?? '').split(delimiter).filter(Boolean);
  return folders.map((folder) => join(folder, name)).find((path) => existsSync(path));
}

// ── Node and its packages ──────────────────────────────────────────────────────────────────────────────────────────

const minNode = [20, 19];

export function checkNode() {
  const [major, minor] = process.versions.node.split('.').map(Number);
  if (major > minNode[0] || (major === minNode[0] && minor >= minNode[1])) return;
  throw new SetupError(
    `Slowlight needs Node ${minNode.join('.')} or newer; this is ${process.versions.node}. See https://nodejs.org`,
  );
}

/** Compares npm's record of installed packages in a folder's node_modules with its package-lock.json. */
function modulesAreCurrent(folder) {
  const installedFile = join(folder, 'node_modules', '.package-lock.json');
  if (!existsSync(installedFile)) return false;
  const locked = JSON.parse(readFileSync(join(folder, 'package-lock.json'), 'utf8')).packages;
  const installed = JSON.parse(readFileSync(installedFile, 'utf8')).packages;
  return Object.entries(locked).every(
    ([path, { version, optional }]) => path === '' || optional || installed[path]?.version === version,
  );
}

export function ensureModules(folder = root) {
  if (modulesAreCurrent(folder)) return;
  say(`Installing packages (npm ci${folder === root ? '' : ` in ${relative(root, folder)}`}) …`);
  // On Windows npm is a .cmd file, which only a shell can start.
  run('npm', ['ci', '--include=dev', '--no-audit', '--no-fund'], { shell: process.platform === 'win32', cwd: folder });
}

// ── System packages ────────────────────────────────────────────────────────────────────────────────────────────────

/** Debian packages, each with another test for what it provides. */
const systemPackages = {
  chromium: () => process.env.CHROMIUM ?? onPath('chromium'),
  ffmpeg: () => onPath('ffmpeg'),
  libvulkan1: () => sharedLibrary('libvulkan.so.1'),
  'libegl-mesa0': () => sharedLibrary('libEGL_mesa.so.0'),
  'libgl1-mesa-dri': () => undefined,
};
/** Optional: for the tests against OpenUSD's own library. */
const oraclePackages = {
  python3: () => onPath('python3'),
  'python3-venv': () => ask('python3', ['-c', 'import ensurepip']),
};

let libraries;
function sharedLibrary(name) {
  libraries ??= ask('ldconfig', ['-p']) ?? ask('/sbin/ldconfig', ['-p']) ?? '';
  return libraries.includes(name);
}

const isDebian = () => onPath('apt-get') !== undefined && onPath('dpkg') !== undefined;
const isInstalled = (name) => (ask('dpkg', ['-s', name]) ?? '').includes('Status: install ok installed');

function missingPackages(required) {
  return Object.entries(required)
    .filter(([name, isThere]) => !isThere() && !isInstalled(name))
    .map(([name]) => name);
}

function installLine(names) {
  return `apt-get update && apt-get install -y --no-install-recommends ${names.join(' ')}`;
}

function aptInstall(names) {
  say(`Installing system packages (apt): ${names.join(' ')} …`);
  const env = { ...process.env, DEBIAN_FRONTEND: 'noninteractive' };
  run('apt-get', ['update', '-qq'], { env });
  run('apt-get', ['install', '-y', '-qq', '--no-install-recommends', ...names], { env });
}

/** Installs missing packages if permitted; otherwise prints the command to run. Returns the packages still missing. */
function ensurePackages(required, purpose) {
  if (process.platform !== 'linux') return otherSystem();
  if (!isDebian()) return otherSystem();
  const mayInstall = process.getuid?.() === 0;
  if (mayInstall && missingPackages(required).length > 0) aptInstall(missingPackages(required));
  const missing = missingPackages(required);
  if (missing.length > 0) {
    const line = installLine(missing);
    say(`Missing system packages, ${purpose}. Run once:\n\n    ${mayInstall ? line : `sudo sh -c '${line}'`}\n`);
  }
  return missing;
}

function otherSystem() {
  const missing = ['chromium', 'ffmpeg'].filter((name) => !systemPackages[name]());
  if (missing.length > 0) {
    say(`Not a Debian-like system. Please install ${missing.join(' and ')} (CHROMIUM may name the browser's program).`);
  }
  return missing;
}

export const ensureSystem = (purpose) => ensurePackages(systemPackages, purpose);

// ── The build ──────────────────────────────────────────────────────────────────────────────────────────────────────

const apiFiles = ['README.md', 'build.mjs', 'package-lock.json'];
const products = {
  lib: {
    title: 'the library and the command line',
    inputs: ['src', 'tsconfig.json', 'tsconfig.build.json'],
    clean: ['lib', 'lib.tsbuildinfo'],
    build: () => run(process.execPath, [at('node_modules/typescript/bin/tsc'), '-p', 'tsconfig.build.json']),
  },
  app: {
    title: 'the page',
    inputs: ['src', 'examples', 'lessons', 'scripts/page', 'vite.config.ts', 'tsconfig.json'],
    clean: [],
    build: () => run(process.execPath, [at('node_modules/vite/bin/vite.js'), 'build', '--logLevel', 'error']),
  },
  api: {
    title: "the pages of the library's API",
    inputs: ['src', 'package.json', 'tsconfig.build.json', ...apiFiles.map((name) => `docs/api/${name}`)],
    clean: ['api'],
    build() {
      ensureModules(at('docs/api'));
      run(process.execPath, [at('docs/api/build.mjs')]);
    },
  },
};
const stampFile = at('dist', '.stamps.json');

function* filesUnder(path) {
  if (!existsSync(path)) return;
  const entries = readdirSync(path, { withFileTypes: true }).sort((a, b) => (a.name < b.name ? -1 : 1));
  for (const entry of entries) {
    const child = join(path, entry.name);
    if (entry.isDirectory()) yield* filesUnder(child);
    else yield child;
  }
}

/** Hash of the inputs' names and contents; time stamps are not included, since a fresh checkout changes them. */
function fingerprint(inputs) {
  const hash = createHash('sha256');
  for (const input of [...inputs, 'package-lock.json', 'scripts/setup.mjs']) {
    const path = at(input);
    const files = /\.\w+$/.test(input) ? [path].filter((file) => existsSync(file)) : filesUnder(path);
    for (const file of files) {
      if (/\.test\.tsx?$/.test(file)) continue;
      hash.update(file.slice(root.length).split(sep).join('/')).update('\0').update(readFileSync(file)).update('\0');
    }
  }
  return hash.digest('hex');
}

const readStamps = () => (existsSync(stampFile) ? JSON.parse(readFileSync(stampFile, 'utf8')) : {});

/** Builds the parts whose inputs have changed. */
export function ensureBuilt(...names) {
  for (const name of names) {
    const { title, inputs, clean, build } = products[name];
    const stamp = fingerprint(inputs);
    if (readStamps()[name] === stamp) continue;
    say(`Building ${title} …`);
    for (const path of clean) rmSync(at('dist', path), { recursive: true, force: true });
    build();
    mkdirSync(at('dist'), { recursive: true });
    writeFileSync(stampFile, JSON.stringify({ ...readStamps(), [name]: stamp }));
  }
}

// ── Independent judges of our files and figures, for tests ─────────────────────────────────────────────────────────

const judges = [
  'usd-core==26.11',
  'OpenEXR==3.4.4',
  'numpy==2.3.5',
  'flip-evaluator==1.7',
  'colour-science==0.4.7',
  'MaterialX==1.39.5',
];

/** Folder of the Python with the oracle packages, in .cache/, never in the system; undefined, with a message, if it cannot be made. */
export function ensureOracle() {
  const folder = at('.cache', 'venv', process.platform === 'win32' ? 'Scripts' : 'bin');
  const python = join(folder, 'python3');
  // Installed versions: those of an earlier state of the project may give other results.
  const list = at('.cache', 'venv', 'judges.txt');
  const hasJudges = () =>
    existsSync(list) &&
    readFileSync(list, 'utf8') === judges.join('\n') &&
    ask(python, ['-c', 'import pxr.Usd, OpenEXR, numpy, flip_evaluator, colour, MaterialX']) !== undefined;
  if (hasJudges()) return folder;
  try {
    if (ensurePackages(oraclePackages, 'for the optional tests against other programs').length > 0) return undefined;
    say(`Installing ${judges.join(', ')} into .cache/venv (the judges of our files) …`);
    run('python3', ['-m', 'venv', at('.cache', 'venv')]);
    run(python, ['-m', 'pip', 'install', '--quiet', '--disable-pip-version-check', ...judges]);
    writeFileSync(list, judges.join('\n'));
    return hasJudges() ? folder : undefined;
  } catch (error) {
    if (!(error instanceof SetupError)) throw error;
    say(error.message);
    return undefined;
  }
}
